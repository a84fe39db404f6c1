#include "tools/sweep/runs/run_record.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>

#include "sweep/store/manifest.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/sweep/runs/run_table.hpp"
#include "tools/sweep/runs/trajectory_recorder.hpp"
#include "tools/tables/step_files.hpp"
#include "tumble/file.hpp"
#include "tumble/render.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

using sweep::Plan;
using sweep::RunChoice;

// A run that takes longer than the plan allows.
struct TimedOut {};

// The numbers of parameters for expressions; of a value that is no number NaN.
std::vector<double> numbers_of(const RunChoice& choice) {
    std::vector<double> numbers;
    for (const std::string& value : choice.values) {
        const nlohmann::json json = nlohmann::json::parse(value);
        numbers.push_back(json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN());
    }
    return numbers;
}

// The message of an error as a cell of the table: on one line, and without the folder of the plan, which may be another
// on another machine.
std::string message_of(const Plan& plan, std::string message) {
    std::ranges::replace(message, '\n', ' ');
    const std::string folder = (plan.file.parent_path() / "").lexically_normal().string();
    if (folder.empty() || folder == "./" || folder == "/") return message;
    for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder))
        message.erase(at, folder.size());
    return message;
}

// One run while it is simulated.
class SweepRun {
public:
    using Load = std::function<Scene(const RunChoice&)>;

    // `pictures` may be null.
    SweepRun(const Plan& plan, const RunChoice& choice, Load load, FrameRecorder* pictures)
        : plan_(plan), choice_(choice), load_(std::move(load)), pictures_(pictures) {}

    RunRecord make();

private:
    void simulate();
    void record(const Scene& scene, const SceneWorld& built);
    void look_around() const;
    void evaluate(const SceneRun& run, const Scene& scene);
    void end(const char* outcome, const std::string& message);
    void add_data(RunRecord& record);

    const Plan& plan_;
    const RunChoice& choice_;
    Load load_;
    FrameRecorder* pictures_;
    RunFindings found_;
    TrajectoryRecorder trajectory_;
    std::optional<EventLines> events_;
    ContactLines contacts_;
    std::string event_text_{EventLines::kHeader}, contact_text_{ContactLines::kHeader}, final_state_;
    std::vector<std::pair<std::string, std::string>> picture_files_;
    bool is_stopped_ = false;
    Stopwatch watch_;
};

void SweepRun::record(const Scene& scene, const SceneWorld& built) {
    const sweep::Written& write = plan_.write;
    if (pictures_ != nullptr) pictures_->record(scene, built, *found_.steps, picture_files_);
    if (write.has_trajectory() && *found_.steps % write.trajectory_every == 0) trajectory_.record(built);
    if (*found_.steps == 0) return;
    if (write.events) events_->append(event_text_, built);
    if (write.contacts) contacts_.append(contact_text_, built);
}

// Ends the run for a signal or because it takes too long.
void SweepRun::look_around() const {
    if (is_interrupted()) throw Interrupted{};
    if (plan_.timeout > 0.0 && watch_.seconds() > plan_.timeout) throw TimedOut{};
}

void SweepRun::simulate() {
    const Scene scene = load_(choice_);
    found_.draws = scene.draws;
    found_.steps = 0;
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    if (plan_.write.events) events_.emplace(run.built());
    watch.observe(run.built());
    if (pictures_ != nullptr) pictures_->start(scene, run.built());
    record(scene, run.built());
    const std::uint64_t step_count = count_steps(scene);
    while (*found_.steps < step_count && !run.is_stopped()) {
        run.step();
        ++*found_.steps;
        const bool is_last = *found_.steps == step_count || run.is_stopped();
        is_last ? watch.observe(run.built()) : watch.observe_before_end(run.built());
        record(scene, run.built());
        look_around();
    }
    is_stopped_ = run.is_stopped();
    found_.claims = watch.results();
    evaluate(run, scene);
}

void SweepRun::evaluate(const SceneRun& run, const Scene& scene) {
    const std::vector<std::string> names = parameter_names(plan_);
    const std::vector<double> numbers = numbers_of(choice_);
    const auto value_of = [&](const std::string& text) {
        return Expression(text, scene, {}, names).value(run.built(), numbers);
    };
    for (const sweep::Measure& measure : plan_.measures) found_.measures.push_back(value_of(measure.expression));
    found_.state_hash = run.world().state_hash();
    const std::vector<SceneInstance>& bodies = run.built().bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) found_.bodies.push_back(output_name(bodies[i], i));
    if ((plan_.filter.claims && found_.failed_claims() > 0) ||
        (!plan_.filter.that.empty() && value_of(plan_.filter.that) != 1.0))
        found_.outcome = "filtered";
    if (!plan_.write.final_state) return;
    const std::vector<std::byte> state = run.world().save();
    final_state_.assign(reinterpret_cast<const char*>(state.data()), state.size());
}

