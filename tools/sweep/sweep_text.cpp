#include "tools/sweep/sweep_text.hpp"

#include <array>
#include <cstdio>

#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"
#include "tools/sweep/sweep_folder.hpp"

namespace tumble::tools {

namespace {

using Outcomes = std::map<std::string, std::uint64_t>;

std::string outcomes_text(const Outcomes& outcomes) {
    std::string text;
    for (const auto& [outcome, count] : outcomes)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + outcome;
    return text.empty() ? "none" : text;
}

void write_outcomes(JsonWriter& json, const Outcomes& outcomes) {
    json.key("outcomes").open_object();
    for (const auto& [outcome, count] : outcomes) json.member(outcome, count);
    json.close_object();
}

std::string three_digits(double number, const char* unit) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.3g %s", number, unit);
    return text.data();
}

std::string duration_text(double seconds) {
    if (seconds < 120.0) return three_digits(seconds, "s");
    if (seconds < 7200.0) return three_digits(seconds / 60.0, "min");
    return seconds < 2.0 * 86400.0 ? three_digits(seconds / 3600.0, "h") : three_digits(seconds / 86400.0, "days");
}

std::string bytes_text(double bytes) {
    constexpr std::array<const char*, 6> kUnits{"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (; bytes >= 1000.0 && unit + 1 < kUnits.size(); ++unit) bytes /= 1000.0;
    return three_digits(bytes, kUnits[unit]);
}

std::string ranges_text(const ShardRanges& ranges) {
    constexpr std::size_t kMost = 20;
    std::string text;
    for (std::size_t i = 0; i < ranges.size() && i < kMost; ++i) {
        text += (i == 0 ? "" : ", ") + std::to_string(ranges[i].first);
        if (ranges[i].second > ranges[i].first) text += "-" + std::to_string(ranges[i].second);
    }
    return ranges.size() > kMost ? text + ", ..." : text;
}

}  // namespace

SweepStatus status_of(const std::filesystem::path& folder) {
    const sweep::Manifest manifest = manifest_of_sweep(folder);
    SweepStatus status{.runs = manifest.header->runs, .shards = manifest.header->shards()};
    for (const auto& [shard, entry] : manifest.shards) {
        if (!is_stored(folder, manifest, shard)) continue;
        ++status.stored_shards;
        for (const auto& [outcome, count] : entry.outcomes) status.outcomes[outcome] += count;
    }
    status.damaged_lines = manifest.damaged_lines;
    status.missing = missing_shards(folder, manifest);
    status.complete = is_complete(folder, manifest);
    return status;
}

std::string to_text(const SweepStatus& status) {
    std::string text = "stored: " + std::to_string(status.stored_shards) + " of " + counted(status.shards, "shard") +
                       ", of " + counted(status.runs, "run") + ": " + outcomes_text(status.outcomes) + "\n";
    if (status.damaged_lines > 0)
        text += "lines of the manifest that are damaged: " + std::to_string(status.damaged_lines) + "\n";
    if (!status.missing.empty()) text += "missing shards: " + ranges_text(status.missing) + "\n";
    if (status.missing.empty() && !status.complete) text += "the table is not made: run the sweep again, or merge\n";
    return text;
}

std::string to_json(const SweepStatus& status) {
    JsonWriter json;
    json.open_object().member("runs", status.runs).member("shards", status.shards);
    json.member("stored_shards", status.stored_shards).member("complete", status.complete);
    write_outcomes(json, status.outcomes);
    json.member("damaged_lines", status.damaged_lines).key("missing").open_array();
    for (const auto& [first, last] : status.missing) json.open_array().value(first).value(last).close_array();
    json.close_array().close_object();
    return json.text() + "\n";
}

std::string to_text(const sweep::Plan& plan, const SweepReport& report) {
    std::string text = plan.name + ": " + std::to_string(report.simulated_runs) + " of " + counted(report.runs, "run") +
                       " simulated in " + duration_text(report.seconds) +
                       "; stored: " + outcomes_text(report.outcomes) + "\n";
    if (report.missing_shards > 0)
        text += "missing: " + std::to_string(report.missing_shards) + " of " + counted(report.shards, "shard") + "\n";
    return text;
}

std::string to_json(const SweepReport& report) {
    JsonWriter json;
    json.open_object().member("runs", report.runs).member("shards", report.shards);
    json.member("simulated_runs", report.simulated_runs).member("missing_shards", report.missing_shards);
    write_outcomes(json, report.outcomes);
    json.member("complete", report.complete).member("seconds", report.seconds).close_object();
    return json.text() + "\n";
}

std::string to_text(const sweep::Plan& plan, const SweepEstimate& estimate) {
    return plan.name + ": " + counted(estimate.runs, "run") + " in " + counted(estimate.shards, "shard") + " of " +
           std::to_string(estimate.shard_runs) + "\nabout " + duration_text(estimate.seconds) + ", " +
           three_digits(estimate.seconds_per_run * 1e3, "ms") +
           " for a run, not counting the time to store files\nabout " + bytes_text(estimate.bytes) + " in " +
           counted(estimate.files, "file") + ", not counting the metadata of HDF5\nof " +
           counted(estimate.sampled, "sampled run") + ": " + outcomes_text(estimate.outcomes) + "\n" +
           (estimate.failure.empty() ? "" : "  " + estimate.failure + "\n");
}

std::string to_json(const SweepEstimate& estimate) {
    JsonWriter json;
    json.open_object().member("runs", estimate.runs).member("shards", estimate.shards);
    json.member("shard_runs", estimate.shard_runs).member("sampled", estimate.sampled);
    write_outcomes(json, estimate.outcomes);
    if (!estimate.failure.empty()) json.member("failure", estimate.failure);
    json.member("seconds_per_run", estimate.seconds_per_run).member("seconds", estimate.seconds);
    json.member("bytes", estimate.bytes).member("files", estimate.files).close_object();
    return json.text() + "\n";
}

std::string to_text(const Verification& verification) {
    std::string text;
    for (const std::string& finding : verification.findings) text += finding + "\n";
    return text + counted(verification.files, "file") + ", " + bytes_text(static_cast<double>(verification.bytes)) +
           ", and " + counted(verification.repeated_runs, "run") + " made again" +
           (verification.repeated_runs > 0 ? ", drawn by --seed " + std::to_string(verification.seed) : "") + ": " +
           (verification.findings.empty() ? "all as written" : counted(verification.findings.size(), "finding")) + "\n";
}

std::string to_json(const Verification& verification) {
    JsonWriter json;
    json.open_object().member("files", verification.files).member("bytes", verification.bytes);
    json.member("repeated_runs", verification.repeated_runs)
        .member("seed", verification.seed)
        .member("findings", verification.findings);
    json.member("passed", verification.findings.empty()).close_object();
    return json.text() + "\n";
}

}  // namespace tumble::tools
