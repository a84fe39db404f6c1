// Running a scene: its world, the events of its timeline, the evaluation of its claims and of expressions, its health.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/counters.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// The step whose state is nearest to a time (s).
std::uint64_t nearest_step(double time, double steps_per_second);

// The steps from the start of a scene's run to its end.
std::uint64_t count_steps(const Scene& scene);

// The numbers k (from 0) of the steps before which the run of a scene applies an event: for an event that repeats one a
// time (`every` is at least a step), for a force or torque the first only. In order, at most `most` of them, and none
// above `last`. None for an event with a `when`.
std::vector<std::uint64_t> steps_of_event(const SceneEvent& event, double steps_per_second, std::uint64_t last,
                                          std::size_t most);

// Expressions over the bodies, joints and the world of a scene, "ball.x > 3 and not touching(ball, floor)": claims and
// events of scene files are written in them, and a program may use them for plots, filters and rewards. The grammar is
// on the page of the scene format. Lengths are m, times s, angles degrees and angular velocities degrees/s, as in scene
// files. The value of an expression has the same bits on every machine.

// A text that is no expression, or one with a name that the scene does not have.
class ExpressionError : public std::invalid_argument {
public:
    ExpressionError(std::size_t at, const std::string& message, std::string advice = {})
        : std::invalid_argument(message), offset(at), hint(std::move(advice)) {}

    std::size_t offset;  // bytes from the start of the text
    std::string hint;    // may be empty
};

class Expression {
public:
    enum class Kind { number, condition };

    // The names are those of the scene, also of bodies that its timeline spawns later. Positions, angles and velocities
    // are measured in the frame. `values` are names for numbers of the program, such as measurements or actions; none
    // may be a word of the grammar. The text has at most 2000 bytes. Throws
    // ExpressionError.
    Expression(std::string_view text, const Scene& scene, const SceneFrame& frame = {},
               std::span<const std::string> values = {});
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    Kind kind() const noexcept;

    // The value in a state of the scene's world: of a condition 1 (holds) or 0; NaN if it is unknown, for example of a
    // body that does not exist.
    // `values` are the numbers of the names that the constructor got, in their order; those left out are unknown.
    double value(const SceneWorld& built, std::span<const double> values = {}) const;

    // The value in another world, in which the bodies and joints have the ids that they have in `built`: one that was
    // loaded from a snapshot of it.
    double value(const World& world, const SceneWorld& built, std::span<const double> values) const;

    // Whether a condition holds; false if it is unknown, and for numbers.
    bool holds(const SceneWorld& built) const;

    // How far a condition is from holding: positive if it does not hold, infinite if it is unknown. If it holds, at
    // most 0, the larger the nearer it is to failing. Of comparisons the difference of both sides; of bare conditions 1
    // or -1.
    double shortfall(const SceneWorld& built) const;

    // The values that an expression is made of: "a.x is 3, touching(a, b) is false".
    std::string finding(const SceneWorld& built) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The names of the bodies and joints in the text of an expression, each once, in alphabetical order. Throws
// ExpressionError for a text that is no expression.
std::vector<std::string> names_in_expression(std::string_view text);

// Steps the world of a scene. An event at time t is applied before the first step that begins at t or later; step k
// (from 0) begins at k / steps_per_second. Events of one time are applied in the order of the file.
// The condition of a `when` is evaluated in the initial state and after each step; the event is applied before the
// first step that begins `delay` seconds after the first state in which it holds. A stop ends the run in that state.
//
// Between two steps a program may act on world(): forces, motors, new bodies, destroyed ones. The timeline continues,
// and save() contains what the program did. What it creates has no name, so that events and claims do not find it.
class SceneRun {
public:
    // Throws SceneError as build_world() does.
    explicit SceneRun(const Scene& scene);
    ~SceneRun();
    SceneRun(SceneRun&&) noexcept;
    SceneRun& operator=(SceneRun&&) noexcept;

    // Applies the events that are due, then advances by one step. Throws SimulationDiverged, SceneError if the world
    // refuses a spawned body, and std::invalid_argument for an event that sets the velocity of a body that the program
    // has made static or disabled.
    void step();

    // The threads that make the steps, as World::set_threads(). They are not saved.
    void set_threads(const Threads& threads);

    // Whether built().work counts the work of motors from the next step on; it does unless this is called. To measure
    // it takes up to a sixth of the time of a step. Claims on energy, reports and `work` in a timeline need it. A saved
    // run does not contain this choice.
    void count_motor_work(bool counts);

