#include "tools/diff/summary_diff.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxBytes = 1 << 26;  // a summary has about 3 kB, and 100 bytes for each move of its camera

// Null if the file is too long or not JSON.
Json parsed(const std::filesystem::path& file) {
    const std::string text = read_file(file, kMaxBytes);
    const Json found = text.size() > kMaxBytes ? Json() : Json::parse(text, nullptr, false);
    return found.is_discarded() ? Json() : found;
}

bool is_summary(const Json& found) {
    return found.is_object() && found.contains("state_hash") && found.contains("wall_s") && found.contains("complete");
}

bool is_timing(std::string_view pointer) {
    return pointer.starts_with("/wall_s/") || pointer.starts_with("/ms_per_step/");
}

// The files of a run by their kinds, so that one more file does not shift the others; as a list if a file has no kind
// of its own.
Json files_by_kind(const Json& files) {
    Json by_kind = Json::object();
    for (const Json& written : files) {
        if (!written.is_object() || !written.contains("kind") || !written["kind"].is_string()) return files;
        Json file = written;
        file.erase("kind");
        if (!by_kind.emplace(written["kind"].get<std::string>(), file).second) return files;
    }
    return by_kind;
}

void keep_names_of_paths(Json& files) {
    for (Json& written : files)
        if (written.is_object() && written.contains("path") && written["path"].is_string())
            written["path"] = std::filesystem::path(written["path"].get<std::string>()).filename().string();
}

// All values by their pointers. Of the paths of files only the names are kept.
Json values_of(const std::filesystem::path& file) {
    Json found = parsed(file);
    if (!is_summary(found)) throw InputError(file.string() + ": is not a summary of a run");
    if (const auto files = found.find("files"); files != found.end() && files->is_array()) {
        keep_names_of_paths(*files);
        *files = files_by_kind(*files);
    }
    return found.flatten();
}

// Integers of 64 bits, such as seeds, are not all doubles.
bool are_equal(const Json& a, const Json& b, double tolerance) {
    if (a == b) return true;
    if (a.is_number_unsigned() && b.is_number_unsigned()) {
        const auto x = a.get<std::uint64_t>(), y = b.get<std::uint64_t>();
        return static_cast<double>(std::max(x, y) - std::min(x, y)) <= tolerance;
    }
    return a.is_number() && b.is_number() && std::abs(a.get<double>() - b.get<double>()) <= tolerance;
}

std::string text_of(const Json& values, const std::string& pointer) {
    return values.contains(pointer) ? values[pointer].dump() : "";
}

void write_values(JsonWriter& json, const char* key, const std::vector<SummaryValue>& values) {
    json.key(key).open_array();
    for (const SummaryValue& value : values)
        json.open_object().member("pointer", value.pointer).member("a", value.a).member("b", value.b).close_object();
    json.close_array();
}

std::string shown(const std::string& value) { return value.empty() ? "missing" : value; }

}  // namespace

bool is_summary_file(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) && is_summary(parsed(file));
}

SummaryComparison compare_summaries(const std::filesystem::path& file_a, const std::filesystem::path& file_b,
                                    double tolerance) {
    const Json a = values_of(file_a), b = values_of(file_b);
    SummaryComparison comparison;
    Json all = a;
    all.update(b);
    for (const auto& [pointer, unused] : all.items()) {
        const bool in_both = a.contains(pointer) && b.contains(pointer);
        const SummaryValue value{pointer, text_of(a, pointer), text_of(b, pointer)};
        if (is_timing(pointer))
            comparison.timings.push_back(value);
        else if (in_both && are_equal(a[pointer], b[pointer], tolerance))
            ++comparison.equal_count;
        else
            comparison.different.push_back(value);
    }
    return comparison;
}

std::string to_text(const SummaryComparison& comparison) {
    std::string text;
    if (comparison.different.empty())
        text = "equal apart from times: " + counted(comparison.equal_count, "value") + "\n";
    else
        text = "values that differ: " + std::to_string(comparison.different.size()) +
               ", equal: " + std::to_string(comparison.equal_count) + "\n";
    for (const SummaryValue& value : comparison.different)
        text += "  " + value.pointer + ": " + shown(value.a) + " in A, " + shown(value.b) + " in B\n";
    for (const SummaryValue& value : comparison.timings)
        if (value.pointer == "/wall_s/total" || value.pointer == "/ms_per_step/step")
            text += "  time, not compared: " + value.pointer + " is " + shown(value.a) + " in A, " + shown(value.b) +
                    " in B\n";
    return text;
}

std::string to_json(const SummaryComparison& comparison) {
    JsonWriter json;
    json.open_object().member("equal", comparison.different.empty());
    json.member("equal_values", comparison.equal_count);
    write_values(json, "different", comparison.different);
    write_values(json, "timings", comparison.timings);
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
