#include "import/rube/rube_mass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/json/json_text.hpp"
#include "tumble/scene_world.hpp"
#include "tumble/shape.hpp"

namespace tumble::scene {

namespace {

constexpr double kTolerance = 1e-6;  // relative; an export states float masses

double density_of(const std::string& name, const std::vector<SceneMaterial>& materials) {
    const auto found = std::ranges::find(materials, name, &SceneMaterial::name);
    return found == materials.end() ? SceneMaterial{}.density : found->density;
}

// Of all shapes of a body together.
struct ShapesMass {
    double mass = 0.0;
    DVec2 center;
    double inertia = 0.0;  // about the centre
    double reach = 0.0;    // of the farthest point from the origin
};

ShapesMass mass_of_shapes(const SceneBody& body, const std::vector<SceneMaterial>& materials) {
    ShapesMass sum;
    DVec2 moment;
    for (const SceneShape& shape : body.shapes) {
        if (shape.sensor) continue;
        const double density = density_of(shape.material, materials);
        for (const Shape& part : make_shapes(shape.geometry)) {
            const MassProperties properties = mass_properties(part);
            const double weight = density * properties.area;
            const DVec2 center(properties.center);
            sum.mass += weight;
            moment += weight * center;
            sum.inertia += density * properties.inertia + weight * length_sq(center);
            sum.reach = std::max(sum.reach, double{farthest_distance(part, {})});
        }
    }
    if (!(sum.mass > 0.0)) return sum;
    sum.center = (1.0 / sum.mass) * moment;
    sum.inertia -= sum.mass * length_sq(sum.center);
    return sum;
}

bool are_equal(const SceneMass& stated, const ShapesMass& shapes, bool fixed_rotation) {
    if (!(shapes.mass > 0.0) || std::abs(shapes.mass - stated.mass) > kTolerance * stated.mass) return false;
    if (length(shapes.center - stated.center) > kTolerance * shapes.reach) return false;
    return fixed_rotation || std::abs(shapes.inertia - stated.inertia) <= kTolerance * stated.inertia;
}

// The inertia of the shapes about another centre, if they had this mass; 0 for shapes without an area.
double inertia_of_shapes(const SceneMass& stated, const ShapesMass& shapes) {
    if (!(shapes.mass > 0.0)) return 0.0;
    return shapes.inertia * stated.mass / shapes.mass + stated.mass * length_sq(stated.center - shapes.center);
}

}  // namespace

std::optional<SceneMass> read_rube_mass(RubeObject& json, const SceneBody& body, const std::string& owner,
                                        const std::vector<SceneMaterial>& materials) {
    // Box2D has computed them from shapes of any size; a scene states them only if they differ from those of the
    // shapes.
    constexpr double kLargestStated = std::numeric_limits<double>::max();
    const double mass = json.number("massData-mass", 0.0, {-kLargestStated, kLargestStated}),
                 about_origin = json.number("massData-I", 0.0, {-kLargestStated, kLargestStated});
    SceneMass stated{mass > 0.0 ? mass : 1.0, json.vector("massData-center"), 0.0};
    if (body.type != BodyType::dynamic_body) return std::nullopt;
    const ShapesMass shapes = mass_of_shapes(body, materials);
    if (about_origin > 0.0 && !body.fixed_rotation) {
        const double of_center = stated.mass * length_sq(stated.center);
        stated.inertia = about_origin - of_center;
        if (!(stated.inertia > 0.0)) {
            stated.inertia = inertia_of_shapes(stated, shapes);
            json.warn("massData-I",
                      owner + " has a moment of inertia of " + number_text(about_origin) +
                          " kg m^2 about its origin, less than its mass times the squared distance of its centre, " +
                          number_text(of_center) + " kg m^2, which no body has; Box2D does not accept it",
                      stated.inertia > 0.0 ? "the scene has the moment of inertia of the shapes instead"
                                           : "the body has no shape with an area: it does not rotate");
        }
    }
    if (are_equal(stated, shapes, body.fixed_rotation)) return std::nullopt;
    // The scene states them: within its limits.
    json.number("massData-mass", 0.0, kAny);
    json.number("massData-I");
    return stated;
}

}  // namespace tumble::scene
