// The two bodies of a joint definition of any kind, and whether a gear can couple the joint.
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

// True if the joint has one free motion, which a gear can transmit.
inline bool can_be_geared(const JointDef& def) {
    return std::holds_alternative<RevoluteJointDef>(def) || std::holds_alternative<PrismaticJointDef>(def);
}

}  // namespace tumble
