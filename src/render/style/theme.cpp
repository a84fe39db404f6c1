#include "render/style/theme.hpp"

#include <algorithm>
#include <stdexcept>

#include "tumble/render.hpp"

namespace tumble::render {
namespace {

// Calm and bright. Neighbours among the bodies differ in hue; all have a similar lightness.
constexpr Colors kLight{.background = {247, 248, 250},
                        .minor_grid = {238, 240, 244},
                        .major_grid = {227, 231, 237},
                        .static_fill = {203, 209, 218},
                        .kinematic_fill = {136, 149, 171},
                        .bodies = {{{104, 154, 211},    // blue
                                    {240, 178, 92},     // amber
                                    {98, 181, 165},     // teal
                                    {228, 127, 108},    // coral
                                    {150, 134, 202},    // violet
                                    {148, 188, 106},    // green
                                    {219, 139, 170},    // rose
                                    {193, 164, 123}}},  // sand
                        .keeps_materials = true,
                        .shade = {36, 46, 62},
                        .tint = {247, 248, 250},
                        .outline_share = 0.42,
                        .least_luma = 0.4,
                        .joint = {74, 85, 104},
                        .rope = {150, 118, 78},
                        .anchor = {250, 251, 252},
                        .text = {45, 55, 72},
                        .faint_text = {113, 124, 142},
                        .shadow = {36, 46, 62, 46},
                        .overlapping = {205, 45, 40},
                        .separated = {35, 105, 205},
                        .normal = {10, 115, 75},
                        .box_edge = {135, 85, 190},
                        .velocity = {190, 85, 0},
                        .joint_line = {165, 30, 115},
                        .force = {20, 120, 140},
                        .marked = {205, 45, 40}};

// The light hues on a dark ground, with outlines lighter than the fills.
constexpr Colors dark() {
    Colors colors = kLight;
    colors.background = {20, 25, 29};
    colors.minor_grid = {25, 31, 36};
    colors.major_grid = {34, 42, 48};
    colors.static_fill = {82, 88, 93};
    colors.kinematic_fill = {122, 134, 154};
    colors.shade = {20, 25, 29};
    colors.tint = {255, 255, 255};
    colors.outline_share = 0.3;
    colors.least_luma = 0.8;
    colors.joint = {169, 184, 198};
    colors.rope = {196, 164, 120};
    colors.anchor = {20, 25, 29};
    colors.text = {221, 228, 232};
    colors.faint_text = {152, 168, 179};
    colors.shadow = {0, 0, 0, 120};
    colors.overlapping = {255, 110, 102};
    colors.separated = {110, 180, 255};
    colors.normal = {95, 211, 159};
    colors.box_edge = {187, 147, 238};
    colors.velocity = {255, 162, 74};
    colors.joint_line = {244, 130, 200};
    colors.force = {90, 210, 225};
    colors.marked = {255, 110, 102};
    return colors;
}

// Greys on white, with black outlines, for printers without colours: neighbours among the bodies differ in lightness.
constexpr Colors print() {
    Colors colors = kLight;
    colors.keeps_materials = false;
    colors.background = {255, 255, 255};
    colors.minor_grid = {246, 246, 246};
    colors.major_grid = {236, 236, 236};
    colors.static_fill = {150, 150, 150};
    colors.kinematic_fill = {112, 112, 112};
    colors.bodies = {{{240, 240, 240},
                      {196, 196, 196},
                      {226, 226, 226},
                      {182, 182, 182},
                      {248, 248, 248},
                      {210, 210, 210},
                      {233, 233, 233},
                      {189, 189, 189}}};
    colors.shade = {0, 0, 0};
    colors.tint = {255, 255, 255};
    colors.outline_share = 0.85;
    colors.least_luma = 0.2;
    colors.joint = {0, 0, 0};
    colors.rope = {64, 64, 64};
    colors.anchor = {255, 255, 255};
    colors.text = {0, 0, 0};
    colors.faint_text = {80, 80, 80};
    colors.shadow = {0, 0, 0, 56};
    colors.overlapping = {0, 0, 0};
    colors.separated = {96, 96, 96};
    colors.normal = {0, 0, 0};
    colors.box_edge = {120, 120, 120};
    colors.velocity = {48, 48, 48};
    colors.joint_line = {72, 72, 72};
    colors.force = {24, 24, 24};
    colors.marked = {0, 0, 0};
    return colors;
}

// Bright fills with white outlines on black: each is at least 4.5 times as bright as the ground, texts 7 times
// (WCAG 2.1, 1.4.3 and 1.4.6).
constexpr Colors high_contrast() {
    Colors colors = dark();
    colors.keeps_materials = false;
    colors.background = {0, 0, 0};
    colors.minor_grid = {22, 22, 22};
    colors.major_grid = {44, 44, 44};
    colors.static_fill = {118, 118, 118};
    colors.kinematic_fill = {190, 190, 190};
    colors.bodies = {{{80, 160, 255},
                      {255, 200, 0},
                      {0, 220, 160},
                      {255, 110, 80},
                      {190, 140, 255},
                      {150, 230, 0},
                      {255, 130, 210},
                      {225, 180, 120}}};
    colors.shade = {0, 0, 0};
    colors.outline_share = 1.0;
    colors.least_luma = 1.0;
    colors.joint = {255, 255, 255};
    colors.rope = {255, 220, 150};
    colors.anchor = {0, 0, 0};
    colors.text = {255, 255, 255};
    colors.faint_text = {225, 225, 225};
    colors.shadow = {255, 255, 255, 60};
    return colors;
}

// The hues of Okabe and Ito ("Color universal design", 2008), which differ for all kinds of colour blindness.
constexpr Colors color_blind() {
    Colors colors = kLight;
    colors.keeps_materials = false;
    colors.bodies = {{{86, 180, 233},   // sky blue
                      {230, 159, 0},    // orange
                      {0, 158, 115},    // bluish green
                      {240, 228, 66},   // yellow
                      {0, 114, 178},    // blue
                      {213, 94, 0},     // vermilion
                      {204, 121, 167},  // reddish purple
                      {70, 70, 70}}};   // grey, for black
    colors.overlapping = {213, 94, 0};
    colors.separated = {0, 114, 178};
    colors.normal = {0, 110, 80};
    colors.velocity = {150, 95, 0};
    colors.marked = {213, 94, 0};
    return colors;
}

constexpr Colors kDark = dark(), kPrint = print(), kHighContrast = high_contrast(), kColorBlind = color_blind();

}  // namespace

const Colors& colors_of(Theme theme) {
    switch (theme) {
        case Theme::light: return kLight;
        case Theme::dark: return kDark;
        case Theme::print: return kPrint;
        case Theme::high_contrast: return kHighContrast;
        case Theme::color_blind: return kColorBlind;
    }
    throw std::invalid_argument("a theme is out of range");
}

std::string_view name_of(Theme theme) { return std::ranges::find(kThemes, theme, &ThemeName::theme)->name; }

Look::Look(const SceneStyle& of) : colors(colors_of(of.theme)), style(of) {}

}  // namespace tumble::render

namespace tumble {

bool is_dark(Theme theme) { return theme == Theme::dark || theme == Theme::high_contrast; }

}  // namespace tumble
