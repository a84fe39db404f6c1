#include "scene/build/validate_body.hpp"
#include "scene/json/problem_codes.hpp"

#include "scene/build/element.hpp"
#include "scene/json/problem_codes.hpp"
#include "scene/model/geometry.hpp"

namespace tumble::scene {

namespace {

void report_hull(const PolygonGeometry& polygon, const std::string& pointer, Diagnostics& diagnostics) {
    HullReport report;
    make_hull(polygon, &report);
    if (report.interior > 0)
        diagnostics.warning(codes::ignored_vertices, pointer,
                            "vertices inside the convex hull, which are ignored: " + std::to_string(report.interior),
                            "use an \"outline\" for a concave shape");
    if (report.duplicate + report.collinear > 0)
        diagnostics.warning(codes::ignored_vertices, pointer,
                            std::to_string(report.duplicate + report.collinear) +
                                " of the vertices are duplicates or lie on an edge, and are ignored");
}

}  // namespace

void validate_body(const SceneBody& body, const std::string& pointer, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        const std::string shape = element(pointer + "/shapes", i);
        const auto* polygon = std::get_if<PolygonGeometry>(&body.shapes[i].geometry);
        if (polygon && !diagnostics.has_errors_in(shape))
            report_hull(*polygon, shape + "/polygon/vertices", diagnostics);
    }
    const bool moves = body.velocity != DVec2{} || body.angular_velocity != 0.0;
    if (moves && !body.awake && body.type == BodyType::dynamic_body)
        diagnostics.error(pointer + "/awake", "a sleeping body must be at rest, and this one has a velocity",
                          R"(remove "awake": false, or the velocity)");
}

}  // namespace tumble::scene
