// The trajectories of a shard as an HDF5 file.
//
// The data sets are `trajectory` [run, step, body, 6], padded by NaN to the longest run and to the most bodies; `run`,
// the numbers of the runs; `steps` and `bodies`, how much of each row is used; `stopped`, 1 for a run that an event of
// its scene ended; `every`, the steps between two states.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "sweep/store/manifest.hpp"
#include "sweep/store/trajectory_array.hpp"

namespace tumble::sweep {

struct ShardTrajectory {
    std::uint64_t run = 0;
    bool is_stopped = false;  // by an event of the scene, before its duration was over
    TrajectoryArray states;
};

// What all runs of a file have in common.
struct TrajectoryFormat {
    std::uint64_t every = 1;  // steps between two states
    int bits = 32;            // of a number: 32 or 64
};

// Writes the runs one by one. The bytes depend on the runs and their order alone. Several threads may write a file
// each.
class TrajectoryFileWriter {
public:
    // Throws FileError, as all functions do.
    TrajectoryFileWriter(const std::filesystem::path& folder, const std::string& name, const TrajectoryFormat& format);
    ~TrajectoryFileWriter();  // without commit(): removes what is written
    TrajectoryFileWriter(const TrajectoryFileWriter&) = delete;
    TrajectoryFileWriter& operator=(const TrajectoryFileWriter&) = delete;

    void append(ShardTrajectory run);

    // As StoredFileWriter::commit().
    StoredFile commit();

private:
    struct Impl;

    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble::sweep
