// The two bodies of a joint definition of any kind.
#pragma once

#include <variant>

#include "tumble/id.hpp"
#include "tumble/joint.hpp"

namespace tumble {

inline BodyId joint_body_a(const JointDef& def) {
    return std::visit([](const auto& d) { return d.body_a; }, def);
}
inline BodyId joint_body_b(const JointDef& def) {
    return std::visit([](const auto& d) { return d.body_b; }, def);
}

}  // namespace tumble
