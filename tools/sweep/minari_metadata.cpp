#include "tools/sweep/minari_metadata.hpp"

#include <cmath>
#include <regex>
#include <vector>

#include "sweep/store/trajectory_array.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

// A Box of Gymnasium as Minari stores it, in the JSON of Python, which has infinities.
std::string box_text(const char* type, const std::vector<std::string>& lower, const std::vector<std::string>& upper) {
    const auto list = [](const std::vector<std::string>& numbers) {
        std::string text;
        for (const std::string& number : numbers) text += (text.empty() ? "" : ", ") + number;
        return "[" + text + "]";
    };
    return std::string(R"({"type": "Box", "dtype": ")") + type + R"(", "shape": [)" + std::to_string(lower.size()) +
           R"(], "low": )" + list(lower) + R"(, "high": )" + list(upper) + "}";
}

std::string observation_space(const EpisodeShape& shape) {
    const std::size_t numbers = shape.bodies * sweep::kStateNumbers;
    return box_text(shape.bits == 64 ? "float64" : "float32", std::vector<std::string>(numbers, "-Infinity"),
                    std::vector<std::string>(numbers, "Infinity"));
}

std::string action_space(const EpisodeShape& shape) {
    std::vector<std::string> lower, upper;
    for (const auto& [column, range] : shape.actions) {
        append_number(lower.emplace_back(), range.lower);
        append_number(upper.emplace_back(), range.upper);
    }
    return box_text("float64", lower, upper);
}

}  // namespace

bool is_dataset_id(const std::string& id) {
    constexpr std::size_t kLongest = 200;
    static const std::regex form("([-A-Za-z0-9_]{2,}/)*[-A-Za-z0-9_]+-v[0-9]{1,9}");
    return id.size() <= kLongest && std::regex_match(id, form);
}

std::string minari_metadata(const std::string& id, const sweep::SweepHeader& header, const EpisodeShape& shape,
                            const MinariReport& report) {
    const std::string of = header.plan_file.empty() ? "a plan" : "the plan " + header.plan_file;
    JsonWriter json;
    json.open_object().member("dataset_id", id).member("minari_version", "0.5.0");
    json.member("data_format", "hdf5").member("total_episodes", report.episodes).member("total_steps", report.steps);
    json.member("dataset_size", std::round(static_cast<double>(report.bytes) * 1e-5) / 10.0);  // MB
    json.member("observation_space", observation_space(shape)).member("action_space", action_space(shape));
    json.member("description", "Runs of " + of + " by tumble " + header.version + ". A step is " +
                                   std::to_string(shape.every) +
                                   " steps of the simulation; an action has the parameters of the run.");
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
