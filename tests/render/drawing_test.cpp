// Drawings: dashes, arrows, and the SVG text.
#include "tumble/drawing.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace tumble;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

}  // namespace

TEST_CASE("an SVG holds each element once, in order, with rounded numbers and escaped text") {
    Drawing drawing{.width = 200, .height = 100};
    drawing.disc({50.0, 40.0}, 12.3456, {255, 0, 0}, 2.0, {0, 0, 0});
    drawing.text({10.0, 90.0}, "a < b & \"c\"", 12.0, {1, 2, 3}, TextAnchor::middle);
    drawing.polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, -0.001}}, {16, 32, 255, 51}, 0.0, {});
    const std::string svg = to_svg(drawing);
    CHECK(svg.find("<circle cx=\"50\" cy=\"40\" r=\"12.35\" fill=\"#ff0000\" stroke=\"#000000\" stroke-width=\"2\"") !=
          std::string::npos);
    CHECK(svg.find("a &lt; b &amp; &quot;c&quot;</text>") != std::string::npos);
    CHECK(escape_markup("a\x01\tb\n") == "a?\tb\n");  // XML has no such character
    CHECK(svg.find("points=\"0,0 10,0 10,0\" fill=\"#1020ff\" fill-opacity=\"0.2\"/>") != std::string::npos);
    CHECK(svg.find("<circle") < svg.find("<text"));
    CHECK(svg.find("</svg>\n") == svg.size() - 7);
}

TEST_CASE("a dashed line stays within its ends and leaves gaps") {
    Drawing drawing{.width = 100, .height = 100};
    drawing.dashed_line({0.0, 0.0}, {95.0, 0.0}, 1.0, {});
    // Periods of 10 px with 6 px drawn: the tenth dash is cut from 96 to 95.
    REQUIRE(drawing.elements.size() == 10);
    CHECK(std::get<DrawnLine>(drawing.elements.back()).to == DVec2(95.0, 0.0));
    CHECK(occurrences(to_svg(drawing), "<line") == 10);
}

TEST_CASE("an arrow ends in a head at its tip; without length it draws nothing") {
    Drawing drawing{.width = 100, .height = 100};
    drawing.arrow({5.0, 5.0}, {5.0, 5.0}, 1.0, {});
    CHECK(drawing.elements.empty());
    drawing.arrow({0.0, 0.0}, {50.0, 0.0}, 2.0, {});
    REQUIRE(drawing.elements.size() == 2);
    const DrawnPolygon& head = std::get<DrawnPolygon>(drawing.elements.back());
    CHECK(head.points.front() == DVec2(50.0, 0.0));
    CHECK(head.points[1] == DVec2(40.0, 4.0));  // head of 4 + 3 * 2 = 10 px, 0.4 of it to each side
}
