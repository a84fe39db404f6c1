// Drawings: dashes, arrows, and the SVG text.
#include "tumble/drawing.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "support/random_pairs.hpp"

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

TEST_CASE("a dashed line of many short parts has the dashes of one line") {
    Drawing drawing{.width = 100, .height = 100};
    for (int i = 0; i < 95; ++i) drawing.dashed_line({1.0 * i, 0.0}, {1.0 * i + 1.0, 0.0}, 1.0, {}, 1.0 * i);
    double drawn = 0.0;
    for (const DrawnElement& element : drawing.elements) {
        const DrawnLine& line = std::get<DrawnLine>(element);
        CHECK(line.to.x - 10.0 * std::floor(line.from.x / 10.0) <= 6.0);
        drawn += line.to.x - line.from.x;
    }
    CHECK(drawn == 59.0);  // nine dashes of 6 px, and 5 px of the tenth
}

namespace {

// The trace of a pentagon and a kite, whose last step is changed to have one vertex, (4, 0), and the direction to the
// left.
struct ChangedTrace {
    Shape a =
        make_polygon(std::array<Vec2, 5>{{{-1.0f, -0.6f}, {0.8f, -0.9f}, {1.2f, 0.1f}, {0.2f, 0.9f}, {-0.9f, 0.6f}}});
    Shape b = make_polygon(std::array<Vec2, 4>{{{-1.4f, 0.1f}, {0.0f, -0.5f}, {1.4f, 0.2f}, {0.0f, 0.6f}}});
    Pose pose_b{{0.9, 1.9}, make_rotation(0.35)};
    DistanceTrace trace = trace_distance(a, {}, b, pose_b);

    ChangedTrace() {
        REQUIRE(trace.steps.size() >= 2);
        TraceStep& last = trace.steps.back();
        last.count = 1;
        last.simplex[0] = trace.steps[0].simplex[0];
        last.vertices[0] = last.closest = {4.0, 0.0};
        last.direction = {-1.0, 0.0};
        last.lower = trace.steps[trace.steps.size() - 2].lower;
        trace.result.iterations = static_cast<std::uint16_t>(trace.steps.size() + 1);
    }

    void set_support(VertexPair pair, double x) {
        trace.steps.back().support = pair;
        trace.steps.back().support_vertex = {x, 0.0};
    }

    bool says(const std::string& end) const {
        return occurrences(to_svg(draw_trace(a, {}, b, pose_b, trace)), end + "</text>") == 1;
    }
};

}  // namespace

TEST_CASE("the last panel of a trace says why the loop ended") {
    ChangedTrace changed;
    TraceStep& last = changed.trace.steps.back();
    VertexPair other = last.simplex[0];
    other.a = static_cast<std::uint16_t>((other.a + 1) % 4);
    changed.set_support(last.simplex[0], 4.0);
    CHECK(changed.says(" again: done"));
    changed.set_support(other, 4.0 - 0.25 * (changed.trace.result.upper - changed.trace.result.lower));
    CHECK(changed.says(", no farther: done"));
    changed.set_support(other, 4.5);
    CHECK(changed.says(", no farther: done"));
    changed.set_support(other, 3.0);
    CHECK(changed.says(", no better bound: done"));
    changed.trace.result.iterations += 2;
    CHECK(changed.says(", no better bound: all pairs searched"));
    last.lower += 0.1;
    CHECK(changed.says(", origin inside: all pairs searched"));
    changed.trace.result.reached_cap = true;
    CHECK(changed.says(", limit reached: all pairs searched"));
    changed.trace.result.certificate.cores_overlap = true;
    CHECK(changed.says(", limit reached: all pairs searched"));
    CHECK_FALSE(changed.says("The simplex contains the origin: overlap"));
    changed.trace.result.reached_cap = false;
    CHECK(changed.says("The simplex contains the origin: overlap"));
    CHECK_FALSE(changed.says(": all pairs searched"));
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A vertex of a diamond on a side of a box, or on one of its corners, without rounding.
tumble_test::Pair touching_pair(tumble_test::PairSource& source) {
    const float half_width = static_cast<float>(1 + source.below(8));
    const double along = 0.25 * (source.below(9) - 4) * double{half_width};
    return {make_box({2.0f * half_width, 2.0f}),
            {},
            make_polygon(std::array<Vec2, 4>{{{0.0f, -1.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}}}),
            {{along, 2.0}, {}}};
}

}  // namespace

TEST_CASE("the last panel of each trace is true to its numbers") {
    tumble_test::PairSource source(71);
    std::size_t repeated = 0, no_farther = 0, no_better = 0, inside = 0;
    for (int sample = 0; sample < 3000; ++sample) {
        tumble_test::Pair pair = sample % 2 == 0 ? source.pair() : source.near_pair();
        if (sample % 3 == 0) {  // parallel edges, whose vertices are equally far
            pair.a = make_box({static_cast<float>(source.uniform(0.5, 2.0)), 1.0f});
            pair.b = make_box({1.0f, static_cast<float>(source.uniform(0.5, 2.0))});
            pair.pose_b.rotation = pair.pose_a.rotation;
        }
        if (sample % 5 == 0) pair = touching_pair(source);
        const DistanceTrace trace = trace_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        if (trace.result.certificate.cores_overlap || trace.steps.empty()) continue;
        const std::string svg = to_svg(draw_trace(pair.a, pair.pose_a, pair.b, pair.pose_b, trace));
        const TraceStep& last = trace.steps.back();
        const double advance = dot(last.direction, last.support_vertex - last.closest) / length(last.direction);
        const double before = trace.steps.size() > 1 ? trace.steps[trace.steps.size() - 2].lower : -kInfinity;
        const bool is_searched = trace.result.iterations > trace.steps.size() + 1;
        CHECK(occurrences(svg, ": all pairs searched") == (is_searched ? 1 : 0));
        CHECK(occurrences(svg, ": done") == (is_searched ? 0 : 1));
        if (occurrences(svg, ", no farther: ") == 1) {
            ++no_farther;
            CHECK(advance <= 64.0 * tumble_test::rounding_of(pair));
        } else if (occurrences(svg, " again: ") == 1) {
            ++repeated;
            CHECK((last.support == last.simplex[0] || (last.count == 2 && last.support == last.simplex[1])));
        } else if (occurrences(svg, ", no better bound: ") == 1) {
            ++no_better;
            CHECK(last.lower <= before);
        } else {
            ++inside;
            CHECK(occurrences(svg, ", origin inside: ") == 1);
            CHECK(last.lower > before);
            CHECK(trace.result.upper <= 64.0 * tumble_test::rounding_of(pair));
        }
    }
    MESSAGE(repeated << " repeated, " << no_farther << " no farther, " << no_better << " no better bound, " << inside
                     << " origin inside");
    CHECK(repeated > 300);
    CHECK(no_farther > 3);
    CHECK(inside > 3);
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
