// The colours of a frame: one set for each theme.
#pragma once

#include <array>
#include <string_view>

#include "render/style/color.hpp"
#include "tumble/scene.hpp"

namespace tumble::render {

struct Colors {
    Color background, minor_grid, major_grid;
    Color static_fill, kinematic_fill;
    std::array<Color, 8> bodies;  // fills of dynamic bodies, in the order in which their names occur

    bool keeps_materials;  // false: the colours of materials are not used, as they could break the contrasts of the
                           // theme

    // An outline is its fill mixed with `shade`, or with `tint` if the fill has a luma below `least_luma` (0 to 1).
    Color shade, tint;
    double outline_share, least_luma;

    Color joint, rope, anchor;
    Color text, faint_text;
    Color shadow;

    // Overlays: strong colours that differ from those of bodies and from each other.
    Color overlapping, separated, normal, box_edge, velocity, joint_line, force, marked;
};

const Colors& colors_of(Theme theme);

// As scenes write it: "high_contrast".
std::string_view name_of(Theme theme);

// How a frame is drawn: a style with its colours.
struct Look {
    explicit Look(const SceneStyle& style = {});

    const Colors& colors;
    SceneStyle style;
};

}  // namespace tumble::render
