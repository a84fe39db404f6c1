#include "tools/parity/parity_page.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "reference/families/cast_families.hpp"
#include "reference/families/pair_families.hpp"
#include "tools/machine/engines.hpp"
#include "tools/output/html.hpp"
#include "tools/parity/parity_explanation.hpp"
#include "tools/parity/parity_plots.hpp"
#include "tools/parity/parity_report.hpp"

namespace tumble::tools {

namespace {

using reference::ParityCase;
using reference::ParityResult;
using reference::ParityRow;

// Digits in groups of three: "12 345".
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

HtmlCell count_cell(std::uint64_t count, bool is_alarm = false) {
    return {.text = grouped(count), .is_number = true, .is_alarm = is_alarm && count > 0};
}

HtmlCell number_cell(double value) { return {.text = short_number(value), .is_number = true}; }

void add_summary(HtmlPage& page, const ParityResult& result, const std::string& what) {
    const ParityRow total = result.total();
    page.paragraph(
        what + ", seed " + std::to_string(result.seed) +
        ". tumble and Box2D answered the same queries: " + grouped(total.comparisons) +
        " comparisons, because distances of shapes with radii are compared without and with them. Exact arithmetic "
        "checked " +
        grouped(total.checked_exactly) + " of the comparisons. The run took " + short_number(result.seconds) + " s.");
    for (const EngineBuild& engine : compared_engines())
        page.paragraph(engine.name + " " + engine.version + ": " + engine.build + ".");
    page.paragraph("Wrong answers of tumble: " + grouped(total.ours_wrong + total.ours_witness_wrong) +
                   ". Wrong answers of Box2D: " + grouped(total.box2d_wrong) + " (" + grouped(total.box2d_wrong_flag) +
                   " wrong overlap flags, " + grouped(total.box2d_wrong_distance) +
                   " wrong distances). Ill-conditioned pairs, on which the engines differ and neither is wrong: " +
                   grouped(total.ill_conditioned) + ".");
}

void add_definitions(HtmlPage& page) {
    page.heading("What counts as wrong");
    page.paragraph(
        "Units: u = 2^-53 = 1.1e-16 is the rounding unit of double, eps = 1.19e-7 that of float. L is the sum of the "
        "sizes of the cores, their radii and the offset of their positions. S is the largest world coordinate of the "
        "pair.");
    page.paragraph(
        "A distance of tumble comes with bounds. It is wrong if the exact signed distance lies outside of [lower, "
        "upper], if its status (separated, touching, overlapping) contradicts the exact sign, if its certificate does "
        "not prove the bounds, if its witness points are off by more than 4 eps S, or if its error exceeds the "
        "rounding error in double, 16 to 20 u L; the last condition excludes bounds that are correct but too wide.");
    page.paragraph(
        "A ray, a shape cast or a time of impact of tumble is wrong if the distance falls more than 4 E below the "
        "target before the reported fraction, or at any time if a miss is reported; if the distance at the reported "
        "fraction differs from the target by more than 4 E; or if its bracket of the fraction is not correct. E is the "
        "error bound of the query, 16 u L for a translation and about 24 u L for a time of impact. For Box2D, 4 eps S "
        "plus its own tolerance replace 4 E, and at the reported fraction only a distance above the target is wrong. "
        "The error in the table is the difference from the target at the reported fraction.");
    page.paragraph(
        "b2Distance computes in float. It is wrong if its distance has an error above 4 eps S, or if its overlap flag "
        "is wrong: it reports an overlap by the distance 0, so 0 is wrong for a positive exact distance, and any other "
        "value is wrong for a negative one. A pair is ill-conditioned if the engines differ by more than the tolerance "
        "and neither is wrong. Exact arithmetic checks every pair on which they differ by more, the first pairs of "
        "each family, and a seeded sample of the rest.");
    page.paragraph(
        "An iteration computes one support vertex of the Minkowski difference. For cores of at most eight vertices, "
        "tumble evaluates all faces at once, which counts as 2: the ends of the nearest face. The iterations of Box2D "
        "are those of b2Distance.");
    page.heading("Why b2Distance fails");
    page.paragraph(
        "It computes in float and in world coordinates. The coordinates of a pair S metres from the origin are rounded "
        "to eps S, 1 mm at 10 km; if the gap is smaller, the overlap flag is arbitrary. Its loop ends at a search "
        "direction shorter than 1.2e-7 m, an absolute length that small shapes fall below. If the origin then lies on "
        "an edge of its simplex, a deep overlap is reported as a tiny distance. The barycentric weights of its "
        "triangles are products of four coordinates, which exceed the range of float for shapes below a nanometre or "
        "above a million kilometres. tumble computes in double relative to one of the shapes, has no absolute length "
        "in any query, and subtracts the radii last.");
}

void add_family_table(HtmlPage& page, const ParityResult& result) {
    page.heading("Results by family");
    const std::vector<std::string> header = {"family",       "pairs",
                                             "compared",     "checked exactly",
                                             "tumble wrong", "Box2D wrong",
                                             "wrong flag",   "wrong distance",
                                             "ill-cond.",    "max error tumble (m)",
                                             "in u L",       "max error Box2D (m)",
                                             "in eps S",     "iterations tumble",
                                             "Box2D",        "max tumble",
                                             "max Box2D"};
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

// A number about the answers of Box2D v3, or a dash if it has refused all queries of the family.
HtmlCell v3_cell(const ParityRow& of_v3, double value) {
    if (of_v3.box2d_refused < of_v3.comparisons) return number_cell(value);
    return {.text = "-", .is_number = true};
}

// The same judge on the answers of Box2D v3.
void add_v3_table(HtmlPage& page, const ParityResults& results) {
    const EngineBuild v3 = box2d_v3_engine();
    page.heading("Three engines");
    page.paragraph(
        v3.name + " " + v3.version + ": " + v3.build +
        ". It answers the same queries, and the same judge decides. It takes the pose of one shape relative to "
        "the other, which is computed here in double. Refused: shapes of more than eight vertices, and queries "
        "that it lacks.");
    const std::vector<std::string> header = {
        "family",    "wrong: tumble",      "Box2D", "Box2D v3", "refused: v3", "max tumble, m", "max Box2D, m",
        "max v3, m", "iterations: tumble", "Box2D", "v3"};
    std::vector<std::vector<HtmlCell>> rows;
    for (std::size_t i = 0; i < results.box2d.families.size(); ++i) {
        const ParityRow &row = results.box2d.families[i], &of_v3 = results.box2d_v3->families[i];
        rows.push_back({{.text = row.name},
                        count_cell(row.ours_wrong + row.ours_witness_wrong, true),
                        count_cell(row.box2d_wrong, true),
                        count_cell(of_v3.box2d_wrong, true),
                        count_cell(of_v3.box2d_refused),
                        number_cell(row.max_error_ours_m),
                        number_cell(row.max_error_box2d_m),
                        v3_cell(of_v3, of_v3.max_error_box2d_m),
                        number_cell(mean_iterations(row.iterations_ours, row)),
                        number_cell(mean_iterations(row.iterations_box2d, row)),
                        v3_cell(of_v3, mean_iterations(of_v3.iterations_box2d, of_v3))});
    }
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
    const std::vector<std::string> header = {"family", "its pairs"};
    page.begin_details("the pairs of each family");
    page.table(header, rows);
    page.end_details();
}

void add_case(HtmlPage& page, const ParityCase& sample) {
    std::string caption = sample.family + ", pair " + std::to_string(sample.index) + ": exact " +
                          short_number(sample.exact) + " m; error of tumble " + short_number(sample.error_ours_m) +
                          " m";
    std::vector<DVec2> rings;
    if (sample.box2d) {
        caption += "; Box2D: " + short_number(sample.box2d->distance) + " m, error " +
                   short_number(sample.error_box2d_m) + " m (" + short_number(sample.error_box2d_eps) + " eps S)";
        rings = {sample.box2d->point_a, sample.box2d->point_b};
    }
    caption += sample.reason.empty() ? "." : "; wrong: " + sample.reason + ".";
    if (sample.verdict == reference::ParityVerdict::box2d_wrong) caption += " " + why_box2d_failed(sample);
    if (!rings.empty()) caption += " The rings are Box2D's witness points.";
    page.figure(draw_pair(sample.query.a, sample.query.pose_a, sample.query.b, sample.query.pose_b, sample.ours, rings),
                caption);
    page.begin_details("the input as hexadecimal floats");
    page.preformatted(to_hex(sample.query));
    page.end_details();
}

void add_failures(HtmlPage& page, const ParityResult& result) {
    const ParityRow total = result.total();
    if (total.ours_failures.empty()) return;
    page.heading("Wrong answers of tumble");
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
    page.heading("Wrong answers of Box2D: the worst of each family");
    for (const ParityCase* sample : shown) add_case(page, *sample);
}

}  // namespace

std::string parity_page(const ParityResults& results, const std::string& what) {
    const ParityResult& result = results.box2d;
    HtmlPage page("Parity with Box2D");
    add_summary(page, result, what);
    page.figure(plot_error_histograms(result.families),
                "The errors of all families on one axis. Those of tumble are those of the comparisons that "
                "exact arithmetic checked. The height of a bar is the square root of its count.");
    add_failures(page, result);
    add_definitions(page);
    add_family_table(page, result);
    if (results.box2d_v3) add_v3_table(page, results);
    add_family_descriptions(page, result);
    add_worst_cases(page, result);
    return page.str();
}

}  // namespace tumble::tools
