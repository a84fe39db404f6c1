// The rows of `tumble physics` as JSON and as a table for the terminal.
#pragma once

#include <string>
#include <vector>

#include "reference/physics/row.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

// A row and what was measured.
struct MeasuredRow {
    const reference::PhysicsRow* row = nullptr;
    reference::RowResult result;
};

struct PhysicsResult {
    std::vector<MeasuredRow> rows;
    bool is_short = false;
    double seconds = 0.0;
    int holding(reference::Engine engine = reference::Engine::tumble) const;  // rows
    bool passed() const { return holding() == static_cast<int>(rows.size()); }
};

void write_physics_json(JsonWriter& json, const PhysicsResult& result);

// Two lines per row and finding: what must hold, and the worst values of both engines.
std::string physics_table(const PhysicsResult& result);

// A value as tables print it: four digits, "not reached" if it is infinite, "-" if it was not measured.
std::string value_text(double value);

// "4.48 to 4.52", "at most 0.01": the values that pass.
std::string bar_text(const reference::Bar& bar);

}  // namespace tumble::tools
