// The colours of a scene's bodies: of the shape's material if that has one and the theme keeps it, else by type and
// name of the body.
//
// Dynamic bodies take the palette's colours in the order in which their names first occur. Copies of one body, bodies
// whose names differ only in digits, and the same body of several copies of a part ("a/arm", "b/arm") share a hue.
// Copies of one body differ a little in lightness.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/style/theme.hpp"
#include "tumble/scene.hpp"

namespace tumble::render {

class Palette {
public:
    // The colours are those of a theme.
    explicit Palette(const Scene& scene, const Colors& colors = colors_of(Theme::light));

    // The paints of all shapes of a body built from Scene::bodies[source], in the order in which they were added.
    // `ordinal` tells copies of one body apart. Sources are numbered as in SceneInstance.
    void paint_body(std::size_t source, std::size_t ordinal, std::span<Paint> shapes) const;

private:
    // The number of shapes of the world built from one entry of SceneBody::shapes; kOther: the rest of the body's
    // shapes.
    static constexpr std::uint32_t kOther = 0xffffffffu;
    struct SceneShapeFill {
        Color fill;
        std::uint32_t built = 1;
        bool is_own = false;  // from the material, and not shaded
    };
    struct Source {
        std::size_t first_shape = 0;
        std::size_t shape_count = 0;
        Color fill;
        bool is_shaded = false;
    };

    const Colors& colors_;
    std::vector<Source> sources_;
    std::vector<SceneShapeFill> shapes_;
};

// The colour of the outline of a shape with that fill.
Color outline_of(Color fill, const Colors& colors);

}  // namespace tumble::render
