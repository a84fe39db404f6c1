// Detects that a step did not end in finite numbers.
#pragma once

#include <cstdint>

#include "dynamics/bodies/body_store.hpp"

namespace tumble {

inline constexpr std::uint32_t kNoBody = 0xffffffffu;

// The lowest index of a body whose velocity or pose is not finite, or kNoBody.
//
// Only an impulse that is not finite moves the static solver body, and then every body that rests on it is lost. In
// that case: the lowest index of a static body with a joint, or of any static body if none has one.
std::uint32_t find_diverged(const BodyStore& bodies);

// Without a finite pose, as after a step that diverged, a body has no boxes.
bool has_finite_pose(const BodyStore& bodies, std::uint32_t body);

}  // namespace tumble
