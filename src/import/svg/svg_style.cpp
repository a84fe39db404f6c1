// The cascade of CSS 2 without combinators, !important and media rules, which drawings hardly use.
#include "import/svg/svg_style.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "import/svg/svg_color.hpp"
#include "import/svg/svg_text.hpp"
#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

constexpr std::array<std::pair<std::string_view, BodyType>, 3> kTypeWords{
    {{"static", BodyType::static_body}, {"kinematic", BodyType::kinematic_body}, {"dynamic", BodyType::dynamic_body}}};

// The size that a stroke width in percent refers to. Drawing programs do not write such widths, so they are an error.
constexpr double kUnknownSize = std::numeric_limits<double>::quiet_NaN();

// Calls visit(part) for the parts between separators, trimmed, empty ones left out.
template <class Visit>
void split(std::string_view text, char separator, Visit visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        if (const std::string_view part = trimmed(text.substr(0, end)); !part.empty()) visit(part);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

// Calls visit(name, value) for the declarations "name: value; ...".
template <class Visit>
void visit_declarations(std::string_view text, Visit visit) {
    split(text, ';', [&](std::string_view declaration) {
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) return;
        visit(trimmed(declaration.substr(0, colon)), trimmed(declaration.substr(colon + 1)));
    });
}

std::string without_comments(std::string_view text) {
    std::string result;
    while (true) {
        const std::size_t begin = text.find("/*");
        result += text.substr(0, begin);
        if (begin == std::string_view::npos) return result;
        const std::size_t end = text.find("*/", begin + 2);
        if (end == std::string_view::npos) return result;
        text.remove_prefix(end + 2);
    }
}

bool is_simple_selector(std::string_view selector) {
    return selector.find_first_of(" \t\r\n>+~:[*@", 0) == std::string_view::npos &&
           selector.find_first_of(".#", 1) == std::string_view::npos;
}

SvgPaint make_paint(std::string_view value, const SvgPaint& around, int& gradients) {
    if (value.empty() || value == "inherit") return around;
    if (value == "none" || value == "transparent") return {};
    if (const std::optional<SvgColor> color = parse_color(value)) return {true, color->rgb, color->alpha};
    if (value.starts_with("url(")) ++gradients;
    return {true, ""};
}

std::optional<BodyType> find_type(std::string_view word) {
    for (const auto& [name, type] : kTypeWords)
        if (word == name) return type;
    return std::nullopt;
}

// From data-type, otherwise from a class, otherwise from the beginning of the label or id.
std::optional<BodyType> read_type(const pugi::xml_node& element) {
    const std::string_view wanted = element.attribute("data-type").value();
    if (!wanted.empty()) {
        if (const auto type = find_type(trimmed(wanted))) return type;
        throw SvgError("data-type must be static, kinematic or dynamic, got " + quoted(std::string(wanted)));
    }
    std::optional<BodyType> result;
    split(element.attribute("class").value(), ' ', [&](std::string_view name) {
        if (const auto type = find_type(name)) result = type;
    });
    for (const auto& [name, type] : kTypeWords)
        if (!result && (label_of(element).starts_with(name) ||
                        std::string_view(element.attribute("id").value()).starts_with(name)))
            result = type;
    return result;
}

}  // namespace

int SvgSheet::add(std::string_view given) {
    const std::string clean = without_comments(given);
    std::string_view text = clean;
    int left_out = 0;
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{')) {
        const std::size_t close = std::min(text.find('}', open), text.size());
        split(text.substr(0, open), ',', [&](std::string_view selector) {
            if (!is_simple_selector(selector)) {
                ++left_out;
                return;
            }
            visit_declarations(text.substr(open + 1, close - open - 1),
                               [&](std::string_view name, std::string_view value) {
                                   rules_[std::string(selector)][std::string(name)] = value;
                               });
        });
        text.remove_prefix(std::min(close + 1, text.size()));
    }
    return left_out;
}

std::string_view SvgSheet::find(const pugi::xml_node& element, std::string_view property) const {
    if (rules_.empty()) return {};
    std::string_view result;
    const auto look_up = [&](const std::string& selector) {
        const auto rule = rules_.find(selector);
        if (rule == rules_.end()) return;
        if (const auto found = rule->second.find(property); found != rule->second.end()) result = found->second;
    };
    look_up(element.name());
    split(element.attribute("class").value(), ' ', [&](std::string_view name) { look_up('.' + std::string(name)); });
    look_up('#' + std::string(element.attribute("id").value()));
    return result;
}

std::string_view find_property(const pugi::xml_node& element, const SvgSheet& sheet, std::string_view property) {
    std::string_view result;
    visit_declarations(element.attribute("style").value(), [&](std::string_view name, std::string_view value) {
        if (name == property) result = value;
    });
    if (result.empty()) result = sheet.find(element, property);
    return result.empty() ? trimmed(element.attribute(std::string(property).c_str()).value()) : result;
}

SvgStyle read_style(const pugi::xml_node& element, const SvgSheet& sheet, const SvgStyle& around, int& gradients) {
    const auto property = [&](std::string_view name) { return find_property(element, sheet, name); };
    SvgStyle style = around;
    style.fill = make_paint(property("fill"), around.fill, gradients);
    style.stroke = make_paint(property("stroke"), around.stroke, gradients);
    if (const auto width = property("stroke-width"); !width.empty() && width != "inherit")
        style.stroke_width = parse_length(width, kUnknownSize);
    const auto read_opacity = [&](std::string_view name, double missing) {
        return parse_opacity(property(name)).value_or(missing);
    };
    style.fill_opacity = read_opacity("fill-opacity", around.fill_opacity);
    style.stroke_opacity = read_opacity("stroke-opacity", around.stroke_opacity);
    style.opacity = around.opacity * read_opacity("opacity", 1.0);
    if (const auto rule = property("fill-rule"); !rule.empty() && rule != "inherit") style.even_odd = rule == "evenodd";
    const std::string_view visibility = property("visibility");
    if (visibility == "visible") style.visible = true;
    if (visibility == "hidden" || visibility == "collapse") style.visible = false;
    if (const auto type = read_type(element)) style.type = type;
    return style;
}

SvgStyle with_opacity(const SvgStyle& style, int& mixed) {
    SvgStyle result = style;
    bool is_mixed = false;
    const auto apply = [&](SvgPaint& paint, double opacity) {
        const double alpha = style.opacity * opacity * paint.alpha;
        if (!(alpha > 0.0)) paint.visible = false;
        if (!paint.visible || alpha >= 1.0) return;
        if (!paint.color.empty()) paint.color = mixed_with_white(paint.color, alpha);
        is_mixed = true;
    };
    apply(result.fill, style.fill_opacity);
    apply(result.stroke, style.stroke_opacity);
    mixed += is_mixed ? 1 : 0;
    return result;
}

std::string_view label_of(const pugi::xml_node& element) {
    const std::string_view label = trimmed(element.attribute("inkscape:label").value());
    return label.empty() ? element.attribute("id").value() : label;
}

}  // namespace tumble::scene
