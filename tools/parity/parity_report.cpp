#include "tools/parity/parity_report.hpp"

#include <array>
#include <cstdio>

#include "tools/machine/engines.hpp"

namespace tumble::tools {

using reference::ParityResult;
using reference::ParityRow;

double mean_iterations(std::uint64_t sum, const ParityRow& row) {
    return row.comparisons == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(row.comparisons);
}

namespace {

// What a family has about Box2D v3, in the words of the members about Box2D.
void write_v3(JsonWriter& json, const ParityRow& row) {
    json.member("box2d_v3_wrong", row.box2d_wrong)
        .member("box2d_v3_wrong_flag", row.box2d_wrong_flag)
        .member("box2d_v3_wrong_distance", row.box2d_wrong_distance)
        .member("box2d_v3_witness_wrong", row.box2d_witness_wrong)
        .member("box2d_v3_refused", row.box2d_refused)
        .member("ill_conditioned_v3", row.ill_conditioned)
        .member("max_error_box2d_v3_m", row.max_error_box2d_m)
        .member("max_error_box2d_v3_eps", row.max_error_box2d_eps)
        .member("iterations_box2d_v3", mean_iterations(row.iterations_box2d, row))
        .member("max_iterations_box2d_v3", row.max_iterations_box2d);
}

// The columns of Box2D v3, to the right of the others.
std::string v3_columns(const ParityRow& row) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), " %8llu %11.3g %6.2f", static_cast<unsigned long long>(row.box2d_wrong),
                  row.max_error_box2d_m, mean_iterations(row.iterations_box2d, row));
    return text.data();
}

}  // namespace

void write_parity_json(JsonWriter& json, const ParityResults& results) {
    const ParityResult& result = results.box2d;
    const ParityRow total = result.total();
    json.open_object()
        .member("pairs", result.pairs)
        .member("seed", result.seed)
        .member("checked_exactly", total.checked_exactly)
        .key("families")
        .open_array();
    for (std::size_t i = 0; i < result.families.size(); ++i) {
        const ParityRow& row = result.families[i];
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
            .member("max_iterations_box2d", row.max_iterations_box2d);
        if (results.box2d_v3) write_v3(json, results.box2d_v3->families[i]);
        json.close_object();
    }
    json.close_array()
        .member("ours_wrong", total.ours_wrong + total.ours_witness_wrong)
        .member("box2d_wrong", total.box2d_wrong);
    if (results.box2d_v3) json.member("box2d_v3_wrong", results.box2d_v3->total().box2d_wrong);
    json.member("seconds", result.seconds);
    write_engines(json, results.box2d_v3.has_value());
    json.close_object();
}

std::string parity_table(const ParityResults& results) {
    const ParityResult& result = results.box2d;
    std::array<char, 256> line{};
    std::string table;
    const auto add = [&](const ParityRow& row, const ParityRow* of_v3) {
        std::snprintf(line.data(), line.size(), "%-22s %10llu %10llu %6llu %8llu %8llu %11.3g %6.2f %11.3g %6.2f %6.2f",
                      row.name.c_str(), static_cast<unsigned long long>(row.pairs),
                      static_cast<unsigned long long>(row.checked_exactly),
                      static_cast<unsigned long long>(row.ours_wrong) + row.ours_witness_wrong,
                      static_cast<unsigned long long>(row.box2d_wrong),
                      static_cast<unsigned long long>(row.ill_conditioned), row.max_error_ours_m,
                      row.max_error_ours_units, row.max_error_box2d_m, mean_iterations(row.iterations_ours, row),
                      mean_iterations(row.iterations_box2d, row));
        table += line.data() + (of_v3 ? v3_columns(*of_v3) : "") + "\n";
    };
    table +=
        "                                     checked  wrong:    wrong      ill-  max error:    in    max error:  "
        "iterations:";
    table += results.box2d_v3 ? "   wrong:  max error:  iter.:\n" : "\n";
    table +=
        "family                      pairs    exactly   ours    Box2D  condit.      ours m    u L     Box2D m   ours  "
        "Box2D";
    table += results.box2d_v3 ? "       v3        v3 m     v3\n" : "\n";
    for (std::size_t i = 0; i < result.families.size(); ++i)
        add(result.families[i], results.box2d_v3 ? &results.box2d_v3->families[i] : nullptr);
    const ParityRow total = result.total(), total_v3 = results.box2d_v3 ? results.box2d_v3->total() : ParityRow{};
    add(total, results.box2d_v3 ? &total_v3 : nullptr);
    table += "L: sum of the sizes of the cores, their radii and their offset; u = 2^-53\n";
    table += "iterations: support vertices computed; a scan of all faces counts as 2, the ends of the nearest face\n";
    return table + engines_text(results.box2d_v3.has_value());
}

}  // namespace tumble::tools
