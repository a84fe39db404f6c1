#include "render/style/palette.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "debug/check.hpp"
#include "render/style/style.hpp"

namespace tumble::render {
namespace {

// The name without digits and separators at its end, and without the prefix of an included part: "crate_12", "crate[3]"
// and "left/crate" give "crate".
std::string_view stem(std::string_view name) {
    name.remove_prefix(name.rfind('/') + 1);  // npos + 1 is 0
    const std::size_t end = name.find_last_not_of("0123456789[]_-. ");
    return name.substr(0, end == std::string_view::npos ? name.size() : end + 1);
}

// Assigns the palette's colours to names in the order of the calls. Each body without a name gets a colour of its own.
class HueOrder {
public:
    explicit HueOrder(const Colors& colors) : colors_(colors) {}

    Color next(std::string_view name) {
        if (name.empty()) return take();
        const std::string_view key = stem(name);
        const auto [entry, is_new] = hues_.try_emplace(key);
        if (is_new) entry->second = take();
        return entry->second;
    }

private:
    Color take() { return colors_.bodies[taken_++ % colors_.bodies.size()]; }

    const Colors& colors_;
    std::map<std::string_view, Color> hues_;
    std::size_t taken_ = 0;
};

std::uint32_t built_shapes(const SceneShape& shape, std::uint32_t other) {
    if (const auto* chain = std::get_if<ChainGeometry>(&shape.geometry))
        return static_cast<std::uint32_t>(chain->points.size()) - (chain->loop ? 0u : 1u);
    return std::holds_alternative<OutlineGeometry>(shape.geometry) ? other : 1u;
}

std::optional<Color> material_color(const Scene& scene, const std::string& name) {
    if (name.empty()) return std::nullopt;
    for (const SceneMaterial& material : scene.materials)
        if (material.name == name) return parse_color(material.color);
    return std::nullopt;
}

// Lighter or darker by a share that looks random but is the same in every run; 0 for the first copy.
Color shaded(Color fill, std::size_t ordinal, const Colors& colors) {
    const std::uint32_t scrambled = static_cast<std::uint32_t>(ordinal) * 2654435769u;  // 2^32 / golden ratio
    const double share = style::kInstanceShade * (scrambled / 4294967296.0 - 0.5) * (ordinal == 0 ? 0.0 : 2.0);
    return share > 0.0 ? mix(fill, colors.tint, share) : mix(fill, colors.shade, -share);
}

}  // namespace

Color outline_of(Color fill, const Colors& colors) {
    // Rec. 601 luma. On a dark fill a darker outline would not be visible.
    const double luma = (0.299 * fill.r + 0.587 * fill.g + 0.114 * fill.b) / 255.0;
    return mix(fill, luma < colors.least_luma ? colors.tint : colors.shade, colors.outline_share);
}

Palette::Palette(const Scene& scene, const Colors& colors) : colors_(colors) {
    HueOrder hues(colors);
    sources_.reserve(scene.bodies.size() + scene.timeline.size());
    const auto add = [&](const SceneBody& body) {
        Source source;
        source.first_shape = shapes_.size();
        source.shape_count = body.shapes.size();
        source.is_shaded = body.type == BodyType::dynamic_body;
        source.fill = body.type == BodyType::static_body      ? colors.static_fill
                      : body.type == BodyType::kinematic_body ? colors.kinematic_fill
                                                              : hues.next(body.name);
        for (const SceneShape& shape : body.shapes) {
            const std::optional<Color> own =
                colors.keeps_materials ? material_color(scene, shape.material) : std::nullopt;
            shapes_.push_back({own.value_or(source.fill), built_shapes(shape, kOther), own.has_value()});
        }
        sources_.push_back(source);
    };
    for (const SceneBody& body : scene.bodies) add(body);
    for (const SceneEvent& event : scene.timeline) {
        if (event.spawn)
            add(*event.spawn);
        else
            sources_.emplace_back();
    }
}

void Palette::paint_body(std::size_t source_index, std::size_t ordinal, std::span<Paint> shapes) const {
    const Source& source = sources_.at(source_index);
    const std::span entries = std::span(shapes_).subspan(source.first_shape, source.shape_count);
    std::size_t others = shapes.size();
    for (const SceneShapeFill& entry : entries)
        if (entry.built != kOther) others -= std::min<std::size_t>(others, entry.built);

    std::size_t next = 0;
    const auto paint_next = [&](std::size_t count, Color fill) {
        for (; count > 0 && next < shapes.size(); --count) shapes[next++] = {fill, outline_of(fill, colors_)};
    };
    const auto shade = [&](Color fill) { return source.is_shaded ? shaded(fill, ordinal, colors_) : fill; };
    for (const SceneShapeFill& entry : entries)
        paint_next(entry.built == kOther ? others : entry.built, entry.is_own ? entry.fill : shade(entry.fill));
    paint_next(shapes.size() - next, shade(source.fill));
    TUMBLE_CHECK(next == shapes.size());
}

}  // namespace tumble::render
