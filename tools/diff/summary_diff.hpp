// Compares two summaries of runs (summary.json). Times of the wall clock are listed apart and not compared.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::tools {

struct SummaryValue {
    std::string pointer;  // "/counters/contacts"
    std::string a, b;     // JSON; empty if the summary has no such value
};

struct SummaryComparison {
    std::vector<SummaryValue> different;
    std::vector<SummaryValue> timings;  // of which both have one
    std::size_t equal_count = 0;        // values that are equal
};

// Whether the file is an object with the keys of a summary.
bool is_summary_file(const std::filesystem::path& file);

// Numbers are equal if they are no farther apart than the tolerance. Folders of files are not compared: each run has
// its own. Throws FileError or InputError.
SummaryComparison compare_summaries(const std::filesystem::path& file_a, const std::filesystem::path& file_b,
                                    double tolerance);

std::string to_text(const SummaryComparison& comparison);
std::string to_json(const SummaryComparison& comparison);

}  // namespace tumble::tools
