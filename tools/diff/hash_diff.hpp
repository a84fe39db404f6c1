// Compares two lists of state hashes, as `run --hashes` writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tumble::tools {

struct HashDifference {
    std::uint64_t step = 0;
    std::string hash_a, hash_b;  // "none" after the end of a list
};

struct HashComparison {
    std::uint64_t steps = 0;  // equal steps before the first difference
    std::optional<HashDifference> first;
};

// Throws FileError or InputError.
HashComparison compare_hash_files(const std::string& file_a, const std::string& file_b);

std::string to_text(const HashComparison& comparison);
std::string to_json(const HashComparison& comparison);

}  // namespace tumble::tools
