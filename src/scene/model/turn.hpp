// Rotating vectors in double.
#pragma once

#include "tumble/math.hpp"

namespace tumble::scene {

constexpr DVec2 turned(DVec2 v, SinCos turn) {
    return {turn.cos * v.x - turn.sin * v.y, turn.sin * v.x + turn.cos * v.y};
}

}  // namespace tumble::scene
