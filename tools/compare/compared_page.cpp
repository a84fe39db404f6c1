#include "tools/compare/compared_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tools/compare/compared_plots.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/machine/engines.hpp"
#include "tools/output/html.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

std::string exact_digits(double number) {
    std::string text;
    append_number(text, number);
    return text;
}

// "0.0166667 s": enough to tell steps apart.
std::string brief_seconds(double time) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g s", time);
    return text.data();
}

std::string at_step(const ComparedStep& step) {
    return brief_seconds(step.time) + " (step " + std::to_string(step.step) + ")";
}

// The step in which a kind of difference is largest.
const ComparedStep& largest_step(const ComparedRuns& runs, std::size_t kind) {
    return *std::ranges::max_element(runs.steps, {},
                                     [kind](const ComparedStep& step) { return step.largest[kind].value; });
}

HtmlCell right_cell(const std::string& text) { return {.text = text, .is_number = true}; }

void add_bounds(HtmlPage& page, const ComparedRuns& runs) {
    const std::vector<std::string> header{"a position differs by more than", "first at", "body"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const auto& [bound, text] : {std::pair(0.0, "0"), std::pair(1e-3, "1 mm"), std::pair(1e-2, "1 cm"),
                                      std::pair(0.1, "10 cm"), std::pair(1.0, "1 m")}) {
        const ComparedStep* const step = first_beyond(runs, kPosition, bound);
        rows.push_back({right_cell(text),
                        {.text = step ? at_step(*step) : "never"},
                        {.text = step ? step->largest[kPosition].body : ""}});
    }
    page.table(header, rows);
}

void add_largest(HtmlPage& page, const ComparedRuns& runs) {
    const std::vector<std::string> header{"largest difference of", "value", "unit", "body", "at"};
    std::vector<std::vector<HtmlCell>> rows;
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        const LargestDifference& largest = runs.comparison.largest[kind];
        rows.push_back({{.text = std::string(kKinds[kind].name)},
                        right_cell(exact_digits(largest.value)),
                        {.text = std::string(kKinds[kind].unit)},
                        {.text = largest.body},
                        {.text = largest.value > 0.0 ? at_step(largest_step(runs, kind)) : ""}});
    }
    page.table(header, rows);
}

void add_plots(HtmlPage& page, const ComparedRuns& runs) {
    constexpr int kPlotWidth = 600, kPlotHeight = 330;  // px: two in a row of the page
    page.begin_figures();
    page.figure(distance_plot(runs, kPlotWidth, kPlotHeight));
    page.figure(growth_plot(runs, kPlotWidth, kPlotHeight));
    const bool has_energy = std::isfinite(runs.steps.front().energy_a) || std::isfinite(runs.steps.front().energy_b);
    if (has_energy) page.figure(energy_plot(runs, kPlotWidth, kPlotHeight));
    page.end_figures();
}

}  // namespace

std::vector<Moment> moments_of(const ComparedRuns& runs) {
    std::vector<Moment> moments;
    const auto add = [&](std::uint64_t step, const std::string& what) {
        const auto known = std::ranges::find(moments, step, &Moment::step);
        if (known == moments.end()) return moments.push_back({step, what});
        known->what += ", " + what;
    };
    if (runs.steps.empty()) return moments;
    add(runs.steps.front().step, "start");
    if (runs.comparison.first) add(runs.comparison.first->step, "first difference");
    for (const auto& [bound, text] : {std::pair(0.01, "1 cm apart"), std::pair(0.1, "10 cm apart")})
        if (const ComparedStep* const step = first_beyond(runs, kPosition, bound)) add(step->step, text);
    if (runs.comparison.largest[kPosition].value > 0.0)
        add(largest_step(runs, kPosition).step, "positions differ most");
    add(runs.steps.back().step, "end");
    std::ranges::sort(moments, {}, &Moment::step);
    return moments;
}

std::string compared_page(const std::string& title, const ComparedRuns& runs, const std::vector<Moment>& moments,
                          const std::vector<PairPicture>& pictures, const std::string& player, double tolerance) {
    HtmlPage page(title);
    page.paragraph(runs.name_a + " beside " + runs.name_b + ".");
    if (runs.name_b.starts_with("Box2D")) {
        for (const EngineBuild& engine : compared_engines())
            page.paragraph(engine.name + " " + engine.version + ": " + engine.build + ".");
        page.paragraph(
            "Both make the same steps from the same start. Collisions of many bodies are chaotic: two engines part "
            "there even if both obey the laws of motion. The laws themselves can be judged: compare the energies "
            "below, and see tumble physics for exact answers.");
    }
    for (const std::string& note : runs.notes) page.paragraph("Box2D: " + note + ".");
    constexpr int kPlayerHeight = 680;  // px
    if (!player.empty()) page.embedded("Both runs in motion", player, kPlayerHeight);
    page.preformatted(to_text(runs.comparison, tolerance));
    if (runs.steps.empty()) return page.str();
    add_plots(page, runs);
    add_bounds(page, runs);
    add_largest(page, runs);
    for (const PairPicture& picture : pictures) {
        const auto moment = std::ranges::find(moments, picture.step, &Moment::step);
        page.picture(picture.image,
                     moment->what + ": " + brief_seconds(picture.time) + ", step " + std::to_string(picture.step));
    }
    return page.str();
}

}  // namespace tumble::tools
