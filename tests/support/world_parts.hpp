// A world taken apart into what a snapshot contains, for tests that look into its state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dynamics/bodies/divergence.hpp"
#include "world/snapshot.hpp"

namespace tumble::test {

struct WorldParts {
    WorldDef def;
    Simulation simulation;
    std::uint64_t step_count = 0;
    std::uint32_t diverged_body = kNoBody;

    explicit WorldParts(const std::vector<std::byte>& bytes) {
        read_snapshot(bytes, snapshot());
        simulation.settings = make_settings(def);
    }

    SnapshotParts snapshot() { return {def, simulation, step_count, diverged_body}; }
    std::vector<std::byte> save() { return write_snapshot(snapshot()); }
};

}  // namespace tumble::test