    // The run of this scene as bytes. With the same scene, load() makes a run from them that takes the same steps, bit
    // for bit. The format is that of one version of the library.
    std::vector<std::byte> save(const Scene& scene) const;

    // Throws SceneError as the constructor does, and SnapshotError for bytes that are no whole saved run, or one of a
    // scene with another scene_hash(), apart from the duration, which may change.
    static SceneRun load(const Scene& scene, std::span<const std::byte> saved);

    // Whether an event of the timeline has ended the run: its state stays, and step() must not be called again.
    bool is_stopped() const noexcept;

    double time() const;  // s, of the current state
    const SceneWorld& built() const noexcept;
    const World& world() const noexcept { return built().world; }
    World& world() noexcept;  // to act on; do not step it, which would leave out the timeline, or assign to it

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The result of one claim of a scene.
struct ExpectationResult {
    bool passed = false;
    std::string claim;         // "'crate' is inside [0, 0] to [2, 3] at 4 s"
    std::string finding;       // the deciding state: "it is at [2.5, 0.5]"
    std::uint64_t step = 0;    // that decided it; the last one if the run ended too early
    double time = 0.0;         // s, of that step
    std::string state_hash{};  // of a state_hash claim: the hash in that step, 16 hexadecimal digits

    // False for a claim that a watch cannot decide, because it needs frames or another scene: max_time_ratio, picture.
    // `tumble check` decides them. `passed` is true then.
    bool is_decided = true;
};

// Watches a run and decides the claims of its scene (Scene::expect).
//
// A body is at rest if it sleeps, or if its farthest point is slower than 0.05 m/s times the root of the world's scale,
// the speed below which bodies fall asleep; `at_rest_by` requires that of all dynamic bodies in all states from that
// time on. Whether bodies touch is decided by the contact and sensor events of the steps. A claim on a state is
// evaluated in the states that SceneExpectation::when, at, from and until select. A claim fails if the run never
// reaches such a state, or if its body does not exist there.
//
// A claim may name one body or copy ("crate[3]"), or all copies by their common name ("crate"). A claim on `crate` must
// hold for every copy; a `touches` claim holds if any copy touches. An `always` claim on copies is evaluated in the
// states in which a copy exists, and fails if there is no such state.
class ExpectationWatch {
public:
    ExpectationWatch(const Scene& scene, const SceneWorld& built);
    ~ExpectationWatch();
    ExpectationWatch(ExpectationWatch&&) noexcept;
    ExpectationWatch& operator=(ExpectationWatch&&) noexcept;

    // To be called for the initial state and after each step.
    void observe(const SceneWorld& built);

    // The same for a state after which others are observed: claims on the end of the run are not evaluated in it, which
    // saves time.
    void observe_before_end(const SceneWorld& built);

    // [scene.expect.size()]
    std::vector<ExpectationResult> results() const;

