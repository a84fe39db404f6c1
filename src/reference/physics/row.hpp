// The rows of the page of evidence: what each measures, against which exact answer and bar, and what was found.
#pragma once

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/physics/engine_run.hpp"
#include "tumble/math.hpp"

namespace tumble::reference {

// The values of a quantity that pass, both ends included.
struct Bar {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

constexpr Bar within(double exact, double tolerance) { return {exact - tolerance, exact + tolerance}; }
constexpr Bar at_most(double upper) { return {.upper = upper}; }
constexpr Bar at_least(double lower) { return {.lower = lower}; }

// One quantity under one condition, measured in each engine: once, or once for each phase, angle or position.
struct Finding {
    std::string condition;  // "60 Hz, 4 sub-steps"
    std::string quantity;   // "speed along the floor"
    std::string unit;       // empty for ratios and counts
    std::optional<double> exact{};
    Bar bar{};
    std::array<std::vector<double>, std::size(kEngines)>
        values{};  // [Engine]; a value that was not reached is infinite

    void add(Engine engine, double value) { values[static_cast<std::size_t>(engine)].push_back(value); }

    // The value farthest from the exact one, or without one the value nearest to failing. NaN if nothing was measured.
    double worst(Engine engine) const;
    bool holds(Engine engine) const;  // every value is within the bar, and there is one
};

// A count that must be 0.
Finding make_count(std::string condition, std::string quantity);

// Runs the scene in each engine for a time (s), and adds what value(run) finds at its end.
template <class Value>
void add_after(Finding& finding, const Scene& scene, double seconds, Value&& value) {
    for (const Engine engine : kEngines) {
        const auto run = start(engine, scene);
        run->run_until(seconds);
        finding.add(engine, value(*run));
    }
}

// A curve or a set of points of a chart. `engine` is empty for the exact answer.
struct Curve {
    std::string name;
    std::optional<Engine> engine{};
    bool joined = true;  // by lines
    std::vector<DVec2> points{};
};

struct Chart {
    std::string title;
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves{};
    std::optional<Bar> bar{};  // of y
};

struct RowResult {
    std::vector<Finding> findings;
    std::vector<Chart> charts;
    std::string failure;  // why an engine stopped: a state that is not finite
    double seconds = 0.0;
    bool holds(Engine engine = Engine::tumble) const;
};

// How much is measured: the short form takes fewer phases and leaves out what takes seconds.
struct Effort {
    bool is_short = false;
    int choose(int full, int few) const { return is_short ? few : full; }
};

struct PhysicsRow {
    std::string_view name;     // "A1"
    std::string_view title;    // "Friction of an oblique impact"
    std::string_view setup;    // the scene, in one or two sentences
    std::string_view formula;  // the exact answer, how it follows, and its source
    std::string_view bar;      // what must hold, in words
    void (*measure)(RowResult&, const Effort&) = nullptr;
};

// Measures the row in both engines. A state that is not finite ends the row, which then does not hold.
RowResult run_row(const PhysicsRow& row, const Effort& effort);

}  // namespace tumble::reference
