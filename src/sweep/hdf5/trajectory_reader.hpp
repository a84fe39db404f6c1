// Reads the file of a TrajectoryFileWriter, run by run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "sweep/hdf5/trajectory_file.hpp"

namespace tumble::sweep {

class TrajectoryReader {
public:
    // Throws FileError for a file that cannot be read, or is none of a shard.
    explicit TrajectoryReader(const std::filesystem::path& file);
    ~TrajectoryReader();
    TrajectoryReader(const TrajectoryReader&) = delete;
    TrajectoryReader& operator=(const TrajectoryReader&) = delete;

    std::size_t size() const noexcept { return runs_.size(); }  // runs
    std::uint64_t every() const noexcept { return every_; }     // steps between two states
    int bits() const noexcept { return bits_; }                 // of a number
    std::size_t most_bodies() const noexcept { return most_bodies_; }

    std::uint64_t run(std::size_t index) const { return runs_.at(index); }

    // Throws FileError for a file that is damaged, and for a run of more than 2 GiB.
    ShardTrajectory read(std::size_t index) const;

private:
    struct Impl;

    std::unique_ptr<Impl> impl_;
    std::vector<std::uint64_t> runs_{}, steps_{}, bodies_{}, stopped_{};
    std::uint64_t every_ = 1;
    int bits_ = 32;
    std::size_t most_bodies_ = 0;
};

}  // namespace tumble::sweep
