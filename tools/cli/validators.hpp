// Validators of numeric options. Unlike those of CLI11 they refuse NaN, and -1 for an unsigned number.
#pragma once

#include <cstdint>

namespace CLI {
class Validator;
}

namespace tumble::tools {

// Both bounds are included.
CLI::Validator number_from_to(double lowest, double highest);
CLI::Validator whole_number_from_to(std::uint64_t lowest, std::uint64_t highest);

// Any unsigned 64-bit number.
CLI::Validator any_seed();

}  // namespace tumble::tools
