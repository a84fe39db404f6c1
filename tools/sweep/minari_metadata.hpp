// The metadata of a Minari dataset: metadata.json, as Minari 0.5.0 to 0.5.3 read it.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sweep/store/manifest.hpp"
#include "tools/sweep/minari_export.hpp"

namespace tumble::tools {

struct ParameterRange {
    double lower = 0.0, upper = 0.0;
};

// What all episodes of a dataset have in common.
struct EpisodeShape {
    std::size_t bodies = 0;  // the most of any run
    int bits = 32;
    std::uint64_t every = 1;                          // steps of the simulation in one of an episode
    std::map<std::size_t, ParameterRange> actions{};  // by column: parameters that are numbers in all episodes
};

// "NAME-vN" or "NAMESPACE/NAME-vN", of letters, digits, "-" and "_", with at least two in a namespace: a path that
// stays below the root of datasets.
bool is_dataset_id(const std::string& id);

std::string minari_metadata(const std::string& id, const sweep::SweepHeader& header, const EpisodeShape& shape,
                            const MinariReport& report);

}  // namespace tumble::tools
