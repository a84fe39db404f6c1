// Many copies of the world of a scene for learning: acted on, stepped, observed, rewarded and reset in one call.
//
// All worlds start from one snapshot, then each draws its random values from its own seed and the number of its
// episode, so that an episode does not depend on the other worlds or on the number of threads. If the scene itself has
// numbers that are declared as random, each episode reads it again with a seed of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "python/bindings/env_images.hpp"
#include "python/bindings/env_plan.hpp"
#include "python/bindings/workers.hpp"
#include "tumble/scene_run.hpp"
#include "tumble/step_memory.hpp"

namespace tumble::python {

// The arrays of a step of n worlds: an entry or a row for each.
struct EnvArrays {
    std::span<const float> actions;                 // [n, actions], if the agent gives rows
    std::span<const std::int64_t> choices;          // [n], if it chooses
    std::span<float> observations;                  // [n, observations]
    std::span<float> final_observations;            // [n, observations]: written where an episode ends
    std::vector<ImageArray> images, final_images;   // of each image of the plan
    std::span<double> rewards;                      // [n]
    std::span<std::uint8_t> terminated, truncated;  // [n]
    std::span<std::int64_t> steps;                  // [n], of the present episode
};

class EnvWorlds {
public:
    // Throws SceneError, with the line of an expression that is wrong.
    EnvWorlds(const Scene& scene, EnvPlan plan, std::size_t count, int threads, std::uint64_t seed);

    std::size_t count() const { return worlds_.size(); }
    const EnvPlan& plan() const { return plan_; }
    const EnvImages& images() const { return images_; }
    World& world(std::size_t index) { return worlds_.at(index); }

    // Acts, steps all worlds frame_skip times and writes what comes of it. A world that diverges terminates with the
    // reward 0, and with observations and images of 0. Worlds whose episode ends are reset. Throws
    // std::invalid_argument for a choice that does not exist, before anything changes, and RenderError for images.
    void step(const EnvArrays& arrays);

    // Starts a new episode in all worlds, and writes their observations and their images.
    void reset(std::span<float> observations, std::span<const ImageArray> images);

    // The next reset() begins with episode 0 of a seed again.
    void seed(std::uint64_t seed);

private:
    // Numbers of one world that expressions name: previous observations, actions, observations. An expression of an
    // observation names those before it.
    using Values = std::vector<double>;

    // What a thread works in.
    struct Workspace {
        StepMemory memory;
        Values values;
    };

    void step_one(std::size_t index, const EnvArrays& arrays, Workspace& workspace);
    void reset_one(std::size_t index, std::span<float> observations, Values& values);
    void observe(const World& world, std::span<float> out, Values& values) const;
    std::size_t chunk() const;
    std::size_t first_seen() const { return plan_.observations.size() + plan_.actions.size(); }
    void apply(World& world, const double* values) const;
    Expression compile(const std::string& text, const std::string& pointer, std::size_t names) const;
    template <class Entry>
    void check_names(const std::vector<Entry>& entries, std::span<const std::string> names) const;
    World redrawn(std::size_t index) const;

    EnvPlan plan_;
    Scene scene_;
    SceneWorld start_;  // of all episodes; its ids are valid in all worlds
    std::string text_;  // of a scene that declares random numbers; else empty
    EnvImages images_;
    std::vector<std::string> names_;                   // of Values
    std::vector<std::optional<Expression>> measured_;  // of observations that are expressions
    std::optional<Expression> reward_, done_;
    bool needs_contacts_ = false;
    std::uint64_t seed_ = 0;
    std::vector<World> worlds_;
    std::vector<std::uint64_t> episodes_;  // begun in each world
    Workers workers_;
    std::vector<Workspace> workspaces_;  // by thread
};

}  // namespace tumble::python
