// The themes: what a reader can tell apart in each.
#include "render/style/theme.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tumble/render.hpp"

using namespace tumble;
using namespace tumble::render;

namespace {

using Rgb = std::array<double, 3>;

// Linear light, 0 to 1, by IEC 61966-2-1.
Rgb linear(Color color) {
    const auto channel = [](std::uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

double luminance(Color color) {
    const Rgb light = linear(color);
    return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

// Of WCAG 2.1: 1 to 21.
double contrast(Color a, Color b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

using Matrix = std::array<Rgb, 3>;

// How people without one kind of cone see linear light: Machado, Oliveira and Fernandes, "A physiologically-based model
// for simulation of color vision deficiency" (2009), severity 1.
constexpr Matrix kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritanopia{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

Rgb seen(const Matrix& eye, Color color) {
    const Rgb light = linear(color);
    Rgb out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = std::clamp(std::inner_product(eye[i].begin(), eye[i].end(), light.begin(), 0.0), 0.0, 1.0);
    return out;
}

// CIE 1976 L*a*b*, white D65.
Rgb lab(Rgb light) {
    const double x = 0.4124 * light[0] + 0.3576 * light[1] + 0.1805 * light[2];
    const double y = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
    const double z = 0.0193 * light[0] + 0.1192 * light[1] + 0.9505 * light[2];
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    return {116.0 * f(y) - 16.0, 500.0 * (f(x / 0.9505) - f(y)), 200.0 * (f(y) - f(z / 1.089))};
}

// The least difference of two fills as these eyes see them; 2.3 is just noticeable.
double least_difference(const Colors& colors, const Matrix& eye) {
    double least = 1e9;
    for (std::size_t i = 0; i < colors.bodies.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Rgb a = lab(seen(eye, colors.bodies[i])), b = lab(seen(eye, colors.bodies[k]));
            least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
        }
    return least;
}

}  // namespace

TEST_CASE("texts are readable in each theme, and dark themes have dark backgrounds") {
    for (const ThemeName& theme : kThemes) {
        CAPTURE(theme.name);
        const Colors& colors = colors_of(theme.theme);
        CHECK(contrast(colors.text, colors.background) >= 7.0);        // WCAG AAA
        CHECK(contrast(colors.faint_text, colors.background) >= 3.0);  // of large or secondary text
        CHECK(contrast(colors.joint, colors.background) >= 3.0);
        CHECK(is_dark(theme.theme) == (luminance(colors.background) < 0.18));
        for (const Color mark : {colors.overlapping, colors.separated, colors.normal, colors.box_edge, colors.velocity,
                                 colors.joint_line, colors.force, colors.marked})
            CHECK(contrast(mark, colors.background) >= 3.0);
        CHECK(name_of(theme.theme) == theme.name);
    }
}

TEST_CASE("high contrast: fills have 4.5 times the light of the ground, texts 7 times, and outlines are white") {
    const Colors& colors = colors_of(Theme::high_contrast);
    for (const Color fill : colors.bodies) CHECK(contrast(fill, colors.background) >= 4.5);
    CHECK(contrast(colors.static_fill, colors.background) >= 4.5);
    CHECK(contrast(colors.faint_text, colors.background) >= 7.0);
    CHECK(colors.outline_share == 1.0);
    CHECK(colors.tint == Color{255, 255, 255});
}

TEST_CASE("eyes that lack a kind of cone tell all bodies of the theme color_blind apart, better than those of light") {
    for (const Matrix& eye : {kProtanopia, kDeuteranopia, kTritanopia}) {
        CHECK(least_difference(colors_of(Theme::color_blind), eye) > 10.0);
        CHECK(least_difference(colors_of(Theme::color_blind), eye) > least_difference(colors_of(Theme::light), eye));
    }
}

TEST_CASE("print: all colours are greys, and outlines are nearly black on white") {
    const Colors& colors = colors_of(Theme::print);
    const auto is_grey = [](Color color) { return color.r == color.g && color.g == color.b; };
    for (const Color fill : colors.bodies) {
        CHECK(is_grey(fill));
        CHECK(contrast(mix(fill, colors.shade, colors.outline_share), colors.background) >= 7.0);
    }
    for (std::size_t i = 1; i < colors.bodies.size(); ++i)
        CHECK(std::abs(colors.bodies[i].r - colors.bodies[i - 1].r) >= 20);
    for (const Color color : {colors.static_fill, colors.kinematic_fill, colors.text, colors.joint, colors.marked})
        CHECK(is_grey(color));
    CHECK(colors.background == Color{255, 255, 255});
}
