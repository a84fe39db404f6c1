#include "reference/physics/row_text.hpp"

#include <array>
#include <string_view>

namespace tumble::reference {

std::string rate_text(SceneRate rate) {
    return text("%g Hz, ", rate.steps_per_second) + text("%g sub-steps", rate.substeps);
}

std::string name_of(Engine engine) {
    constexpr std::array<std::string_view, std::size(kEngines)> kNames = {"tumble", "at step end", "Box2D"};
    return std::string(kNames[static_cast<std::size_t>(engine)]);
}

std::string name_of(JointSolver solver) {
    return solver == JointSolver::direct ? "direct joints" : "joints of the default";
}

Curve curve_of_indices(Engine engine, const std::vector<double>& times) {
    Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
    for (std::size_t i = 0; i < times.size(); ++i) curve.points.push_back({times[i], static_cast<double>(i)});
    return curve;
}

}  // namespace tumble::reference
