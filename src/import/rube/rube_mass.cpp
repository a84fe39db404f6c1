#include "import/rube/rube_mass.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/scene_world.hpp"
#include "tumble/shape.hpp"

namespace tumble::scene {

namespace {

constexpr double kTolerance = 1e-6;  // relative; an export states float masses

double density_of(const std::string& name, const std::vector<SceneMaterial>& materials) {
    const auto found = std::ranges::find(materials, name, &SceneMaterial::name);
    return found == materials.end() ? SceneMaterial{}.density : found->density;
}

}  // namespace

SceneMass read_rube_mass(RubeObject& body, bool fixed_rotation) {
    const double mass = body.number("massData-mass"), inertia = body.number("massData-I");
    SceneMass result{mass > 0.0 ? mass : 1.0, body.vector("massData-center"), 0.0};
    if (inertia > 0.0 && !fixed_rotation)
        result.inertia = std::max(inertia - result.mass * length_sq(result.center), 0.0);
    return result;
}

bool is_mass_of_shapes(const SceneMass& mass, const SceneBody& body, const std::vector<SceneMaterial>& materials) {
    double total = 0.0;
    DVec2 moment;
    double inertia = 0.0, reach = 0.0;  // about the origin
    for (const SceneShape& shape : body.shapes) {
        if (shape.sensor) continue;
        const double density = density_of(shape.material, materials);
        for (const Shape& part : make_shapes(shape.geometry)) {
            const MassProperties properties = mass_properties(part);
            const double weight = density * properties.area;
            const DVec2 center(properties.center);
            total += weight;
            moment += weight * center;
            inertia += density * properties.inertia + weight * length_sq(center);
            reach = std::max(reach, double{farthest_distance(part, {})});
        }
    }
    if (!(total > 0.0) || std::abs(total - mass.mass) > kTolerance * mass.mass) return false;
    const DVec2 center = (1.0 / total) * moment;
    if (length(center - mass.center) > kTolerance * reach) return false;
    if (body.fixed_rotation) return true;
    return std::abs(inertia - total * length_sq(center) - mass.inertia) <= kTolerance * mass.inertia;
}

}  // namespace tumble::scene
