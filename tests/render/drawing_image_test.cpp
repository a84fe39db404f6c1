// Drawings as images: each element at its coordinates, in the order of the list.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/pixels.hpp"
#include "support/near.hpp"
#include "tumble/drawing.hpp"
#include "tumble/render.hpp"

using namespace tumble;
using namespace tumble::test;
using render::coverage;
using render::pixel;

namespace {

constexpr Color kWhite{255, 255, 255}, kBlack{0, 0, 0}, kRed{255, 0, 0}, kBlue{0, 0, 255};

Drawing on_black(int width, int height) { return {.width = width, .height = height, .background = kBlack}; }

}  // namespace

TEST_CASE("the y axis of a drawing points down from the upper left corner") {
    Drawing drawing = on_black(60, 40);
    drawing.polygon({{10.0, 5.0}, {20.0, 5.0}, {20.0, 8.0}, {10.0, 8.0}}, kRed, 0.0, {});
    const Image image = draw_image(drawing);
    CHECK(pixel(image, 15, 6) == kRed);
    CHECK(pixel(image, 15, 9) == kBlack);
    CHECK(pixel(image, 15, 33) == kBlack);
}

TEST_CASE("later elements of a drawing cover earlier ones") {
    Drawing drawing = on_black(40, 40);
    drawing.disc({20.0, 20.0}, 15.0, kRed);
    drawing.polygon({{0.0, 15.0}, {40.0, 15.0}, {40.0, 25.0}, {0.0, 25.0}}, kBlue, 0.0, {});
    drawing.disc({20.0, 20.0}, 3.0, kWhite);
    const Image image = draw_image(drawing);
    CHECK(pixel(image, 20, 8) == kRed);
    CHECK(pixel(image, 10, 20) == kBlue);
    CHECK(pixel(image, 20, 20) == kWhite);
}

TEST_CASE("a disc's outline straddles its edge, and without a fill it is a ring") {
    Drawing drawing = on_black(100, 100);
    drawing.disc({50.0, 50.0}, 30.0, kTransparent, 4.0, kWhite);
    const Image image = draw_image(drawing);
    CHECK(pixel(image, 50, 50) == kBlack);
    // The area between the radii 28 and 32 is pi (32^2 - 28^2) = 240 pi.
    // Each of 120 pi pixels of edge is rounded by 1/510 at most.
    CHECK(near(coverage(image), 240.0 * kPi, absolute(120.0 * kPi / 510.0)));
}

TEST_CASE("polygons cover their area, convex or not, in either order of their points") {
    // An L: 60 x 60 without its upper right quarter.
    std::vector<DVec2> corner{{20.0, 20.0}, {50.0, 20.0}, {50.0, 50.0}, {80.0, 50.0}, {80.0, 80.0}, {20.0, 80.0}};
    for (int order = 0; order < 2; ++order) {
        Drawing drawing = on_black(100, 100);
        drawing.polygon(corner, kWhite, 0.0, {});
        const Image image = draw_image(drawing);
        CHECK(pixel(image, 35, 35) == kWhite);
        CHECK(pixel(image, 65, 65) == kWhite);
        CHECK(pixel(image, 65, 35) == kBlack);
        // The hairline that smooths a concave polygon's edges covers half a pixel beyond 240 pixels of edge, and up to
        // a pixel more or less at each of 6 corners.
        CHECK(near(coverage(image), 2700.0 + 120.0, absolute(6.0)));
        std::reverse(corner.begin(), corner.end());
    }
    Drawing drawing = on_black(100, 100);
    drawing.polygon({{10.0, 10.0}, {90.0, 20.0}, {50.0, 95.0}}, kWhite, 0.0, {});
    // Half the cross product of (80, 10) and (40, 85): 3200. Each of 260 pixels of edge is rounded by 1/510 at most.
    CHECK(near(coverage(draw_image(drawing)), 3200.0, absolute(260.0 / 510.0)));
}

TEST_CASE("a repeated point does not fade the fill of its polygon") {
    for (const DVec2 again : {DVec2{10.0, 10.0}, DVec2{10.0, 10.001}}) {
        Drawing drawing = on_black(100, 100);
        drawing.polygon({{10.0, 10.0}, {90.0, 10.0}, {90.0, 90.0}, {90.0, 90.0}, {10.0, 90.0}, again},
                        {255, 255, 255, 102}, 0.0, {});
        const Image image = draw_image(drawing);
        CHECK(pixel(image, 50, 50).r == 102);  // 40 % of white, all over
        CHECK(near(coverage(image), 0.4 * 6400.0, relative(6400 * 0x1p-53)));
    }
}

TEST_CASE("text starts, is centred or ends at its anchor") {
    const auto mean_column = [](TextAnchor anchor) {
        Drawing drawing = on_black(200, 40);
        drawing.text({100.0, 25.0}, "HHHH", 14.0, kWhite, anchor);
        const Image image = draw_image(drawing);
        double sum = 0.0;
        for (int row = 0; row < 40; ++row)
            for (int column = 0; column < 200; ++column) sum += pixel(image, column, row).r / 255.0 * (column + 0.5);
        return sum / coverage(image);
    };
    const double middle = mean_column(TextAnchor::middle);
    CHECK(std::abs(middle - 100.0) < 0.5);  // glyphs lie on quarters of a pixel
    CHECK(mean_column(TextAnchor::left) > 115.0);
    CHECK(mean_column(TextAnchor::right) < 85.0);
}

TEST_CASE("a drawing without a size is refused") {
    CHECK_THROWS_AS(draw_image({}), std::invalid_argument);
    CHECK_THROWS_AS(draw_image({.width = 10, .height = 9000}), std::invalid_argument);
}
