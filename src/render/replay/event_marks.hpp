// The events of a run as marks on the scrubber: those of the scene's timeline, and joints that broke.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

struct EventMark {
    std::uint64_t step = 0;  // whose state is the first with the effect
    std::string text;        // "impulse on 'ball'"
};

// The marks of the timeline in the order of time. An event that repeats has at most kMostRepetitions marks.
std::vector<EventMark> timeline_marks(const Scene& scene);
inline constexpr std::size_t kMostRepetitions = 500;

// Collects the events of the timeline whose `when` has held.
class ConditionMarks {
public:
    explicit ConditionMarks(const Scene& scene);

    // To be called in the first state and after each step.
    void record(const SceneWorld& built);
    const std::vector<EventMark>& marks() const noexcept { return marks_; }

private:
    struct Awaited {
        SceneEvent event;
        Expression condition;
    };

    double steps_per_second_;
    std::vector<Awaited> awaited_;
    std::vector<EventMark> marks_;
};

// Collects the joints that break.
class BrokenJoints {
public:
    void record(const SceneWorld& built);
    const std::vector<EventMark>& marks() const noexcept { return marks_; }

private:
    std::vector<EventMark> marks_;
};

}  // namespace tumble::render
