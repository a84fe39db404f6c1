#include "tools/parity/parity_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "reference/families/cast_families.hpp"
#include "reference/families/pair_families.hpp"
#include "tools/output/html.hpp"
#include "tools/parity/parity_explanation.hpp"
#include "tools/parity/parity_plots.hpp"

namespace tumble::tools {

namespace {

using reference::ParityCase;
using reference::ParityResult;
using reference::ParityRow;

// Digits in groups of three, as people read them.
std::string grouped(std::uint64_t count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
        text += digits[i];
    }
    return text;
}

std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

double mean_iterations(std::uint64_t sum, const ParityRow& row) {
    return row.comparisons == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(row.comparisons);
}

HtmlCell count_cell(std::uint64_t count, bool is_alarm = false) {
    return {.text = grouped(count), .is_number = true, .is_alarm = is_alarm && count > 0};
}

HtmlCell number_cell(double value) { return {.text = short_number(value), .is_number = true}; }

void add_summary(HtmlPage& page, const ParityResult& result, const std::string& what) {
    const ParityRow total = result.total();
    page.paragraph(what + ", seed " + std::to_string(result.seed) +
                   ": each distance was computed by tumble and by Box2D's b2Distance (" + grouped(total.comparisons) +
                   " comparisons, shapes with radii once without and once with them), and " +
                   grouped(total.checked_exactly) + " of them were decided by exact arithmetic, in " +
                   short_number(result.seconds) + " s.");
    page.paragraph("Wrong answers of tumble: " + grouped(total.ours_wrong) +
                   ". Wrong answers of b2Distance: " + grouped(total.box2d_wrong) + " (" +
                   grouped(total.box2d_wrong_flag) + " by the overlap flag, " + grouped(total.box2d_wrong_distance) +
                   " by the distance). Neither wrong, yet apart: " + grouped(total.ill_conditioned) +
                   " ill-conditioned inputs.");
}

void add_definitions(HtmlPage& page) {
    page.heading("What counts as wrong");
    page.paragraph(
        "tumble promises bounds: it is wrong if the exact signed distance lies outside of its [lower, upper], if its "
        "status "
        "(separated, touching, overlapping) contradicts the exact sign, if its certificate does not prove them, or if "
        "its distance is off by more than rounding in double "
        "explains, 16 to 20 u L, so that wide bounds do not count as right. Of moving shapes (rays, casts, times of "
        "impact) it is wrong if a "
        "distance below the target by 4 E goes unnoticed, if there is no contact within 4 E where it says so, or if "
        "its bracket does "
        "not hold, E being its own bound of about 24 u L; errors are the gaps left at the fraction. L is the sum of "
        "the sizes of the cores, their radii and "
        "the offset of their positions, u = 1.1e-16.");
    page.paragraph(
        "b2Distance promises a float: it is wrong if its distance is off by more than 4 eps S, S being the largest "
        "world coordinate "
        "of the pair and eps = 1.19e-7, or if it gives 0, which is how it says overlap, where the exact distance is "
        "positive, or "
        "something else where that is negative. A pair is ill-conditioned if the engines differ by more than that and "
        "neither is "
        "wrong. Every pair over the tolerance is checked exactly, as are the first pairs of each family and a seeded "
        "share of the rest.");
    page.paragraph(
        "Why b2Distance fails where it does: it works in float and in world coordinates, so that all it sees of a pair "
        "S metres from "
        "the origin is rounded to eps S, 1 mm at 10 km; where the gap is smaller than that, the overlap flag is a coin "
        "toss. "
        "A search direction shorter than 1.2e-7 m ends its loop, an absolute length which small shapes fall below; if "
        "that happens "
        "with the origin on an edge of its simplex, deep overlaps come out as a tiny distance. And the weights of its "
        "triangles are "
        "products of four coordinates, which leave the range of float for shapes below a nanometre or above a million "
        "kilometres. "
        "tumble works in double relative to one shape, has no absolute length in any query, and subtracts the radii "
        "last.");
}

void add_family_table(HtmlPage& page, const ParityResult& result) {
    page.heading("Family by family");
    const std::vector<std::string> header = {
        "family",   "pairs",        "compared",  "checked exactly",  "tumble wrong", "Box2D wrong",
        "by flag",  "by distance",  "ill-cond.", "error tumble (m)", "in u L",       "error Box2D (m)",
        "in eps S", "iter. tumble", "Box2D",     "max tumble",       "max Box2D"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const ParityRow& row : result.families)
        rows.push_back({{.text = row.name},
                        count_cell(row.pairs),
                        count_cell(row.comparisons),
                        count_cell(row.checked_exactly),
                        count_cell(row.ours_wrong + row.ours_witness_wrong, true),
                        count_cell(row.box2d_wrong, true),
                        count_cell(row.box2d_wrong_flag),
                        count_cell(row.box2d_wrong_distance),
                        count_cell(row.ill_conditioned),
                        number_cell(row.max_error_ours_m),
                        number_cell(row.max_error_ours_units),
                        number_cell(row.max_error_box2d_m),
                        number_cell(row.max_error_box2d_eps),
                        number_cell(mean_iterations(row.iterations_ours, row)),
                        number_cell(mean_iterations(row.iterations_box2d, row)),
                        count_cell(static_cast<std::uint64_t>(row.max_iterations_ours)),
                        count_cell(static_cast<std::uint64_t>(row.max_iterations_box2d))});
    page.table(header, rows);
}

void add_family_descriptions(HtmlPage& page, const ParityResult& result) {
    std::vector<std::vector<HtmlCell>> rows;
    for (const ParityRow& row : result.families) {
        const reference::PairFamily* still = reference::find_pair_family(row.name);
        const reference::CastFamily* moving = reference::find_cast_family(row.name);
        if (still || moving)
            rows.push_back(
                {{.text = row.name}, {.text = std::string(still ? still->description : moving->description)}});
    }
    if (rows.empty()) return;
    const std::vector<std::string> header = {"family", "what its pairs are"};
    page.begin_details("what the pairs of each family are");
    page.table(header, rows);
    page.end_details();
}

void add_case(HtmlPage& page, const ParityCase& sample) {
    std::string caption = sample.family + ", pair " + std::to_string(sample.index) + ": exact " +
                          short_number(sample.exact) + " m; tumble off by " + short_number(sample.error_ours_m) + " m";
    std::vector<DVec2> rings;
    if (sample.box2d) {
        caption += "; Box2D says " + short_number(sample.box2d->distance) + " m, off by " +
                   short_number(sample.error_box2d_m) + " m (" + short_number(sample.error_box2d_eps) + " eps S)";
        rings = {sample.box2d->point_a, sample.box2d->point_b};
    }
    caption += sample.reason.empty() ? "." : "; wrong: " + sample.reason + ".";
    if (sample.verdict == reference::ParityVerdict::box2d_wrong) caption += " " + why_box2d_failed(sample);
    if (!rings.empty()) caption += " Rings: Box2D's witness points.";
    page.figure(draw_pair(sample.query.a, sample.query.pose_a, sample.query.b, sample.query.pose_b, sample.ours, rings),
                caption);
    page.begin_details("the input in hexadecimal floats");
    page.preformatted(to_hex(sample.query));
    page.end_details();
}

void add_failures(HtmlPage& page, const ParityResult& result) {
    const ParityRow total = result.total();
    if (total.ours_failures.empty()) return;
    page.heading("Where tumble is wrong");
    for (const ParityRow& row : result.families)
        for (const ParityCase& sample : row.ours_failures) add_case(page, sample);
}

// The worst case of each family in which Box2D is wrong, wrong overlap flags first.
void add_worst_cases(HtmlPage& page, const ParityResult& result) {
    std::vector<const ParityCase*> shown;
    for (const ParityRow& row : result.families) {
        const auto is_shown = [](const ParityCase& sample) {
            return sample.verdict == reference::ParityVerdict::box2d_wrong;
        };
        const auto worst = std::ranges::find_if(row.worst_box2d, is_shown);
        if (worst != row.worst_box2d.end()) shown.push_back(&*worst);
    }
    if (shown.empty()) return;
    const auto by_flag = [](const ParityCase* sample) { return sample->box2d_wrong_flag; };
    std::stable_partition(shown.begin(), shown.end(), by_flag);
    page.heading("Where Box2D is wrong: the worst of each family");
    for (const ParityCase* sample : shown) add_case(page, *sample);
}

}  // namespace

