#include "tools/sweep/run_record.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "sweep/store/manifest.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/trajectory_recorder.hpp"
#include "tools/tables/step_files.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

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

// One run while it is simulated.
class SweepRun {
public:
    SweepRun(const Plan& plan, const RunChoice& choice, SceneTexts& texts)
        : plan_(plan), choice_(choice), texts_(texts) {}

    RunRecord make();

private:
    Scene load() const;
    void simulate();
    void record(const SceneWorld& built);
    void look_around() const;
    void evaluate(const SceneRun& run, const Scene& scene);
    void add_data(RunRecord& record) const;

    const Plan& plan_;
    const RunChoice& choice_;
    SceneTexts& texts_;
    RunFindings found_;
    TrajectoryRecorder trajectory_;
    std::optional<EventLines> events_;
    ContactLines contacts_;
    std::string event_text_{EventLines::kHeader}, contact_text_{ContactLines::kHeader}, final_state_;
    Stopwatch watch_;
};

Scene SweepRun::load() const {
    LoadOptions changes;
    changes.overrides = overrides_of(plan_, choice_);
    changes.seed = choice_.seed;
    changes.allow_outside = plan_.allow_outside;
    changes.read_included = [this](const std::filesystem::path& file) { return texts_.read(file); };
    return load_scene(scene_file(plan_, choice_.scene), changes);
}

void SweepRun::record(const SceneWorld& built) {
    const sweep::Written& write = plan_.write;
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
    const Scene scene = load();
    found_.steps = 0;
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    if (plan_.write.events) events_.emplace(run.built());
    watch.observe(run.built());
    record(run.built());
    const std::uint64_t step_count = count_steps(scene);
    while (*found_.steps < step_count && !run.is_stopped()) {
        run.step();
        ++*found_.steps;
        watch.observe(run.built());
        record(run.built());
        look_around();
    }
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
    if ((plan_.filter.claims && found_.failed_claims() > 0) ||
        (!plan_.filter.that.empty() && value_of(plan_.filter.that) != 1.0))
        found_.outcome = "filtered";
    if (!plan_.write.final_state) return;
    const std::vector<std::byte> state = run.world().save();
    final_state_.assign(reinterpret_cast<const char*>(state.data()), state.size());
}

void SweepRun::add_data(RunRecord& record) const {
    const sweep::Written& write = plan_.write;
    if (write.summary) record.members.emplace_back("json", summary_text(plan_, choice_, found_));
    if (found_.outcome != "ok" && found_.outcome != "diverged") return;
    if (write.events) record.members.emplace_back("events.csv", event_text_);
    if (write.contacts) record.members.emplace_back("contacts.csv", contact_text_);
    if (write.final_state && !final_state_.empty()) record.members.emplace_back("state", final_state_);
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

RunRecord SweepRun::make() {
    try {
        simulate();
    } catch (const SimulationDiverged& error) {
        found_.outcome = "diverged";
        found_.message = error.what();
    } catch (const TimedOut&) {
        found_ = {.outcome = "timed_out", .message = "took longer than the timeout of the plan"};
    } catch (const SceneError& error) {
        found_ = {.outcome = "invalid", .message = error.diagnostics.front().message};
    } catch (const ExpressionError& error) {
        found_ = {.outcome = "invalid", .message = error.what()};
    }
    RunRecord record{.run = choice_.run, .outcome = found_.outcome, .steps = found_.steps.value_or(0)};
    add_data(record);
    record.row = table_row(plan_, choice_, found_, data_hash(record));
    return record;
}

}  // namespace

const std::string& SceneTexts::read(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    const auto found = texts_.find(file);
    return found != texts_.end() ? found->second : texts_.emplace(file, read_file(file)).first->second;
}

RunRecord simulate_run(const Plan& plan, std::uint64_t run, SceneTexts& texts) {
    const RunChoice choice = choose_run(plan, run);
    return SweepRun(plan, choice, texts).make();
}

}  // namespace tumble::tools
