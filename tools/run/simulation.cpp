#include "tools/run/simulation.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/health/lost_bodies.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/pictures/picture_hash.hpp"
#include "tools/run/checkpoint.hpp"
#include "tools/run/folder_lock.hpp"
#include "tools/run/frame_output.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tools/run/health_output.hpp"
#include "tools/run/label_output.hpp"
#include "tools/run/replay_output.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/video_output.hpp"
#include "tools/tables/step_files.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

// A table that the run is writing.
struct OpenTable {
    const char* kind;
    TableFile& file;
};

// One run, from its open files to its report.
class Simulation {
public:
    Simulation(const Scene& scene, const RunOptions& options);

    void run();
    void write_summary();

    // After an error: writes what the report has so far.
    void write_report(const std::string& error);

    // After an error of a step: completes the frames and videos before it. Throws what drawing or writing them throws.
    void finish_frames();

    // After an error: leaves the tables as far as they are written if there is a checkpoint that refers to them.
    void leave_tables();
    const RunReport& report() const noexcept { return report_; }
    const SceneWorld& built() const noexcept { return run_.built(); }

private:
    void record_step();
    void resume(SceneRun run, const Checkpoint& saved);
    void save_checkpoint();
    std::vector<OpenTable> open_tables();
    void close_files(bool is_complete);
    void finish_health(const std::string& note);
    void update_report();

    const Scene& scene_;
    const RunOptions& options_;
    FrameSchedule schedule_;
    SceneRun run_;
    std::optional<FolderLock> lock_;
    std::optional<EventsFile> events_;
    std::optional<TrajectoryFile> trajectory_;
    std::optional<ContactsFile> contacts_;
    std::optional<HashFile> hashes_;
    std::optional<OutputFile> summary_;
    std::optional<ReplayOutput> replay_;
    std::optional<HealthOutput> health_;
    std::optional<FrameOutput> frames_;
    std::optional<LabelOutput> labels_;
    Stopwatch watch_;
    Stopwatch since_checkpoint_;
    std::optional<Checkpoint> resumed_;
    std::uint64_t first_step_ = 0;  // of this process
    std::uint64_t pictures_ = 0;    // of a checkpoint
    RunReport report_;
};

FrameSchedule make_schedule(const Scene& scene, const RunOptions& options) {
    return {options.duration.value_or(scene.world.duration), options.frames_per_second, scene.world.steps_per_second,
            options.slow};
}

// The files that options name, if they are wanted.
std::array<const std::filesystem::path*, 7> named_files(const RunOptions& options) {
    return {&options.contacts, &options.trajectory, &options.hashes, &options.replay,
            &options.video,    &options.raw_video,  &options.report};
}

// Of two files with the same name, the second would replace the first.
void require_different_files(const RunOptions& options) {
    std::set<std::filesystem::path> names;
    for (const auto& file : {summary_file(options.folder), events_file(options.folder), checkpoint_file(options.folder),
                             labels_file(options.folder), boxes_file(options.folder)})
        names.insert(place_of(file));
    const std::filesystem::path frames = place_of(frame_file(options.folder, 0)).parent_path();
    const std::filesystem::path masks = place_of(mask_file(options.folder, 0)).parent_path();
    for (const std::filesystem::path* const file : named_files(options)) {
        if (file->empty() || is_standard_output(*file)) continue;
        if (!names.insert(place_of(*file)).second)
            throw CLI::ValidationError(file->string(), "names two output files of the run; give each its own name");
        if (!options.no_frames && is_frame(*file) && place_of(*file).parent_path() == frames)
            throw CLI::ValidationError(file->string(), "has the name of a frame; choose another");
        if (options.masks && place_of(*file).parent_path() == masks)
            throw CLI::ValidationError(file->string(), "is in the folder of the masks; choose another");
    }
}

// The run can continue up to the end of its schedule only.
void require_time_left(const SceneRun& run, const FrameSchedule& schedule, const RunOptions& options) {
    if (run.world().step_count() <= schedule.step_count()) return;
    std::string text = "ends before the checkpoint, which is at ";
    append_number(text, run.time());
    text += " s; give at least that";
    if (options.duration) throw CLI::ValidationError("--duration", text);
    throw InputError(checkpoint_file(options.folder).string() + ": the \"duration\" of the scene " + text +
                     ", or a --duration");
}

// Standard output cannot be read again.
void require_files_to_continue(const RunOptions& options) {
    if (!options.checkpoint && !options.resume) return;
    for (const std::filesystem::path* const file : {&options.contacts, &options.trajectory, &options.hashes})
        if (is_standard_output(*file))
            throw CLI::ValidationError("--checkpoint and --resume", "need tables in files, not on standard output");
}

