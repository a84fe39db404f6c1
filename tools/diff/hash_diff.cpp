#include "tools/diff/hash_diff.hpp"

#include <array>
#include <string_view>

#include "tools/output/csv_file.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

HashComparison compare_hash_files(const std::string& file_a, const std::string& file_b) {
    CsvFile<2> csv_a(file_a, "step", "hash"), csv_b(file_b, "step", "hash");
    std::array<char*, 2> a{}, b{};
    HashComparison comparison;
    bool more_a = csv_a.read(a), more_b = csv_b.read(b);
    for (; more_a && more_b && std::string_view(a[0]) == b[0] && std::string_view(a[1]) == b[1]; ++comparison.steps) {
        more_a = csv_a.read(a);
        more_b = csv_b.read(b);
    }
    if (more_a || more_b)
        comparison.first = {more_a ? csv_a.number<std::uint64_t>(a[0]) : csv_b.number<std::uint64_t>(b[0]),
                            more_a ? a[1] : "none", more_b ? b[1] : "none"};
    return comparison;
}

std::string to_text(const HashComparison& comparison) {
    if (!comparison.first) return "equal hashes: " + counted(comparison.steps, "step") + "\n";
    const HashDifference& first = *comparison.first;
    return "the first difference is at step " + std::to_string(first.step) + ": the hashes are " + first.hash_a +
           " and " + first.hash_b + "\n";
}

std::string to_json(const HashComparison& comparison) {
    JsonWriter json;
    json.open_object().member("equal", !comparison.first).member("equal_steps", comparison.steps);
    if (comparison.first)
        json.key("first")
            .open_object()
            .member("step", comparison.first->step)
            .member("hash_a", comparison.first->hash_a)
            .member("hash_b", comparison.first->hash_b)
            .close_object();
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
