#include "reference/physics/row_text.hpp"

namespace tumble::reference {

std::string rate_text(SceneRate rate) {
    return text("%g Hz, ", rate.steps_per_second) + text("%g sub-steps", rate.substeps);
}

std::string name_of(Engine engine) { return engine == Engine::tumble ? "tumble" : "Box2D"; }

Curve curve_of_indices(Engine engine, const std::vector<double>& times) {
    Curve curve{.name = name_of(engine), .engine = engine, .joined = false};
    for (std::size_t i = 0; i < times.size(); ++i) curve.points.push_back({times[i], static_cast<double>(i)});
    return curve;
}

}  // namespace tumble::reference