Simulation::Simulation(const Scene& scene, const RunOptions& options)
    : scene_(scene), options_(options), schedule_(make_schedule(scene, options)), run_(scene) {
    report_.scene_name = scene.name;
    report_.scene_hash = scene_hash(scene);
    report_.seed = scene.world.seed;
    report_.draws = scene.draws;
    report_.dt = 1.0 / scene.world.steps_per_second;
    require_plots(scene, options.plots_of(scene));
    if (!options.video.empty())
        require_memory(video_settings(options.video, options.whole_size(), options.frames_per_second),
                       schedule_.frame_count());
    if (!options.replay.empty()) require_replay(run_.built(), schedule_.step_count());
    if ((options.draws() || options.labels()) && schedule_.repeats_frames())
        report_warning(options.slow.empty()
                           ? "--fps exceeds the steps per second of the scene: some frames repeat the previous one"
                           : "the scene has too few steps per second for this slow motion: some frames repeat the "
                             "previous one");
    require_different_files(options);
    require_files_to_continue(options);
    const bool force = options.force || options.resume;
    std::optional<SceneRun> loaded;
    if ((options.checkpoint || options.resume) && options.draws())
        pictures_ = picture_hash(scene, make_camera(scene, run_.built(), options.size.aspect_ratio()));
    if (options.resume) {
        resumed_ = read_checkpoint(options.folder, settings_of(options));
        loaded = load_run(scene, *resumed_, options.folder);
        require_pictures(*resumed_, pictures_, options.folder);
        require_time_left(*loaded, schedule_, options);
    }
    for (const std::filesystem::path* const file : named_files(options))
        if (!file->empty()) refuse_to_overwrite(*file, force);  // before any file is created
    lock_.emplace(options.folder);
    if (!options.resume) refuse_used_folder(options.folder, options.force);
    for (const std::filesystem::path* const file : named_files(options)) {
        if (file->empty() || !options.force) continue;
        remove_dead_parts_of(*file);
        std::filesystem::remove(earlier_part_of(*file));
    }
    if (resumed_) keep_tables(*resumed_, options);
    if (!options.contacts.empty()) contacts_.emplace(options.contacts, force);
    if (!options.trajectory.empty()) trajectory_.emplace(options.trajectory, force);
    if (!options.hashes.empty()) hashes_.emplace(options.hashes, force);
    if (!options.replay.empty()) replay_.emplace(scene, run_.built(), options);
    if (!options.report.empty()) health_.emplace(scene, options);
    if (options.draws()) frames_.emplace(scene, run_.built(), options, schedule_);
    // Last, when nothing that the options name is refused any more: an earlier run is removed.
    if (!options.resume) clear_run_folder(options.folder, !options.no_frames, options.masks);
    if (options.labels()) labels_.emplace(scene, run_.built(), options, schedule_);
    summary_.emplace(open_output(summary_file(options.folder), force));
    events_.emplace(events_file(options.folder), force, run_.built());
    if (resumed_) resume(std::move(*loaded), *resumed_);
}

// The state of the run, the tables and the camera as they were at the checkpoint.
void Simulation::resume(SceneRun run, const Checkpoint& saved) {
    run_ = std::move(run);
    first_step_ = run_.world().step_count();
    for (const OpenTable& table : open_tables()) continue_table(saved, table.kind, table.file);
    if (frames_) frames_->continue_from(saved.view, saved.frames, saved.frame_bytes);
    report_.simulate_seconds = saved.simulate_seconds;
}

std::vector<OpenTable> Simulation::open_tables() {
    std::vector<OpenTable> tables{{"events", events_->file()}};
    if (contacts_) tables.push_back({"contacts", contacts_->file()});
    if (trajectory_) tables.push_back({"trajectory", trajectory_->file()});
    if (hashes_) tables.push_back({"hashes", hashes_->file()});
    return tables;
}

void Simulation::save_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.settings = settings_of(options_);
    checkpoint.pictures = pictures_;
    if (frames_) {
        checkpoint.frame_bytes = frames_->finish_frames().bytes;
        checkpoint.frames = frames_->drawn();
        checkpoint.view = frames_->state();
    }
    for (const OpenTable& table : open_tables())
        checkpoint.tables.push_back({table.kind, table.file.temporary().filename().string(), table.file.save_so_far()});
    update_report();
    checkpoint.simulate_seconds = report_.simulate_seconds;
    checkpoint.render_seconds = report_.render_seconds;
    checkpoint.encode_seconds = report_.encode_seconds;
    checkpoint.total_seconds = report_.total_seconds;
    checkpoint.run = run_.save(scene_);
    write_checkpoint(options_.folder, checkpoint);
    if (resumed_) remove_kept_tables(options_);
    since_checkpoint_ = {};
}

