#include "python/bindings/env_worlds.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "python/bindings/env_parts.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::python {

namespace {

// Worlds that a thread takes at once: some 0.1 ms of work. An image of a world takes about that alone.
constexpr std::size_t kChunk = 64, kChunkOfImages = 2;

// An environment has at most so many threads, and at most one for each world.
constexpr std::size_t kMostThreads = 1024;

// The memory of a world of a few bodies: it lies behind its definition, as long as the allocator has put it there.
constexpr std::size_t kPrefetched = 5632, kCacheLine = 64;

// Thousands of worlds are more than the cache holds. Asking for the next one while this one makes its step saves a
// third of the time of cart-poles.
void prefetch(const World& world) {
    const auto begin = reinterpret_cast<std::uintptr_t>(&world.def());
    for (std::size_t at = 0; at < kPrefetched; at += kCacheLine)
        __builtin_prefetch(reinterpret_cast<const void*>(begin + at));
}

// Throws SceneError with the line of what is wrong in custom.env.
void refuse(const EnvPlan& plan, const std::string& pointer, const ValueProblem& problem) {
    refuse_value(plan.text, plan.file, "/custom/env" + pointer, problem);
}

template <class T>
std::span<T> row(std::span<T> rows, std::size_t index, std::size_t width) {
    return rows.subspan(index * width, width);
}

}  // namespace

EnvWorlds::EnvWorlds(const Scene& scene, EnvPlan plan, std::size_t count, int threads, std::uint64_t seed)
    : plan_(std::move(plan)),
      scene_(scene),
      start_(build_world(scene)),
      images_(scene, start_, plan_.images),
      seed_(seed),
      episodes_(count, 0),
      workers_(std::clamp(threads, 1, std::max(1, static_cast<int>(std::min(count, kMostThreads))))) {
    for (const std::string& name : plan_.observation_names) names_.push_back("previous_" + name);
    for (const std::string& name : plan_.action_names) names_.push_back("action_" + name);
    names_.insert(names_.end(), plan_.observation_names.begin(), plan_.observation_names.end());
    check_names(plan_.actions, plan_.action_names);
    check_names(plan_.observations, plan_.observation_names);
    for (std::size_t i = 0; i < plan_.observations.size(); ++i) {
        const ObservedPlan& observed = plan_.observations[i];
        needs_contacts_ |= observed.kind == ObservedKind::touching || observed.kind == ObservedKind::contact_force;
        measured_.emplace_back();
        if (observed.kind == ObservedKind::value)
            measured_.back().emplace(compile(observed.expression, observed.pointer + "/value", first_seen() + i));
    }
    reward_.emplace(compile(plan_.reward, "/reward", names_.size()));
    done_.emplace(compile(plan_.done, "/done", names_.size()));
    if (done_->kind() != Expression::Kind::condition)
        refuse(plan_, "/done", {.message = "done must be a condition, and '" + plan_.done + "' is a number"});
    if (std::ranges::any_of(scene.draws, [](const SceneDraw& draw) { return !draw.pointer.empty(); }))
        text_ = to_json(scene);
    workspaces_.resize(workers_.count());
    for (Workspace& workspace : workspaces_) workspace.values.resize(names_.size());
    const std::vector<std::byte> snapshot = start_.world.save();
    for (std::size_t i = 0; i < count; ++i) worlds_.push_back(World::load(snapshot));
}

// `names` of the values may be in it, those that are known when it is evaluated.
Expression EnvWorlds::compile(const std::string& text, const std::string& pointer, std::size_t names) const {
    try {
        return Expression(text, scene_, {}, std::span(names_).first(names));
    } catch (const ExpressionError& error) {
        refuse(plan_, pointer, {.message = error.what(), .hint = error.hint, .inside = error.offset});
        throw;
    }
}

// That expressions may have the name of each entry.
template <class Entry>
void EnvWorlds::check_names(const std::vector<Entry>& entries, std::span<const std::string> names) const {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        try {
            Expression("0", scene_, {}, names.subspan(i, 1));
        } catch (const ExpressionError& error) {
            refuse(plan_, entries[i].pointer + "/name", {.message = error.what(), .hint = error.hint});
        }
    }
}

// The start of the next episode of a world, with random numbers of its own.
World EnvWorlds::redrawn(std::size_t index) const {
    LoadOptions options;
    options.seed = random_whole(seed_, index, episodes_[index], plan_.randoms.size());
    SceneWorld drawn = build_world(parse_scene(text_, plan_.file, options));
    if (drawn.bodies.size() != start_.bodies.size() || drawn.joints.size() != start_.joints.size())
        throw std::invalid_argument("the random numbers of " + plan_.file + " change how many bodies or joints it has");
    return std::move(drawn.world);
}

void EnvWorlds::seed(std::uint64_t seed) {
    seed_ = seed;
    std::fill(episodes_.begin(), episodes_.end(), 0);
}

