#include "tools/bench/bench_page.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>

#include "reference/box2d_v3/v3_queries.hpp"
#include "tools/machine/engines.hpp"
#include "tools/machine/machine.hpp"
#include "tools/output/html.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/step_stages.hpp"

namespace tumble::tools {

namespace {

// The times of one query or scene, in the unit of the table; 0: not timed.
struct Times {
    std::string name;
    double tumble = 0.0, box2d = 0.0, box2d_v3 = 0.0;
    double ratio() const { return box2d / tumble; }
    double ratio_v3() const { return box2d_v3 / tumble; }
};

std::vector<Times> times_of(const std::vector<QueryBenchResult>& queries) {
    std::vector<Times> times;
    for (const QueryBenchResult& row : queries)
        times.push_back({row.name, row.tumble_ns, row.box2d_ns, row.box2d_v3_ns});
    return times;
}

std::vector<Times> times_of(const std::vector<StepBenchResult>& steps) {
    std::vector<Times> times;
    for (const StepBenchResult& row : steps) times.push_back({row.scene, row.tumble_ms, row.box2d_ms, row.box2d_v3_ms});
    return times;
}

bool has_v3(const std::vector<Times>& all) {
    return std::ranges::any_of(all, [](const Times& times) { return times.box2d_v3 > 0.0; });
}

HtmlCell number(double value) { return {.text = value > 0.0 ? four_digits(value) : "-", .is_number = true}; }
HtmlCell count(std::size_t value) { return {.text = std::to_string(value), .is_number = true}; }

HtmlCell ratio(double value) {
    if (!(value > 0.0)) return {.text = "-", .is_number = true};
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return {.text = text.data(), .is_number = true, .is_alarm = value < 1.0};
}

void add_header(std::vector<std::string>& header, const std::string& unit, bool with_v3) {
    header.insert(header.end(), {"tumble, " + unit, "Box2D, " + unit, "ratio"});
    if (with_v3) header.insert(header.end(), {"Box2D v3, " + unit, "ratio"});
}

void add_cells(std::vector<HtmlCell>& cells, const Times& times, bool with_v3) {
    cells.insert(cells.end(), {number(times.tumble), number(times.box2d), ratio(times.ratio())});
    if (with_v3) cells.insert(cells.end(), {number(times.box2d_v3), ratio(times.ratio_v3())});
}

// Rows from the top down, each with a name: the axis and the size of a plot of level bars.
constexpr double kRowHeight = 26.0;  // px

double row_of(std::size_t index) { return -static_cast<double>(index); }

Plot rows_plot(std::string title, std::string label, const std::vector<std::string>& names) {
    Plot plot{.title = std::move(title), .x = {.label = std::move(label)}, .y = {}, .series = {}};
    const double last = row_of(names.size() - 1);
    plot.y.range = PlotRange{last - 0.6, 0.6};
    for (std::size_t i = 0; i < names.size(); ++i) plot.y.ticks.push_back({row_of(i), names[i]});
    plot.height = 110 + static_cast<int>(kRowHeight * static_cast<double>(names.size()));
    plot.width = 760;
    return plot;
}

// How many times as long as tumble the others take.
Plot ratio_plot(std::string title, const std::vector<Times>& all) {
    std::vector<std::string> names;
    for (const Times& times : all) names.push_back(times.name);
    Plot plot = rows_plot(std::move(title), "time of the other engine / time of tumble", names);
    plot.x.logarithmic = true;
    const bool with_v3 = has_v3(all);
    PlotSeries box2d{.name = "Box2D", .ink = Ink::box2d}, v3{.name = "Box2D v3", .ink = Ink::violet};
    double least = 0.5, most = 2.0;
    const auto add = [&](PlotSeries& series, double value, double upper, double lower) {
        if (!(value > 0.0)) return;
        least = std::min(least, 0.8 * value);
        most = std::max(most, 1.25 * value);
        series.bars.push_back({std::min(1.0, value), std::max(1.0, value), lower, upper});
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        add(box2d, all[i].ratio(), row_of(i) + 0.38, row_of(i) + (with_v3 ? 0.02 : -0.38));
        if (with_v3) add(v3, all[i].ratio_v3(), row_of(i) - 0.02, row_of(i) - 0.38);
    }
    plot.x.range = PlotRange{least, most};
    plot.series.push_back(box2d);
    if (with_v3) plot.series.push_back(v3);
    const double last = row_of(all.size() - 1);
    plot.series.push_back({.name = "as fast as tumble",
                           .ink = Ink::limit,
                           .mark = Mark::dashed,
                           .points = {{1.0, last - 0.6}, {1.0, 0.6}}});
    return plot;
}

// The stages of a step in groups, as a plot has six colours for them.
struct StageGroup {
    const char* name;
    Ink ink;
    double (*ms)(const StageTimes&);
};

double rest_of(const StageTimes& ms) {
    double rest = ms.step;
    for (const StepStage& stage : kStepStages)
        if (stage.ms != &StageTimes::step) rest -= ms.*stage.ms;
    return std::max(rest, 0.0);
}

constexpr std::array<StageGroup, 6> kStageGroups{
    {{"pairs", Ink::tumble, [](const StageTimes& ms) { return ms.pairs; }},
     {"collide", Ink::second, [](const StageTimes& ms) { return ms.collide; }},
     {"prepare", Ink::violet, [](const StageTimes& ms) { return ms.prepare; }},
     {"solve", Ink::teal, [](const StageTimes& ms) { return ms.solve; }},
     {"continuous, proxies", Ink::box2d, [](const StageTimes& ms) { return ms.continuous + ms.proxies; }},
     {"events, sleep, rest", Ink::exact, [](const StageTimes& ms) { return ms.events + ms.sleep + rest_of(ms); }}}};

// Steps of few bodies have no times of stages.
bool has_stages(const StepBenchResult& row) { return rest_of(row.stages) < row.stages.step; }

void add_stages(HtmlPage& page, const std::vector<StepBenchResult>& steps) {
    std::vector<StepBenchResult> timed;
    std::ranges::copy_if(steps, std::back_inserter(timed), has_stages);
    if (timed.empty()) return;
    std::vector<std::string> names;
    for (const StepBenchResult& row : timed) names.push_back(row.scene + ", " + four_digits(row.stages.step) + " ms");
    Plot plot = rows_plot("Stages of a step", "part of the step, %", names);
    plot.x.range = PlotRange{0.0, 100.0};
    for (const StageGroup& group : kStageGroups) plot.series.push_back({.name = group.name, .ink = group.ink});
    for (std::size_t i = 0; i < timed.size(); ++i) {
        double left = 0.0;
        for (std::size_t k = 0; k < kStageGroups.size(); ++k) {
            const double right = left + 100.0 * kStageGroups[k].ms(timed[i].stages) / timed[i].stages.step;
            plot.series[k].bars.push_back({left, right, row_of(i) - 0.36, row_of(i) + 0.36});
            left = right;
        }
    }
    page.heading("Where the time of a step goes");
    page.paragraph(
        "Wall clock, mean of all steps of one more run of tumble. The rest of a step is the time between its "
        "stages. Steps of few bodies are not divided.");
    page.figure(plot);
}

void add_steps(HtmlPage& page, const BenchResult& result) {
    if (result.steps.empty()) return;
    const std::vector<Times> all = times_of(result.steps);
    page.heading("Steps of scenes");
    page.paragraph(std::string(result.options.uses_wall_clock() ? "Wall-clock" : "CPU") +
                   " time per step: the mean of a run, and the median of " + counted(result.options.runs, "run") +
                   ". Box2D has no timeline: a scene with one is not timed in it.");
    page.figure(ratio_plot("Scenes: ratio of the times", all));
    const bool with_v3 = has_v3(all);
    std::vector<std::string> header = {"scene", "bodies", "contacts at the end"};
    add_header(header, "ms", with_v3);
    std::vector<std::vector<HtmlCell>> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const StepBenchResult& row = result.steps[i];
        rows.push_back({{.text = row.scene}, count(row.bodies), count(static_cast<std::size_t>(row.contacts))});
        add_cells(rows.back(), all[i], with_v3);
    }
    page.table(header, rows);
    add_stages(page, result.steps);
}

void add_queries(HtmlPage& page, const std::vector<QueryBenchResult>& queries) {
    if (queries.empty()) return;
    const std::vector<Times> all = times_of(queries);
    page.heading("Queries");
    page.paragraph("CPU time per query, median of the runs. The same pairs of shapes are passed to each engine.");
    page.figure(ratio_plot("Queries: ratio of the times", all));
    const bool with_v3 = has_v3(all);
    std::vector<std::string> header = {"query"};
    add_header(header, "ns", with_v3);
    std::vector<std::vector<HtmlCell>> rows;
    for (const Times& times : all) {
        rows.push_back({{.text = times.name}});
        add_cells(rows.back(), times, with_v3);
    }
    page.table(header, rows);
}

Plot growth_plot(const std::vector<GrowthResult>& rows) {
    constexpr std::array<Ink, kGrowthWorlds.size()> kInks = {Ink::tumble, Ink::violet, Ink::teal};
    Plot plot{.title = "Time of a step for each body",
              .x = {.label = "bodies", .logarithmic = true},
              .y = {.label = "us", .logarithmic = true},
              .series = {}};
    for (std::size_t i = 0; i < kGrowthWorlds.size(); ++i) {
        PlotSeries line{.name = kGrowthWorlds[i].name, .ink = kInks[i], .mark = Mark::line}, points = line;
        points.name.clear();
        points.mark = Mark::points;
        for (const GrowthResult& row : rows)
            if (row.world == line.name) points.points.push_back({static_cast<double>(row.bodies), row.step_us});
        line.points = points.points;
        plot.series.insert(plot.series.end(), {line, points});
    }
    return plot;
}

void add_growth(HtmlPage& page, const BenchResult& result) {
    if (result.growth.empty()) return;
    page.heading("Growth");
    page.paragraph("Wall clock, median of " + counted(result.options.runs, "run") +
                   ". The pile and the rain do not sleep; in the sleeping city nine bodies of a thousand are awake. A "
                   "frame has 1280 x 720 pixels, with all bodies in view, and is written as a PNG file.");
    page.figure(growth_plot(result.growth));
    const std::vector<std::string> header = {
        "world",           "bodies",           "awake",    "step, us a body", "memory, bytes a body",
        "load, us a body", "build, us a body", "frame, ms"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const GrowthResult& row : result.growth)
        rows.push_back({{.text = row.world},
                        count(static_cast<std::size_t>(row.bodies)),
                        count(static_cast<std::size_t>(row.awake)),
                        number(row.step_us),
                        number(row.bytes),
                        number(row.load_us),
                        number(row.build_us),
                        number(row.frame_ms)});
    page.table(header, rows);
}

}  // namespace

std::string bench_page(const BenchResult& result) {
    HtmlPage page("Speed of tumble and Box2D");
    page.paragraph("Processor: " + processor_name() +
                   ". The engines take turns, so that changes of its speed affect them alike.");
    for (const EngineBuild& engine : compared_engines())
        page.paragraph(engine.name + " " + engine.version + ": " + engine.build + ".");
    if (reference::has_box2d_v3()) {
        const EngineBuild v3 = box2d_v3_engine();
        page.paragraph(v3.name + " " + v3.version + ": " + v3.build + ".");
    }
    if (result.options.v3_program)
        page.paragraph(
            "Box2D v3: the program " + result.options.v3_program->path().string() +
            " times the scenes of its own benchmark, and all engines make as many steps as it does. It runs "
            "before each run of tumble: a change of the processor's speed between the two changes their ratio.");
    add_steps(page, result);
    if (result.worlds)
        page.paragraph(
            std::to_string(result.world_count) + " worlds of ten bodies: " + four_digits(result.worlds->serial_rate) +
            " steps/s on one thread, " + four_digits(result.worlds->parallel_rate) + " on all, by wall clock.");
    add_growth(page, result);
    add_queries(page, result.queries);
    return page.str();
}

}  // namespace tumble::tools
