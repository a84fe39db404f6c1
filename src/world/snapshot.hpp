// Snapshots: a world's whole state as bytes, and back.
//
// magic (8 bytes), version (4), size of the payload (8), its xxHash64 (8), payload: every number of the state in the
// order of the members, little-endian. What a step computes afresh (blocks, colours, times) is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/state/simulation.hpp"
#include "tumble/world.hpp"

namespace tumble {

// What is saved of a world.
struct SnapshotParts {
    WorldDef& def;
    Simulation& simulation;
    std::uint64_t& step_count;
    std::uint32_t& diverged_body;
};

std::vector<std::byte> write_snapshot(const SnapshotParts& parts);

// Replaces the parts. Throws SnapshotError, and may leave them half read then.
void read_snapshot(std::span<const std::byte> bytes, const SnapshotParts& parts);

}  // namespace tumble