void EnvWorlds::reset_one(std::size_t index, std::span<float> observations, Values& values) {
    World& world = worlds_[index];
    if (text_.empty())
        world.assign(start_.world);
    else
        world.assign(redrawn(index));
    for (std::size_t i = 0; i < plan_.randoms.size(); ++i) {
        const RandomPlan& random = plan_.randoms[i];
        const double part = uniform(seed_, index, episodes_[index], i);
        randomize(world, random, static_cast<float>(double{random.low} + part * double{random.high - random.low}));
    }
    ++episodes_[index];
    std::fill(values.begin(), values.end(), 0.0);
    observe(world, observations, values);
}

void EnvWorlds::observe(const World& world, std::span<float> out, Values& values) const {
    const std::vector<ContactPoint> contacts = needs_contacts_ ? world.contacts() : std::vector<ContactPoint>{};
    for (std::size_t i = 0; i < plan_.observations.size(); ++i) {
        const ObservedPlan& plan = plan_.observations[i];
        const double measured =
            measured_[i] ? measured_[i]->value(world, start_, values) : measure(world, contacts, plan);
        out[i] = static_cast<float>((measured - double{plan.offset}) * double{plan.scale});
        values[first_seen() + i] = double{out[i]};
    }
}

void EnvWorlds::apply(World& world, const double* values) const {
    for (std::size_t i = 0; i < plan_.actions.size(); ++i) act(world, plan_.actions[i], static_cast<float>(values[i]));
}

void EnvWorlds::step_one(std::size_t index, const EnvArrays& arrays, Workspace& workspace) {
    Values& values = workspace.values;
    const std::size_t acts = plan_.actions.size(), seen = plan_.observations.size();
    const std::span<const float> action =
        plan_.choices.empty()
            ? row(arrays.actions, index, acts)
            : row(std::span<const float>(plan_.choices), static_cast<std::size_t>(arrays.choices[index]), acts);
    const std::span<float> out = row(arrays.observations, index, seen);
    std::copy(out.begin(), out.end(), values.begin());
    double* const entries = values.data() + seen;
    for (std::size_t i = 0; i < acts; ++i) entries[i] = double{action_value(plan_.actions[i], action[i])};
    World& world = worlds_[index];
    bool has_ended = false, has_diverged = false;
    try {
        // Forces act during one step only, so that every step gets them.
        for (int k = 0; k < plan_.frame_skip; ++k) {
            apply(world, entries);
            world.step(workspace.memory);
        }
        for (std::size_t i = 0; i < acts; ++i) entries[i] = double{std::clamp(action[i], -1.0f, 1.0f)};
        observe(world, out, values);
        arrays.rewards[index] = reward_->value(world, start_, values);
        has_ended = done_->value(world, start_, values) == 1.0;
    } catch (const SimulationDiverged&) {
        std::fill(out.begin(), out.end(), 0.0f);
        arrays.rewards[index] = 0.0;
        has_ended = has_diverged = true;
    }
    ++arrays.steps[index];
    arrays.terminated[index] = has_ended;
    arrays.truncated[index] = !has_ended && plan_.steps > 0 && arrays.steps[index] >= plan_.steps;
    if (!has_ended && arrays.truncated[index] == 0) return images_.draw(world, start_, arrays.images, index);
    std::copy(out.begin(), out.end(), row(arrays.final_observations, index, seen).begin());
    if (has_diverged)
        images_.clear(arrays.final_images, index);
    else
        images_.draw(world, start_, arrays.final_images, index);
    reset_one(index, out, values);
    images_.draw(world, start_, arrays.images, index);
    arrays.steps[index] = 0;
}

std::size_t EnvWorlds::chunk() const { return images_.count() > 0 ? kChunkOfImages : kChunk; }

void EnvWorlds::step(const EnvArrays& arrays) {
    if (!plan_.choices.empty()) {
        const auto count_choices = static_cast<std::int64_t>(plan_.choices.size() / plan_.actions.size());
        for (const std::int64_t choice : arrays.choices)
            if (choice < 0 || choice >= count_choices)
                throw std::invalid_argument("actions must be indices from 0 to " + std::to_string(count_choices - 1) +
                                            ", got " + std::to_string(choice));
    }
    workers_.run(count(), chunk(), [&](const Part& part) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
            if (i + 1 < part.end) prefetch(worlds_[i + 1]);
            step_one(i, arrays, workspaces_[part.thread]);
        }
    });
}

void EnvWorlds::reset(std::span<float> observations, std::span<const ImageArray> images) {
    const std::size_t seen = plan_.observations.size();
    workers_.run(count(), chunk(), [&](const Part& part) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
            reset_one(i, row(observations, i, seen), workspaces_[part.thread].values);
            images_.draw(worlds_[i], start_, images, i);
        }
    });
}

}  // namespace tumble::python
