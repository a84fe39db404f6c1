// The runs of a sweep as the episodes of a Minari dataset: main_data.hdf5, as Minari 0.5.0 to 0.5.3 write and read it.
//
// Each episode is a group `episode_I` with `observations` [step + 1, 6 bodies], `actions` [step, n], `rewards`,
// `terminations` and `truncations` [step], and an empty group `infos`. An attribute has the name `options/NAME` for
// what Minari gives as metadata["options"]["NAME"].
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sweep/store/trajectory_array.hpp"

namespace tumble::sweep {

struct Episode {
    std::uint64_t run = 0, seed = 0;
    TrajectoryArray states{};      // of at least two times
    bool is_terminated = false;    // else it is truncated: its time is over
    std::vector<double> action{};  // the same in each step
    double reward = 0.0;           // of the last step; the others have 0
    std::vector<std::pair<std::string, std::variant<double, std::string>>> attributes{};
};

class EpisodeFileWriter {
public:
    // Each observation has `bodies` bodies, missing ones as NaN, in numbers of 32 or 64 bits. Throws FileError, as all
    // functions do.
    EpisodeFileWriter(const std::filesystem::path& file, std::size_t bodies, int bits);
    ~EpisodeFileWriter();  // without commit(): removes what is written
    EpisodeFileWriter(const EpisodeFileWriter&) = delete;
    EpisodeFileWriter& operator=(const EpisodeFileWriter&) = delete;

    void append(const Episode& episode);

    // The bytes are on the disk, and the file does not have its name yet. No episode may follow.
    void save();

    // As save(), and the file has its name. Returns the size in bytes.
    std::uint64_t commit();

private:
    struct Impl;

    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble::sweep
