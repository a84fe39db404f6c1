#include "tools/run/simulation.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/run/frame_output.hpp"
#include "tools/run/frame_schedule.hpp"
#include "tools/run/lost_bodies.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/step_files.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

// One run, from its open files to its report.
class Simulation {
public:
    Simulation(const Scene& scene, const RunOptions& options);

    void run();
    void write_summary();
    const RunReport& report() const noexcept { return report_; }
    const SceneWorld& built() const noexcept { return run_.built(); }

private:
    void record_step();
    void close_files();
    void update_report();

    const RunOptions& options_;
    FrameSchedule schedule_;
    SceneRun run_;
    std::optional<EventsFile> events_;
    std::optional<TrajectoryFile> trajectory_;
    std::optional<ContactsFile> contacts_;
    std::optional<HashFile> hashes_;
    std::optional<OutputFile> summary_;
    std::optional<FrameOutput> frames_;
    Stopwatch watch_;
    RunReport report_;
};

FrameSchedule make_schedule(const Scene& scene, const RunOptions& options) {
    return {options.duration.value_or(scene.world.duration), options.frames_per_second, scene.world.steps_per_second};
}

// Of two files with the same name, the second would replace the first.
void require_different_files(const RunOptions& options) {
    std::set<std::filesystem::path> names{std::filesystem::absolute(summary_file(options.folder)).lexically_normal(),
                                          std::filesystem::absolute(events_file(options.folder)).lexically_normal()};
    for (const std::filesystem::path* const file : {&options.contacts, &options.trajectory, &options.hashes})
        if (!file->empty() && !names.insert(std::filesystem::absolute(*file).lexically_normal()).second)
            throw CLI::ValidationError(file->string(), "names two output files of the run; give each its own name");
}

Simulation::Simulation(const Scene& scene, const RunOptions& options)
    : options_(options), schedule_(make_schedule(scene, options)), run_(scene) {
    report_.scene_name = scene.name;
    report_.scene_hash = scene_hash(scene);
    report_.seed = scene.world.seed;
    report_.dt = 1.0 / scene.world.steps_per_second;
    const bool with_frames = !options.no_frames;
    if (with_frames && schedule_.repeats_frames())
        report_warning("--fps exceeds the steps per second of the scene: some frames repeat the previous one");
    require_different_files(options);
    for (const std::filesystem::path* const file : {&options.contacts, &options.trajectory, &options.hashes})
        if (!file->empty()) refuse_to_overwrite(*file, options.force);  // before any file is created
    prepare_run_folder(options.folder, with_frames, options.force);
    summary_.emplace(open_output(summary_file(options.folder), options.force));
    events_.emplace(events_file(options.folder), options.force, run_.built());
    if (!options.contacts.empty()) contacts_.emplace(options.contacts, options.force);
    if (!options.trajectory.empty()) trajectory_.emplace(options.trajectory, options.force);
    if (!options.hashes.empty()) hashes_.emplace(options.hashes, options.force);
    if (with_frames) frames_.emplace(scene, run_.built(), options, schedule_);
}

void Simulation::run() {
    const std::uint64_t step_count = schedule_.step_count();
    Progress progress("step", step_count);
    record_step();
    for (std::uint64_t step = 0; step < step_count && !is_interrupted(); ++step) {
        const Stopwatch watch;
        run_.step();
        report_.simulate_seconds += watch.seconds();
        add_times(report_.stages, run_.world().counters().ms);
        record_step();
        progress.show(step + 1);
    }
    close_files();
    report_.complete = run_.world().step_count() == step_count;
}

void Simulation::record_step() {
    events_->record(run_.built());
    if (trajectory_) trajectory_->record(run_.built());
    if (contacts_) contacts_->record(run_.built());
    if (hashes_) hashes_->record(run_.world());
    if (frames_) frames_->draw_due(run_.built());
}

void Simulation::close_files() {
    if (frames_) report_.files.push_back(frames_->finish());
    report_.files.push_back({"events", events_file(options_.folder), 1, events_->file().commit()});
    if (contacts_) report_.files.push_back({"contacts", options_.contacts, 1, contacts_->file().commit()});
    if (trajectory_) report_.files.push_back({"trajectory", options_.trajectory, 1, trajectory_->file().commit()});
    if (hashes_) report_.files.push_back({"hashes", options_.hashes, 1, hashes_->file().commit()});
}

void Simulation::update_report() {
    report_.steps = run_.world().step_count();
    report_.bodies = run_.world().bodies().size();
    report_.counters = run_.world().counters();
    const std::vector<int> islands = run_.world().islands();
    if (!islands.empty()) report_.islands = std::ranges::max(islands) + 1;
    report_.memory = run_.world().memory();
    report_.state_hash = run_.world().state_hash();
    if (frames_) {
        report_.render_seconds = frames_->render_seconds();
        report_.encode_seconds = frames_->encode_seconds();
    }
    report_.total_seconds = watch_.seconds();
}

void Simulation::write_summary() {
    update_report();
    summary_->write(to_json(report_));
    summary_->commit();
}

}  // namespace

RunReport simulate(const Scene& scene, const RunOptions& options) {
    catch_interrupts();
    Simulation simulation(scene, options);
    try {
        simulation.run();
    } catch (...) {
        try {
            simulation.write_summary();
        } catch (const FileError&) {
            // The first error is reported; that of the summary would hide it.
        }
        throw;
    }
    simulation.write_summary();
    if (const std::string lost = lost_bodies_text(simulation.built()); !lost.empty()) report_warning(lost);
    return simulation.report();
}

}  // namespace tumble::tools
