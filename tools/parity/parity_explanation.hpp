// Explains a wrong answer of b2Distance in a sentence or two, from its algorithm, the size of the pair and the answer.
#pragma once

#include <string>

#include "reference/parity/parity.hpp"

namespace tumble::tools {

// The case must be one in which Box2D is wrong.
std::string why_box2d_failed(const reference::ParityCase& sample);

}  // namespace tumble::tools
