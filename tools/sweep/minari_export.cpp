#include "tools/sweep/minari_export.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <vector>

#include "sweep/hdf5/episode_file.hpp"
#include "sweep/hdf5/trajectory_reader.hpp"
#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/output/input_error.hpp"
#include "tools/output/number_text.hpp"
#include "tools/sweep/minari_metadata.hpp"
#include "tools/sweep/runs/run_record.hpp"
#include "tools/sweep/sweep_folder.hpp"
#include "tools/sweep/table_reader.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

void verify_checksum(const fs::path& folder, const sweep::StoredFile& file) {
    if (is_interrupted()) throw Interrupted{};
    if (sweep::read_stored_file(folder, file.name).hash != file.hash)
        throw InputError((folder / file.name).string() +
                         ": its checksum is not that of the manifest; run the sweep again with --check");
}

// The trajectory files in the order of their runs, whose checksums hold.
std::vector<fs::path> trajectory_files(const fs::path& folder, const sweep::Manifest& manifest) {
    std::vector<fs::path> files;
    for (const auto& [shard, entry] : manifest.shards)
        for (const sweep::StoredFile& file : entry.files) {
            if (!file.name.ends_with(".h5")) continue;
            verify_checksum(folder, file);
            files.push_back(folder / file.name);
        }
    if (files.empty())
        throw FileError(folder, "has no HDF5 trajectories, which a plan with \"write\": {\"trajectory\": {}} writes");
    return files;
}

// Nothing for NaN and infinities, which no space of actions and no reward can have.
std::optional<double> finite_number_of(const std::string& cell) {
    const std::optional<double> number = number_of(cell);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

EpisodeShape shape_of(const fs::path& folder, const sweep::SweepHeader& header, const std::vector<fs::path>& files) {
    EpisodeShape shape;
    for (const fs::path& file : files) {
        const sweep::TrajectoryReader reader(file);
        shape.bodies = std::max(shape.bodies, reader.most_bodies());
        shape.bits = reader.bits();
        shape.every = reader.every();
    }
    TableReader table(folder, header);
    const std::size_t outcome = table.column("outcome");
    std::vector<std::size_t> parameters = table.columns_between("seed", "outcome");
    while (table.next()) {
        if (table.cell(outcome) != "ok") continue;
        std::erase_if(parameters, [&](std::size_t column) { return !finite_number_of(table.cell(column)); });
        for (const std::size_t column : parameters) {
            const double number = finite_number_of(table.cell(column)).value();
            ParameterRange& range = shape.actions.try_emplace(column, ParameterRange{number, number}).first->second;
            range = {std::min(range.lower, number), std::max(range.upper, number)};
        }
    }
    std::erase_if(shape.actions, [&](const auto& action) { return !std::ranges::count(parameters, action.first); });
    return shape;
}

// A line of the table and the states of its run as an episode.
class EpisodeMaker {
public:
    EpisodeMaker(const TableReader& table, const EpisodeShape& shape, const std::string& reward)
        : table_(table),
          shape_(shape),
          seed_(table.column("seed")),
          parameters_(table.columns_between("seed", "outcome")),
          measures_(table.columns_between("failed_claims", "state_hash")) {
        if (!reward.empty()) reward_ = table.column(reward);
    }

    // Of the line that was read last.
    sweep::Episode make(sweep::ShardTrajectory run) const {
        sweep::Episode episode{.run = run.run, .states = std::move(run.states), .is_terminated = run.is_stopped};
        const std::string& seed = table_.cell(seed_);
        std::from_chars(seed.data(), seed.data() + seed.size(), episode.seed);
        if (reward_) episode.reward = reward();
        for (const auto& [column, range] : shape_.actions)
            episode.action.push_back(finite_number_of(table_.cell(column)).value());
        add_attributes("options/", parameters_, episode);
        add_attributes("measures/", measures_, episode);
        return episode;
    }

private:
    double reward() const {
        const std::string& cell = table_.cell(*reward_);
        const std::optional<double> number = finite_number_of(cell);
        if (!number) table_.fail("the reward '" + table_.columns()[*reward_] + "' is no number: " + cell);
        return *number;
    }

    void add_attributes(const std::string& prefix, const std::vector<std::size_t>& columns,
                        sweep::Episode& episode) const {
        for (const std::size_t column : columns) {
            const std::string& cell = table_.cell(column);
            const std::optional<double> number = number_of(cell);
            auto& [name, value] = episode.attributes.emplace_back(prefix + table_.columns()[column], cell);
            if (number) value = *number;
        }
    }

    const TableReader& table_;
    const EpisodeShape& shape_;
    std::size_t seed_;
    std::vector<std::size_t> parameters_, measures_;
    std::optional<std::size_t> reward_;
};

// Reads lines up to that of a run.
void find_line(TableReader& table, std::uint64_t run) {
    while (table.next())
        if (table.run() == run) return;
    table.fail("the table ends before run " + std::to_string(run));
}

void write_episodes(const MinariOptions& options, const sweep::SweepHeader& header, const std::vector<fs::path>& files,
                    const EpisodeShape& shape, sweep::EpisodeFileWriter& episodes, MinariReport& report) {
    TableReader table(options.folder, header);
    const EpisodeMaker maker(table, shape, options.reward);
    const std::size_t outcome = table.column("outcome");
    Progress progress("runs", header.runs);
    for (const fs::path& file : files) {
        const sweep::TrajectoryReader reader(file);
        for (std::size_t i = 0; i < reader.size(); ++i) {
            if (is_interrupted()) throw Interrupted{};
            find_line(table, reader.run(i));
            progress.show(reader.run(i));
            sweep::ShardTrajectory run = reader.read(i);
            if (table.cell(outcome) != "ok" || run.states.steps < 2) continue;
            ++report.episodes;
            report.steps += run.states.steps - 1;
            episodes.append(maker.make(std::move(run)));
        }
    }
    if (report.episodes == 0) throw FileError(options.folder, "has no run with the outcome ok and at least two states");
    report.left_out = header.runs - report.episodes;
}

}  // namespace

MinariReport export_minari(const MinariOptions& options) {
    const sweep::Manifest manifest = manifest_of_sweep(options.folder);
    if (!is_complete(options.folder, manifest))
        throw FileError(options.folder, "is not complete; `tumble sweep status` tells what is missing");
    MinariReport report{.dataset = options.root / options.id};
    const fs::path metadata = report.dataset / "data/metadata.json", data = report.dataset / "data/main_data.hdf5";
    for (const fs::path& file : {metadata, data}) refuse_to_overwrite(file, options.force);
    verify_checksum(options.folder, manifest.table.value());
    const std::vector<fs::path> files = trajectory_files(options.folder, manifest);
    const EpisodeShape shape = shape_of(options.folder, *manifest.header, files);
    create_folder_of(data);
    sweep::EpisodeFileWriter episodes(data, shape.bodies, shape.bits);
    write_episodes(options, *manifest.header, files, shape, episodes, report);
    episodes.save();  // before the dataset that is replaced is touched: the disk may be full
    std::error_code error;
    fs::remove(metadata, error);  // of a dataset that is replaced
    if (error) throw FileError(metadata, "cannot remove the file: " + error.message());
    report.bytes = episodes.commit();
    write_file(metadata, minari_metadata(options.id, *manifest.header, shape, report), true);
    sweep::make_durable(metadata);
    sweep::make_durable(metadata.parent_path());
    return report;
}

}  // namespace tumble::tools
