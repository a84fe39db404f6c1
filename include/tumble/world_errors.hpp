// What a world throws, besides std::invalid_argument for a wrong argument.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "tumble/id.hpp"

namespace tumble {

// A snapshot that cannot be loaded: incomplete, damaged, or of another version.
class SnapshotError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A pose or a velocity is not finite. The world can be read, but not stepped.
class SimulationDiverged : public std::runtime_error {
public:
    // The message has the name of the body, by default its index.
    SimulationDiverged(BodyId body, std::uint64_t step, const std::string& name = {});
    BodyId body;             // the one with the lowest id that is not finite
    std::uint64_t step = 0;  // step_count() after the step
};

}  // namespace tumble
