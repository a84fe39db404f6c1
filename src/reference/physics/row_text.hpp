// Texts and curves that several rows share.
#pragma once

#include <string>
#include <vector>

#include "reference/physics/row.hpp"
#include "reference/physics/scene_parts.hpp"

namespace tumble::reference {

// As std::snprintf() formats doubles; at most 200 characters.
template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
    std::array<char, 200> line{};
    std::snprintf(line.data(), line.size(), format, static_cast<double>(numbers)...);
    return line.data();
}

std::string rate_text(SceneRate rate);  // "60 Hz, 4 sub-steps"
std::string name_of(Engine engine);

// The option of tumble; Box2D has one solver.
constexpr JointSolver kJointSolvers[] = {JointSolver::iterative, JointSolver::direct};
std::string name_of(JointSolver solver);

// The points (times[i], i).
Curve curve_of_indices(Engine engine, const std::vector<double>& times);

// The time within (from, to) at which a value that is `before` at `from` and `after` at `to` is 0, linearly.
inline double crossing(double from, double to, double before, double after) {
    return from + (to - from) * before / (before - after);
}

}  // namespace tumble::reference
