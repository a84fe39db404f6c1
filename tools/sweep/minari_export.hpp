// The trajectories of a complete sweep as a dataset that Minari 0.5 loads: an episode for each run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tumble::tools {

struct MinariOptions {
    std::filesystem::path folder;  // of the sweep
    std::filesystem::path root;    // of datasets, as Minari's MINARI_DATASETS_PATH
    std::string id;                // of the dataset, and its folder below the root: "NAME-vN" or "NAMESPACE/NAME-vN"
    std::string reward{};          // the column of the table that is the reward of the last step; empty: 0
    bool force = false;            // replace a dataset
};

struct MinariReport {
    std::filesystem::path dataset;  // its folder
    std::uint64_t episodes = 0, steps = 0;
    std::uint64_t left_out = 0;  // runs that are not `ok`, or have a single state
    std::uint64_t bytes = 0;
};

// Writes ROOT/ID/data/main_data.hdf5 and then metadata.json, without which Minari finds no dataset. The same sweep
// gives the same bytes. Memory holds one run at a time. Throws FileError, also for a sweep that is not complete or has
// no HDF5 trajectories; InputError for a wrong checksum, and for a column that does not exist or is no number; and
// Interrupted.
MinariReport export_minari(const MinariOptions& options);

}  // namespace tumble::tools
