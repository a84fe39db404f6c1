#include "import/svg/svg_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "import/svg/svg_text.hpp"

namespace tumble::scene {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool is_positive(DVec2 size) { return size.x > 0.0 && size.y > 0.0; }

// NaN for a missing length, "auto", and a part of a window, as its size is not known.
double read_size(const pugi::xml_attribute& attribute) {
    const std::string_view text = trimmed(attribute.value());
    return text.empty() || text == "auto" || text.ends_with('%') ? kUnknown : parse_length(text, kUnknown);
}

// A missing width or height follows from the other one.
DVec2 scale_of(DVec2 page, DVec2 box, std::string_view aspect) {
    DVec2 scale{page.x / box.x, page.y / box.y};
    if (!(scale.x > 0.0)) scale.x = scale.y;
    if (!(scale.y > 0.0)) scale.y = scale.x;
    if (!is_positive(scale) || !std::isfinite(scale.x) || !std::isfinite(scale.y)) return {1.0, 1.0};
    if (aspect.starts_with("none")) return scale;
    const double both = aspect.ends_with("slice") ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    return {both, both};
}

}  // namespace

SvgPage read_svg_page(const pugi::xml_node& root) {
    const DVec2 stated{read_size(root.attribute("width")), read_size(root.attribute("height"))};
    SvgPage page{{}, stated};
    if (const std::string_view box = trimmed(root.attribute("viewBox").value()); !box.empty()) {
        SvgScanner scanner(box);
        for (double* value : {&page.corner.x, &page.corner.y, &page.size.x, &page.size.y}) *value = scanner.number();
        if (is_positive(page.size))
            page.pixels_per_unit = scale_of(stated, page.size, trimmed(root.attribute("preserveAspectRatio").value()));
    }
    if (!is_positive(page.size)) page.size = {kUnknown, kUnknown};
    return page;
}

}  // namespace tumble::scene
