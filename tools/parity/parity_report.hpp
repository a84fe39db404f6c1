// The result of a comparison with Box2D as JSON and as a table for the terminal.
#pragma once

#include <cstdint>
#include <string>

#include "reference/parity/parity.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

void write_parity_json(JsonWriter& json, const reference::ParityResult& result);

// One line per family, and the totals.
std::string parity_table(const reference::ParityResult& result);

// The mean of a sum over the comparisons of a row.
double mean_iterations(std::uint64_t sum, const reference::ParityRow& row);

}  // namespace tumble::tools