void write_parity_json(JsonWriter& json, const ParityResult& result) {
    const ParityRow total = result.total();
    json.open_object()
        .member("pairs", result.pairs)
        .member("seed", result.seed)
        .member("checked_exactly", total.checked_exactly)
        .key("families")
        .open_array();
    for (const ParityRow& row : result.families)
        json.open_object()
            .member("name", row.name)
            .member("pairs", row.pairs)
            .member("comparisons", row.comparisons)
            .member("checked_exactly", row.checked_exactly)
            .member("ours_wrong", row.ours_wrong + row.ours_witness_wrong)
            .member("box2d_wrong", row.box2d_wrong)
            .member("box2d_wrong_flag", row.box2d_wrong_flag)
            .member("box2d_wrong_distance", row.box2d_wrong_distance)
            .member("box2d_witness_wrong", row.box2d_witness_wrong)
            .member("box2d_refused", row.box2d_refused)
            .member("ill_conditioned", row.ill_conditioned)
            .member("max_error_ours_m", row.max_error_ours_m)
            .member("max_error_ours_units", row.max_error_ours_units)
            .member("max_error_box2d_m", row.max_error_box2d_m)
            .member("max_error_box2d_eps", row.max_error_box2d_eps)
            .member("iterations_ours", mean_iterations(row.iterations_ours, row))
            .member("iterations_box2d", mean_iterations(row.iterations_box2d, row))
            .member("max_iterations_ours", row.max_iterations_ours)
            .member("max_iterations_box2d", row.max_iterations_box2d)
            .close_object();
    json.close_array()
        .member("ours_wrong", total.ours_wrong + total.ours_witness_wrong)
        .member("box2d_wrong", total.box2d_wrong)
        .member("seconds", result.seconds)
        .close_object();
}

