#include "tools/physics/physics_report.hpp"

#include <algorithm>
#include <cmath>

#include "tools/machine/engines.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

namespace {

using reference::Bar;
using reference::Engine;
using reference::Finding;

void write_values(JsonWriter& json, std::string_view name, const Finding& finding, Engine engine) {
    json.key(name).open_array();
    for (const double value : finding.values[static_cast<std::size_t>(engine)]) json.value(value);
    json.close_array();
}

void write_finding(JsonWriter& json, const Finding& finding) {
    json.open_object()
        .member("condition", finding.condition)
        .member("quantity", finding.quantity)
        .member("unit", finding.unit)
        .member("exact", finding.exact.value_or(NAN))
        .member("lower", finding.bar.lower)
        .member("upper", finding.bar.upper)
        .member("holds", finding.holds(Engine::tumble))
        .member("worst_tumble", finding.worst(Engine::tumble))
        .member("worst_at_step_end", finding.worst(Engine::at_step_end))
        .member("worst_box2d", finding.worst(Engine::box2d));
    write_values(json, "tumble", finding, Engine::tumble);
    write_values(json, "at_step_end", finding, Engine::at_step_end);
    write_values(json, "box2d", finding, Engine::box2d);
    json.close_object();
}

// Text of at least `width` characters.
std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.resize(width, ' ');
    return text;
}

std::string finding_line(const Finding& finding) {
    const std::string unit = finding.unit.empty() ? "" : ", " + finding.unit;
    return "  " + padded(finding.condition + ": " + finding.quantity + unit, 72) + " " +
           padded(bar_text(finding.bar), 20) + " " + padded(value_text(finding.worst(Engine::tumble)), 12) +
           padded(value_text(finding.worst(Engine::at_step_end)), 12) +
           padded(value_text(finding.worst(Engine::box2d)), 12) + (finding.holds(Engine::tumble) ? "holds" : "FAILS") +
           "\n";
}

}  // namespace

int PhysicsResult::holding(Engine engine) const {
    return static_cast<int>(
        std::ranges::count_if(rows, [&](const MeasuredRow& row) { return row.result.holds(engine); }));
}

std::string value_text(double value) {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "not reached";
    return four_digits(value);
}

std::string bar_text(const Bar& bar) {
    if (!std::isfinite(bar.lower)) return "at most " + value_text(bar.upper);
    if (!std::isfinite(bar.upper)) return "at least " + value_text(bar.lower);
    return value_text(bar.lower) + " to " + value_text(bar.upper);
}

void write_physics_json(JsonWriter& json, const PhysicsResult& result) {
    json.open_object().member("short", result.is_short).key("rows").open_array();
    for (const MeasuredRow& measured : result.rows) {
        json.open_object()
            .member("name", measured.row->name)
            .member("title", measured.row->title)
            .member("formula", measured.row->formula)
            .member("bar", measured.row->bar)
            .member("holds", measured.result.holds())
            .member("holds_at_step_end", measured.result.holds(Engine::at_step_end))
            .member("failure", measured.result.failure)
            .member("seconds", measured.result.seconds)
            .key("findings")
            .open_array();
        for (const Finding& finding : measured.result.findings) write_finding(json, finding);
        json.close_array().close_object();
    }
    json.close_array()
        .member("holding", result.holding())
        .member("holding_at_step_end", result.holding(Engine::at_step_end))
        .member("passed", result.passed())
        .member("seconds", result.seconds);
    write_engines(json);
    json.close_object();
}

std::string physics_table(const PhysicsResult& result) {
    std::string table = padded("row: condition: quantity", 75) + padded("passes", 21) + padded("tumble", 12) +
                        padded("at step end", 12) + padded("Box2D", 12) + "\n";
    for (const MeasuredRow& measured : result.rows) {
        table += std::string(measured.row->name) + "  " + std::string(measured.row->title) + ": " +
                 (measured.result.holds() ? "holds" : "FAILS") + "\n";
        for (const Finding& finding : measured.result.findings) table += finding_line(finding);
        if (!measured.result.failure.empty()) table += "  " + measured.result.failure + "\n";
    }
    return table + std::to_string(result.holding()) + " of " + counted(result.rows.size(), "row") + " hold, " +
           std::to_string(result.holding(Engine::at_step_end)) + " with impacts at the end of the step\n" +
           engines_text();
}

}  // namespace tumble::tools
