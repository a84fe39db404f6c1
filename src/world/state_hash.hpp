// The state hash: equal for runs that are equal bit for bit.
#pragma once

#include <cstdint>

#include "dynamics/bodies/body_store.hpp"

namespace tumble {

// xxHash64 (seed 0) over the live bodies in id order, 33 bytes each, little-endian: position x, y (double), rotation
// c, s, velocity x, y, angular velocity (float), 1 if asleep.
std::uint64_t hash_bodies(const BodyStore& bodies);

}  // namespace tumble
