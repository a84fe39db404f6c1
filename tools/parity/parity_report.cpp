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
        .member("seconds", result.seconds);
    write_engines(json);
    json.close_object();
}

std::string parity_table(const ParityResult& result) {
    std::array<char, 256> line{};
    std::string table;
    const auto add = [&](const ParityRow& row) {
        std::snprintf(line.data(), line.size(),
                      "%-22s %10llu %10llu %6llu %8llu %8llu %11.3g %6.2f %11.3g %6.2f %6.2f\n", row.name.c_str(),
                      static_cast<unsigned long long>(row.pairs), static_cast<unsigned long long>(row.checked_exactly),
                      static_cast<unsigned long long>(row.ours_wrong) + row.ours_witness_wrong,
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
    table += "L: sum of the sizes of the cores, their radii and their offset; u = 2^-53\n";
    table += "iterations: support vertices computed; a scan of all faces counts as 2, the ends of the nearest face\n";
    return table + engines_text();
}

}  // namespace tumble::tools
