// Snapshots: the whole state of a world as bytes.
//
// Magic (8 bytes), version (4), size of the payload (8), its xxHash64 (8), payload. The payload has the definition, the
// step count, the index of a diverged body and SimulationState: every number in the order of the members,
// little-endian. Scratch memory and measurements of the last step (StepScratch, StepReport) are left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/state/simulation.hpp"
#include "tumble/world.hpp"

namespace tumble {

// The parts of a world that a snapshot contains.
struct SnapshotParts {
    WorldDef& def;
    Simulation& simulation;
    std::uint64_t& step_count;
    std::uint32_t& diverged_body;
};

std::vector<std::byte> write_snapshot(const SnapshotParts& parts);

// Replaces the parts. Throws SnapshotError if the bytes are not a whole, undamaged snapshot of this version, or if the
// state that they contain breaks an invariant; the parts are unspecified then.
void read_snapshot(std::span<const std::byte> bytes, const SnapshotParts& parts);

}  // namespace tumble