std::string parity_table(const ParityResult& result) {
    std::array<char, 256> line{};
    std::string table;
    const auto add = [&](const ParityRow& row) {
        std::snprintf(line.data(), line.size(),
                      "%-22s %10llu %10llu %6llu %8llu %8llu %11.3g %6.2f %11.3g %6.2f %6.2f\n", row.name.c_str(),
                      static_cast<unsigned long long>(row.pairs), static_cast<unsigned long long>(row.checked_exactly),
                      static_cast<unsigned long long>(row.ours_wrong + row.ours_witness_wrong),
                      static_cast<unsigned long long>(row.box2d_wrong),
                      static_cast<unsigned long long>(row.ill_conditioned), row.max_error_ours_m,
                      row.max_error_ours_units, row.max_error_box2d_m, mean_iterations(row.iterations_ours, row),
                      mean_iterations(row.iterations_box2d, row));
        table += line.data();
    };
    table +=
        "                                     checked  wrong:    wrong      ill-  max error:    in    max error:  "
        "iterations:\n";
    table +=
        "family                      pairs    exactly   ours    Box2D  condit.      ours m    u L     Box2D m   ours  "
        "Box2D\n";
    for (const ParityRow& row : result.families) add(row);
    ParityRow total = result.total();
    total.name = "total";
    add(total);
    table += "L: the sizes of the cores, their radii and their offset, added up; u = 2^-53\n";
    return table;
}

std::string parity_page(const ParityResult& result, const std::string& what) {
    HtmlPage page("Parity with b2Distance");
    add_summary(page, result, what);
    page.figure(draw_error_histograms(result.families),
                "Errors of both engines by family, in one axis. tumble's are of the comparisons checked exactly; bars "
                "are square roots of counts.");
    add_failures(page, result);
    add_definitions(page);
    add_family_table(page, result);
    add_family_descriptions(page, result);
    add_worst_cases(page, result);
    return page.str();
}

}  // namespace tumble::tools
