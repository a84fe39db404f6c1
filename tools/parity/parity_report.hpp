// A parity result as people and scripts read it: the contract's JSON, a table for the terminal, a page for the browser.
#pragma once

#include <string>

#include "reference/parity/parity.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

void write_parity_json(JsonWriter& json, const reference::ParityResult& result);

// One line a family, and the totals.
std::string parity_table(const reference::ParityResult& result);

// A self-contained HTML document; `what` says what was compared ("10 000 000 random and hard pairs").
std::string parity_page(const reference::ParityResult& result, const std::string& what);

}  // namespace tumble::tools