void Simulation::run() {
    const std::uint64_t step_count = schedule_.step_count();
    run_.set_threads({.count = options_.threads});
    Progress progress("steps", step_count);
    if (!resumed_) record_step();
    for (std::uint64_t step = first_step_; step < step_count && !run_.is_stopped() && !is_interrupted(); ++step) {
        const Stopwatch watch;
        run_.step();
        report_.simulate_seconds += watch.seconds();
        add_times(report_.stages, run_.world().counters().ms);
        record_step();
        progress.show(step + 1);
        if (options_.checkpoint && since_checkpoint_.seconds() >= *options_.checkpoint) save_checkpoint();
    }
    const bool is_complete = run_.world().step_count() == step_count || run_.is_stopped();
    if (options_.checkpoint && is_interrupted()) save_checkpoint();
    close_files(is_complete);
    if (resumed_) remove_kept_tables(options_);
    report_.complete = is_complete;
}

void Simulation::record_step() {
    events_->record(run_.built());
    if (trajectory_) trajectory_->record(run_.built());
    if (contacts_) contacts_->record(run_.built());
    if (hashes_) hashes_->record(run_.world());
    if (replay_) replay_->record(run_.built());
    if (health_) health_->record(run_.built());
    if (frames_) frames_->draw_due(run_.built());
    if (labels_) labels_->label_due(run_.built());
}

void Simulation::close_files(bool is_complete) {
    if (frames_)
        for (WrittenFiles& files : frames_->finish()) report_.files.push_back(std::move(files));
    if (labels_)
        for (WrittenFiles& files : labels_->finish(run_.built())) report_.files.push_back(std::move(files));
    report_.files.push_back({"events", events_file(options_.folder), 1, events_->file().commit()});
    if (contacts_) report_.files.push_back({"contacts", options_.contacts, 1, contacts_->file().commit()});
    if (trajectory_) report_.files.push_back({"trajectory", options_.trajectory, 1, trajectory_->file().commit()});
    if (hashes_) report_.files.push_back({"hashes", options_.hashes, 1, hashes_->file().commit()});
    if (replay_) report_.files.push_back({"replay", options_.replay, 1, replay_->finish(run_.built(), is_complete)});
    if (health_) finish_health(is_complete ? "" : "The run was interrupted.");
}

void Simulation::finish_health(const std::string& note) {
    report_.files.push_back({"report", options_.report, 1, health_->finish(run_.built(), note)});
    report_.health = health_->report();
}

void Simulation::write_report(const std::string& error) {
    if (health_ && !report_.health) finish_health("The run ended with an error: " + error);
}

void Simulation::finish_frames() {
    if (frames_) frames_->finish();
}

void Simulation::update_report() {
    report_.steps = run_.world().step_count();
    report_.timed_steps = report_.steps - first_step_;
    report_.bodies = run_.world().bodies().size();
    report_.counters = run_.world().counters();
    const std::vector<int> islands = run_.world().islands();
    if (!islands.empty()) report_.islands = std::ranges::max(islands) + 1;
    report_.memory = run_.world().memory();
    report_.state_hash = run_.world().state_hash();
    if (frames_) {
        report_.render_seconds = frames_->render_seconds();
        report_.views = frames_->views();
        report_.frame_size = options_.size;
        report_.encode_seconds = frames_->encode_seconds();
    }
    if (labels_) {
        report_.render_seconds += labels_->seconds();
        report_.views = labels_->views();
        report_.frame_size = options_.size;
    }
    report_.total_seconds = watch_.seconds();
    if (!resumed_) return;
    report_.render_seconds += resumed_->render_seconds;
    report_.encode_seconds += resumed_->encode_seconds;
    report_.total_seconds += resumed_->total_seconds;
}

void Simulation::leave_tables() {
    if (!options_.checkpoint || !std::filesystem::exists(checkpoint_file(options_.folder))) return;
    for (const OpenTable& table : open_tables()) table.file.leave();
}

void Simulation::write_summary() {
    update_report();
    summary_->write(to_json(report_));
    summary_->commit();
    const bool has_checkpoint = options_.checkpoint || options_.resume;
    if (report_.complete && has_checkpoint) std::filesystem::remove(checkpoint_file(options_.folder));
}

// After an error. `diverged` is its message if the simulation diverged: the report then shows how it came to that.
void save_what_is_done(Simulation& simulation, const std::string& diverged) {
    simulation.leave_tables();
    // The first error is reported; one of these files would hide it.
    try {
        if (!diverged.empty()) simulation.write_report(diverged);
        simulation.write_summary();
    } catch (const FileError&) {
    }
    try {
        if (!diverged.empty()) simulation.finish_frames();
    } catch (const FileError&) {
    } catch (const RenderError&) {
    }
}

}  // namespace

RunReport simulate(const Scene& scene, const RunOptions& options) {
    catch_interrupts();
    Simulation simulation(scene, options);
    try {
        simulation.run();
    } catch (const SimulationDiverged& error) {
        save_what_is_done(simulation, error.what());
        throw;
    } catch (...) {
        save_what_is_done(simulation, "");
        throw;
    }
    simulation.write_summary();
    if (const std::string lost = lost_bodies_text(simulation.built()); !lost.empty()) report_warning(lost);
    return simulation.report();
}

}  // namespace tumble::tools