void SweepRun::add_data(RunRecord& record) {
    const sweep::Written& write = plan_.write;
    if (write.summary) record.members.emplace_back("json", summary_text(plan_, choice_, found_));
    if (found_.outcome != "ok" && found_.outcome != "diverged") return;
    if (write.events) record.members.emplace_back("events.csv", event_text_);
    if (write.contacts) record.members.emplace_back("contacts.csv", contact_text_);
    if (write.final_state && !final_state_.empty()) record.members.emplace_back("state", final_state_);
    if (pictures_ != nullptr) pictures_->finish(picture_files_);
    std::ranges::move(picture_files_, std::back_inserter(record.members));
    if (!write.has_trajectory()) return;
    record.trajectory = trajectory_.array();
    if (!write.trajectory_in_tar) return;
    record.members.emplace_back("trajectory.npy", to_npy(record.trajectory, write.trajectory_bits));
    record.trajectory = {};
}

// The checksum of all data of a run, which its line of the table has.
std::uint64_t data_hash(const RunRecord& record) {
    std::string all;
    for (const auto& [suffix, bytes] : record.members) all += suffix + '\n' + to_hex(sweep::hash_of(bytes)) + '\n';
    const std::vector<double>& numbers = record.trajectory.numbers;
    all += to_hex(sweep::hash_of({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)}));
    return sweep::hash_of(all);
}

// Nothing is kept of the run but its message.
void SweepRun::end(const char* outcome, const std::string& message) {
    found_ = {.outcome = outcome, .message = message_of(plan_, message)};
}

RunRecord SweepRun::make() {
    try {
        simulate();
    } catch (const SimulationDiverged& error) {
        found_.outcome = "diverged";
        found_.message = error.what();
    } catch (const TimedOut&) {
        end("timed_out", "took longer than the timeout of the plan");
    } catch (const SceneError& error) {
        end("invalid", error.diagnostics.front().message);
    } catch (const ExpressionError& error) {
        end("invalid", error.what());
    } catch (const PictureError& error) {
        end("invalid", error.what());
    } catch (const RenderError&) {
        throw;  // no run would have frames
    } catch (const FileError&) {
        throw;  // of a file that other runs may need, too
    } catch (const std::bad_alloc&) {
        end("failed", "no memory");
    } catch (const std::exception& error) {
        end("failed", error.what());
    }
    RunRecord record{.run = choice_.run,
                     .outcome = found_.outcome,
                     .message = found_.message,
                     .is_stopped = is_stopped_,
                     .steps = found_.steps.value_or(0)};
    add_data(record);
    record.row = table_row(plan_, choice_, found_, data_hash(record));
    return record;
}

}  // namespace

RunMaker::RunMaker(const Plan& plan, SceneTexts& texts) : plan_(plan), texts_(texts) {
    if (plan.write.has_pictures()) pictures_.emplace(plan.write);
}

Scene RunMaker::load(const RunChoice& choice) {
    LoadOptions changes;
    changes.overrides = overrides_of(plan_, choice);
    changes.seed = choice.seed;
    changes.allow_outside = plan_.allow_outside;
    changes.read_included = [this](const fs::path& file) { return texts_.read(file); };
    auto source = sources_.find(choice.scene);
    if (source == sources_.end())
        source =
            sources_.emplace(choice.scene, SceneSource(scene_file(plan_, choice.scene), changes.read_included)).first;
    Scene scene = source->second.load(changes);
    if (plan_.write.has_frames()) read_images(scene);
    return scene;
}

void RunMaker::read_images(const Scene& scene) {
    const auto read = [this](const SceneBody& body) {
        for (const SceneImage& image : body.images)
            if (is_file_there(image.path)) texts_.read(image.path);
    };
    for (const SceneBody& body : scene.bodies) read(body);
    for (const SceneEvent& event : scene.timeline)
        if (event.spawn) read(*event.spawn);
}

RunRecord RunMaker::make(std::uint64_t run) {
    const RunChoice choice = choose_run(plan_, run);
    const auto load_scene_of = [this](const RunChoice& chosen) { return load(chosen); };
    RunRecord record = SweepRun(plan_, choice, load_scene_of, pictures_ ? &*pictures_ : nullptr).make();
    texts_.copy_new();
    return record;
}

RunRecord RunMaker::record_crash(std::uint64_t run, const std::string& signal) const {
    const RunFindings found{.outcome = "crashed", .message = "its process ended by " + signal + ", again and again"};
    RunRecord record{.run = run, .outcome = found.outcome, .message = found.message};
    const RunChoice choice = choose_run(plan_, run);
    if (plan_.write.summary) record.members.emplace_back("json", summary_text(plan_, choice, found));
    record.row = table_row(plan_, choice, found, data_hash(record));
    return record;
}

}  // namespace tumble::tools
