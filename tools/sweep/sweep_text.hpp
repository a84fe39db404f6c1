// What the commands of sweeps print: texts and JSON documents.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/sweep/estimate.hpp"
#include "tools/sweep/sweep_work.hpp"
#include "tools/sweep/verification.hpp"

namespace tumble::tools {

struct SweepStatus {
    std::uint64_t runs = 0, shards = 0, stored_shards = 0;
    std::map<std::string, std::uint64_t> outcomes{};
    ShardRanges missing{};
    std::uint64_t damaged_lines = 0;  // of the manifest
    bool complete = false;
};

// Throws FileError if there is no sweep.
SweepStatus status_of(const std::filesystem::path& folder);

std::string to_text(const SweepStatus& status);
std::string to_json(const SweepStatus& status);
std::string to_text(const sweep::Plan& plan, const SweepReport& report);
std::string to_json(const SweepReport& report);
std::string to_text(const sweep::Plan& plan, const SweepEstimate& estimate);
std::string to_json(const SweepEstimate& estimate);
std::string to_text(const Verification& verification);
std::string to_json(const Verification& verification);

}  // namespace tumble::tools
