// The result of a comparison with Box2D as JSON and as a table for the terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "reference/parity/parity.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

// The same pairs, compared with Box2D and, if asked for, with Box2D v3: the families are the same in both.
struct ParityResults {
    reference::ParityResult box2d;
    std::optional<reference::ParityResult> box2d_v3{};
};

void write_parity_json(JsonWriter& json, const ParityResults& results);

// One line per family, and the totals.
std::string parity_table(const ParityResults& results);

// The mean of a sum over the comparisons of a row.
double mean_iterations(std::uint64_t sum, const reference::ParityRow& row);

}  // namespace tumble::tools
