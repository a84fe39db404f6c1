// Chains become two-sided whatever their winding, because R.U.B.E. is older than one-sided chains.
#include "import/rube/rube_shapes.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "scene/model/geometry.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

// Where the notes on the fixtures of a body go.
struct FixtureNotes {
    const std::string& owner;
    RubeNotes& all;

    void add(const std::string& feature, int count = 1) const { all.add_of(owner, feature, count); }
};

// Removes points that are equal in float to the one before.
std::vector<DVec2> weld_neighbors(const std::vector<DVec2>& points, const FixtureNotes& notes) {
    std::vector<DVec2> kept;
    for (const DVec2 point : points)
        if (kept.empty() || to_float(kept.back()) != to_float(point)) kept.push_back(point);
    if (kept.size() < points.size())
        notes.add("repeated chain vertices", static_cast<int>(points.size() - kept.size()));
    return kept;
}

ShapeGeometry make_rube_chain(const std::vector<DVec2>& points, bool loop, const FixtureNotes& notes) {
    ChainGeometry chain{weld_neighbors(points, notes), loop, true};
    const bool closed = chain.points.size() > 2 && to_float(chain.points.front()) == to_float(chain.points.back());
    if (closed) {
        chain.points.pop_back();
        chain.loop = true;
    }
    if (chain.points.size() < 3) chain.loop = false;
    return chain;
}

// Polygons of an export are usually convex. A concave one becomes an outline, one of two vertices a segment.
ShapeGeometry make_rube_polygon(const std::vector<DVec2>& vertices) {
    if (vertices.size() == 2) return SegmentGeometry{vertices[0], vertices[1]};
    HullReport report;
    make_hull({vertices, 0.0}, &report);
    if (report.interior == 0) return PolygonGeometry{vertices, 0.0};
    return OutlineGeometry{vertices};
}

ShapeGeometry read_chain(RubeObject& chain, const FixtureNotes& notes) {
    ShapeGeometry geometry = make_rube_chain(chain.points("vertices"), false, notes);
    const bool has_ghosts = chain.flag("hasNextVertex") || chain.flag("hasPrevVertex");
    if (has_ghosts && !std::get<ChainGeometry>(geometry).loop) notes.add("ghost vertices at the ends of open chains");
    chain.skip({"nextVertex", "prevVertex", "hasPrevVertex"});
    return geometry;
}

ShapeGeometry read_edge(RubeObject& edge, const FixtureNotes& notes) {
    if (edge.flag("hasVertex0") || edge.flag("hasVertex3")) notes.add("ghost vertices of edges");
    edge.skip({"vertex0", "vertex3", "hasVertex3"});
    return SegmentGeometry{edge.vector("vertex1"), edge.vector("vertex2")};
}

std::optional<ShapeGeometry> read_geometry(RubeObject& fixture, const FixtureNotes& notes) {
    constexpr std::array<std::string_view, 5> kKinds = {"circle", "polygon", "chain", "edge", "loop"};
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](std::string_view k) { return fixture.has(k); });
    if (kind == kKinds.end()) return std::nullopt;
    RubeObject shape = fixture.object(*kind);
    ShapeGeometry geometry;
    if (*kind == "circle") geometry = CircleGeometry{shape.number("radius", 0.0, kCoordinate), shape.vector("center")};
    if (*kind == "polygon") geometry = make_rube_polygon(shape.points("vertices"));
    if (*kind == "chain") geometry = read_chain(shape, notes);
    if (*kind == "edge") geometry = read_edge(shape, notes);
    if (*kind == "loop") geometry = make_rube_chain(shape.points("vertices"), true, notes);
    shape.note_unread(std::string(*kind), notes.all);
    return geometry;
}

// The geometry, or empty if it is degenerate.
std::optional<ShapeGeometry> read_valid_geometry(RubeObject& fixture, const FixtureNotes& notes) {
    try {
        std::optional<ShapeGeometry> geometry = read_geometry(fixture, notes);
        const CircleGeometry* circle = geometry ? std::get_if<CircleGeometry>(&*geometry) : nullptr;
        if (circle && !(circle->radius > 0.0)) return std::nullopt;
        if (geometry) make_shapes(*geometry);
        return geometry;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

constexpr double kAll = 65535.0;  // exports have 16 categories

// Empty if the filter equals the default.
std::optional<SceneFilter> read_filter(RubeObject& fixture) {
    const double category = fixture.number("filter-categoryBits", 1.0), mask = fixture.number("filter-maskBits", kAll);
    const double group = fixture.number("filter-groupIndex");
    if (category == 1.0 && mask == kAll && group == 0.0) return std::nullopt;
    const auto bits = [](double value) { return static_cast<std::uint64_t>(std::clamp(value, 0.0, kAll)); };
    return SceneFilter{bits(category), bits(mask), static_cast<int>(std::clamp(group, -32768.0, 32767.0))};
}

}  // namespace

std::optional<RubeFixture> read_rube_fixture(RubeObject fixture, const std::string& owner, RubeNotes& notes) {
    RubeFixture result;
    result.surface = {fixture.number("density", 0.0, kNotNegative), fixture.number("friction", 0.0, kNotNegative),
                      fixture.number("restitution", 0.0, kNotNegative)};
    if (result.surface.restitution > 1.0) {
        notes.add_of(owner, "restitutions above 1, which are 1 in the scene");
        result.surface.restitution = 1.0;
    }
    result.custom = fixture.custom({"name", "customProperties"});
    result.filter = read_filter(fixture);
    result.sensor = fixture.flag("sensor");
    const std::optional<ShapeGeometry> geometry = read_valid_geometry(fixture, {owner, notes});
    fixture.note_unread("fixture", notes);
    if (!geometry) {
        notes.add_of(owner, "fixtures without a shape or with a degenerate one, left out");
        return std::nullopt;
    }
    result.geometry = *geometry;
    return result;
}

}  // namespace tumble::scene
