// Compares two lists of events, as runs write them to events.csv.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tumble::tools {

struct EventDifference {
    std::uint64_t step = 0;
    double time = 0.0;       // s
    std::string event;       // the kind, as in the column `event`
    std::string a, b;        // the names of its bodies or joints
    std::string what;        // "only A has it"; empty if both runs have the event
    std::string component;   // the column that differs, if both have it
    std::string in_a, in_b;  // the texts of that column
};

struct EventComparison {
    std::uint64_t common = 0, only_a = 0, only_b = 0;  // numbers of events; of common ones the numbers may differ
    std::optional<EventDifference> first;
};

// An event is the same in both runs if its step, kind and names are. Its numbers differ if they are farther apart than
// the tolerance (m, m/s). The order of the events of one step is no difference. Throws FileError or InputError.
EventComparison compare_event_files(const std::filesystem::path& file_a, const std::filesystem::path& file_b,
                                    double tolerance);

std::string to_text(const EventComparison& comparison);
std::string to_json(const EventComparison& comparison);

}  // namespace tumble::tools
