// The brute-force oracle under the tests' name.
#pragma once

#include "reference/exact/brute_distance.hpp"

namespace tumble_test {

using namespace tumble::reference::brute;

}  // namespace tumble_test
