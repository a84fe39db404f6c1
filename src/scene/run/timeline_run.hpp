// The timeline of a run: which events are due, and what they do to the world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/expressions/program.hpp"
#include "scene/model/body_lookup.hpp"
#include "scene/model/body_plan.hpp"
#include "scene/run/saved_run.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// One entry of the timeline, with its names looked up and its body planned.
struct ScheduledEvent {
    SceneEvent event;
    std::size_t index = 0;           // in the timeline
    BodyLookup body;                 // that it acts on or despawns
    std::optional<JointId> joint{};  // that it acts on or releases
    std::optional<BodyPlan> plan{};  // of the body that it spawns
    SavedEvent state{};              // how far it is

    bool lasts() const { return event.force || event.torque; }
    bool is_waiting() const { return !event.when.empty() && state.held == 0; }
};

class TimelineRun {
public:
    TimelineRun(const Scene& scene, SceneWorld& built);

    // To be called before each step: applies the events that are due.
    void apply_due(SceneWorld& built);

    // To be called after each step: adds the work of the forces that acted during the step.
    void add_work(SceneWorld& built);

    // To be called in the first state and after each step: notes which conditions hold.
    void watch(const SceneWorld& built);

    // Whether a stop is due.
    bool is_stopped(const SceneWorld& built) const;

    std::vector<SavedEvent> state() const;
    // False if the state is that of another timeline.
    bool set_state(const std::vector<SavedEvent>& state, const World& world);

private:
    // A force or torque that acts during the present step, and where its body was at the start.
    struct Push {
        BodyId body;
        DVec2 force{}, center{};
        double torque = 0.0;
        Rotation rotation{};
    };

    // The next time of an event stands beside its index: a step looks at thousands of events that are not due.
    struct OpenEvent {
        std::size_t index = 0;
        double due = 0.0;  // s
    };

    // The condition of one event or more: it is evaluated until it has held once.
    struct Condition {
        Program program;
        std::vector<std::size_t> events{};
        bool has_held = false;
    };

    void open_events(const World& world);  // sets open_ and Condition::has_held from the states of the events
    void apply(ScheduledEvent& scheduled, SceneWorld& built);
    void spawn(ScheduledEvent& scheduled, SceneWorld& built);

    std::vector<ScheduledEvent> events_;
    std::vector<Condition> conditions_;
    // The events that wait for no condition, in the order of the file. Those that are over leave after the next
    // apply_due() at which they are due.
    std::vector<OpenEvent> open_;
    std::vector<Push> pushes_;
    std::string scene_name_;  // for errors
    std::uint64_t seed_ = 0;
    std::size_t bodies_of_file_ = 0;  // how many entries Scene::bodies has
};

}  // namespace tumble::scene
