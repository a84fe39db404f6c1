// The trajectories of a shard as an HDF5 file. The only file that includes HDF5.
//
// The data sets are `trajectory` [run, step, body, 6], padded by NaN to the longest run and to the most bodies; `run`,
// the numbers of the runs; `steps` and `bodies`, how much of each row is used; `every`, the steps between two states.
// The file is made in memory, without times, so that the same runs give the same bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sweep/store/trajectory_array.hpp"

namespace tumble::sweep {

struct ShardTrajectory {
    std::uint64_t run = 0;
    TrajectoryArray states;
};

// The bytes of the file. One thread at a time makes one. Throws std::runtime_error if HDF5 fails, for example without
// memory.
std::string to_hdf5(std::span<ShardTrajectory> runs, std::uint64_t every, int bits);

}  // namespace tumble::sweep
