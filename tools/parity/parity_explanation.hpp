// Why b2Distance was wrong about one pair, in a sentence: from its algorithm, the pair's size and its answer.
#pragma once

#include <string>

#include "reference/parity/parity.hpp"

namespace tumble::tools {

// For a case in which Box2D is wrong.
std::string why_box2d_failed(const reference::ParityCase& sample);

}  // namespace tumble::tools