    // What the watch has seen, as bytes. With the same scene, and its world at the start (build_world()), load() makes
    // a watch from them that continues with the run that SceneRun::load() makes. Throws SnapshotError for other bytes,
    // or those of a scene with other claims.
    std::vector<std::byte> save() const;
    static ExpectationWatch load(const Scene& scene, const SceneWorld& start, std::span<const std::byte> saved);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The health of a run: what is wrong with a scene although its file is valid, found while it runs.
//
// Each check has its own subject and a limit that follows from the steps, the gravity, the sizes of the bodies and the
// constants of the solver; src/scene/health/README.md derives them. The watch reads the world through its public
// functions only, so that a run that is watched makes the same steps as one that is not.

struct HealthCheckName {
    std::string_view name;   // in files
    std::string_view title;  // of a finding
    std::string_view rule;   // when there is one
};
inline constexpr std::array<HealthCheckName, 12> kHealthChecks{{
    {"overlap", "Deep overlap",
     "Two bodies start with an overlap of more than 2 % of the smaller one's thickness (at most 1 cm times the scale), "
     "or keep one of more than a quarter of it."},
    {"tunnelling", "Passed through a body",
     "In one step, the centre of a shape crosses another shape from side to side."},
    {"lost", "Fell out of the world",
     "At the end, a body is below all static and kinematic shapes by their height, or by ten times the scale if that "
     "is more."},
    {"jitter", "Jitter at rest",
     "A body that is held where it is reverses its velocity more than twice in eight steps, faster than a body at "
     "rest."},
    {"joint_error", "Joint apart",
     "A joint starts with an error of more than a tenth of the size of its smaller body, or keeps one."},
    {"mass_ratio", "Heavy body on a light one", "A body rests on one that is over 100 times lighter."},
    {"sleepless", "Rests but does not sleep",
     "At the end, a body has been at rest four times as long as it takes to fall asleep, and a cause keeps it awake."},
    {"speed_limit", "Speed limit reached",
     "A body is as fast as a step allows, or turns as fast for as long as it takes to fall asleep."},
    {"energy", "Spike of energy",
     "In one step, the world gains energy without work, or the velocity of a body that nothing touches or holds "
     "changes by more than its thickness per step."},
    {"size", "Size outside the range of the solver",
     "A dynamic body is smaller than 5 mm or larger than 100 m, times the scale."},
    {"stiff_spring", "Spring too stiff for the step",
     "The spring of a joint has a higher frequency than a step can follow."},
    {"motor", "Motor works against a limit",
     "A motor presses a joint against its limit with over 100 times what carries its bodies."},
}};

// One fault, at the moment at which it was worst. Copies of a body or joint share a finding.
struct HealthFinding {
    std::string check;               // a name of kHealthChecks
    std::string subject;             // the bodies or joints at fault: "'crate[3]' and 'floor'"
    std::string text{};              // what is wrong, with the numbers: no capital at its start, no full stop
    std::string remedy{};            // one sentence
    std::uint64_t step = 0;          // of the state that the finding is about
    double time = 0.0;               // s, of that state
    std::vector<BodyId> bodies{};    // that a picture of the state marks
    std::optional<DVec2> point{};    // world, m: where it is
    double value = 0.0;              // what was measured
    double limit = 0.0;              // the largest value without a finding, the smallest for a small body; 0: none
    std::string unit{};              // of both: "m", "m/s"
    std::size_t more_of_a_kind = 0;  // further copies of the same bodies or joints that have the fault
};

// A state, or several consecutive ones of a long run: the last energies, the largest errors.
struct HealthSample {
    double time = 0.0;          // s
    double kinetic = 0.0;       // J, of all dynamic bodies
    double potential = 0.0;     // J
    double work = 0.0;          // J: SceneWorld::work
    DVec2 momentum;             // kg m/s
    double overlap = 0.0;       // m, the deepest
    double joint_error = 0.0;   // m, the largest
    int awake = 0;              // dynamic bodies that are awake
    double milliseconds = 0.0;  // wall clock of the step
};

// The largest value of a quantity in the run.
struct HealthExtreme {
    std::string quantity;   // "deepest overlap"
    std::string unit;       // of the value
    std::string subject{};  // the bodies or the joint
    double value = 0.0;
    std::uint64_t step = 0;
    double time = 0.0;  // s
    DVec2 point{};      // world, m
};

// A step that took longer than most.
struct SlowStep {
    std::uint64_t step = 0;
    StepCounters counters;
};

inline constexpr std::size_t kMostHealthSamples = 8192;
inline constexpr std::size_t kMostHealthFindings = 8;  // of one check
inline constexpr std::size_t kSlowSteps = 5;

// Watches a run. Costs O(bodies + contacts log contacts) for each state: for a large pile up to three times the step.
class HealthWatch {
public:
    // The scene must outlive the watch.
    explicit HealthWatch(const Scene& scene);
    ~HealthWatch();
    HealthWatch(HealthWatch&&) noexcept;
    HealthWatch& operator=(HealthWatch&&) noexcept;

    // To be called for the initial state and after each step.
    void observe(const SceneWorld& built);

    // What was found so far, in the order of kHealthChecks, of each check the worst first, at most kMostHealthFindings.
    // None before the first state. The world that was observed last must still exist, in the same state or in that of a
    // step that diverged.
    std::vector<HealthFinding> findings() const;

    // The deepest overlap, the largest joint error and the fastest body, without those whose value is 0.
    std::vector<HealthExtreme> extremes() const;

    // At most kMostHealthSamples, of equal distance.
    const std::vector<HealthSample>& samples() const noexcept;

    // At most kSlowSteps, the slowest first. These and HealthSample::milliseconds depend on the machine, all else does
    // not.
    const std::vector<SlowStep>& slow_steps() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The dynamic bodies, by their indices in SceneWorld::bodies, that have fallen below all static and kinematic shapes by
// the height of these, or by ten typical bodies if that is more. None without gravity, or without such shapes.
std::vector<std::size_t> find_lost_bodies(const SceneWorld& built);

}  // namespace tumble
