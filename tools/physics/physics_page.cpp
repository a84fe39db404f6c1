#include "tools/physics/physics_page.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "tools/machine/engines.hpp"
#include "tools/output/html.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

namespace {

using reference::Chart;
using reference::Curve;
using reference::Engine;
using reference::Finding;

HtmlCell verdict(bool holds) { return {.text = holds ? "holds" : "fails", .is_alarm = !holds, .is_good = holds}; }
HtmlCell plain(std::string_view text) { return {.text = std::string(text)}; }
HtmlCell finding_number(double value) { return {.text = value_text(value), .is_number = true}; }

HtmlCell engine_value(const Finding& finding, Engine engine) {
    HtmlCell cell = finding_number(finding.worst(engine));
    cell.is_alarm = !finding.holds(engine);
    return cell;
}

std::string with_unit(const Finding& finding) {
    return finding.unit.empty() ? finding.quantity : finding.quantity + ", " + finding.unit;
}

std::string seconds_text(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f s", seconds);
    return text.data();
}

// The finding that tells most about a row: the first that fails, else the first.
const Finding* telling(const reference::RowResult& result) {
    for (const Finding& finding : result.findings)
        if (!finding.holds(Engine::tumble)) return &finding;
    return result.findings.empty() ? nullptr : &result.findings.front();
}

void add_summary(HtmlPage& page, const PhysicsResult& result) {
    page.paragraph(
        std::to_string(result.holding()) + " of " + counted(result.rows.size(), "row") + " hold, " +
        std::to_string(result.holding(Engine::at_step_end)) +
        " with impacts at the end of the step. Each row compares tumble, tumble with the world's option "
        "\"impacts\": \"at_step_end\", and Box2D with an exact answer. The same scene runs in each, with the "
        "same step; Box2D makes 8 velocity and 3 position iterations in it. The "
        "table shows one condition of each row: the first that fails, or the first. Values are the worst of "
        "all phases. The " +
        std::string(result.is_short ? "short" : "full") + " form took " + seconds_text(result.seconds) + ".");
    for (const EngineBuild& engine : compared_engines())
        page.paragraph(engine.name + " " + engine.version + ": " + engine.build + ".");
    const std::vector<std::string> header = {"row",    "subject",     "measured", "condition", "exact", "passes",
                                             "tumble", "at step end", "Box2D",    "verdict",   "time"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const MeasuredRow& measured : result.rows) {
        std::vector<HtmlCell> cells = {plain(measured.row->name), plain(measured.row->title)};
        if (const Finding* finding = telling(measured.result)) {
            cells.push_back(plain(with_unit(*finding)));
            cells.push_back(plain(finding->condition));
            cells.push_back(finding_number(finding->exact.value_or(NAN)));
            cells.push_back({.text = bar_text(finding->bar), .is_number = true});
            cells.push_back(engine_value(*finding, Engine::tumble));
            cells.push_back(engine_value(*finding, Engine::at_step_end));
            cells.push_back(engine_value(*finding, Engine::box2d));
        } else {
            cells.resize(cells.size() + 7);
        }
        cells.push_back(verdict(measured.result.holds()));
        cells.push_back({.text = seconds_text(measured.result.seconds), .is_number = true});
        rows.push_back(cells);
    }
    page.table(header, rows);
}

Ink ink_of(Engine engine) {
    constexpr std::array<Ink, 3> kInks = {Ink::tumble, Ink::second, Ink::box2d};
    return kInks[static_cast<std::size_t>(engine)];
}

PlotSeries series_of(const Curve& curve) {
    const Ink ink = curve.engine ? ink_of(*curve.engine) : Ink::exact;
    const Mark joined = curve.engine ? Mark::line : Mark::dashed;
    return {.name = curve.name, .ink = ink, .mark = curve.joined ? joined : Mark::points, .points = curve.points};
}

Plot plot_of(const Chart& chart) {
    Plot plot{.title = chart.title,
              .x = {.label = chart.x_label, .logarithmic = chart.log_x},
              .y = {.label = chart.y_label, .logarithmic = chart.log_y},
              .series = {}};
    for (const Curve& curve : chart.curves) plot.series.push_back(series_of(curve));
    if (chart.bar) plot.band = PlotBand{.name = "passes", .lower = chart.bar->lower, .upper = chart.bar->upper};
    return plot;
}

void add_findings(HtmlPage& page, const std::vector<Finding>& findings) {
    const std::vector<std::string> header = {"condition", "measured",    "exact", "passes",
                                             "tumble",    "at step end", "Box2D", "verdict"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const Finding& finding : findings)
        rows.push_back({plain(finding.condition), plain(with_unit(finding)),
                        finding_number(finding.exact.value_or(NAN)), plain(bar_text(finding.bar)),
                        engine_value(finding, Engine::tumble), engine_value(finding, Engine::at_step_end),
                        engine_value(finding, Engine::box2d), verdict(finding.holds(Engine::tumble))});
    page.table(header, rows);
}

void add_row(HtmlPage& page, const MeasuredRow& measured) {
    const reference::PhysicsRow& row = *measured.row;
    page.heading(std::string(row.name) + "  " + std::string(row.title));
    page.paragraph(row.setup);
    page.paragraph("Exact: " + std::string(row.formula) + " To pass: " + std::string(row.bar) + ".");
    if (!measured.result.failure.empty()) page.paragraph("The run ended: " + measured.result.failure);
    add_findings(page, measured.result.findings);
    page.begin_figures();
    for (const Chart& chart : measured.result.charts) page.figure(plot_of(chart));
    page.end_figures();
}

}  // namespace

std::string physics_page(const PhysicsResult& result) {
    HtmlPage page("Physics of tumble against exact answers and Box2D");
    add_summary(page, result);
    for (const MeasuredRow& measured : result.rows) add_row(page, measured);
    return page.str();
}

}  // namespace tumble::tools
