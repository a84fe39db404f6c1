// What the checks see of a state: the bodies now and before the last step, their sizes, and the contacts. Computed once
// for all checks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"
#include "tumble/world_def.hpp"

namespace tumble::scene {

inline constexpr std::size_t kNoBody = ~std::size_t{0};

// A built body in a state.
struct SeenBody {
    BodyId id{};
    bool exists = false;
    bool is_dynamic = false;
    bool is_awake = false;
    bool touches = false;    // it has a contact point that is not open
    bool is_hit = false;     // a contact of it began in the last step
    std::uint64_t born = 0;  // the step of the first state with it
    BodyState state{};
    DVec2 center{};            // of mass, world, m
    double mass = 0.0;         // kg; 0 if it is not dynamic
    double reach = 0.0;        // m, of the farthest point from the centre of mass
    double smallest = 0.0;     // m: smallest_extent()
    double largest = 0.0;      // m: largest_extent()
    double sleep_speed = 0.0;  // m/s: of its farthest point, as the rules of sleep measure it
};

class HealthView {
public:
    explicit HealthView(const Scene& scene) : scene_(scene) {}

    void update(const SceneWorld& built);

    bool has_state() const { return built_ != nullptr; }  // else nothing below may be called
    const Scene& scene() const { return scene_; }
    const SceneWorld& built() const { return *built_; }
    const World& world() const { return built_->world; }
    std::uint64_t step() const { return built_->world.step_count(); }
    bool is_first() const { return is_first_; }

    double step_duration() const { return 1.0 / world().def().steps_per_second; }  // s
    double scale() const { return double{world().def().scale}; }
    double gravity() const;  // m/s^2
    const WorldLimits& limits() const { return limits_; }

    // The steps in the time after which a body at rest falls asleep; at least 8.
    std::uint64_t steps_to_sleep() const;

    // Four times that: what lasts longer will not pass by itself.
    std::uint64_t patience() const { return 4 * steps_to_sleep(); }

    // [built bodies]; those before have fewer entries if bodies were added since.
    const std::vector<SeenBody>& bodies() const { return bodies_; }
    const std::vector<SeenBody>& bodies_before() const { return before_; }
    bool was_there(std::size_t body) const { return body < before_.size() && before_[body].exists; }

    // Those of bodies of the scene.
    const std::vector<ContactPoint>& contacts() const { return contacts_; }

    // Whether it is a body of the scene: a program may have added others, which no check sees.
    bool knows(BodyId id) const {
        return id.index < index_.size() && index_[id.index] < bodies_.size() && bodies_[index_[id.index]].id == id;
    }

    // The index of an existing body of the scene in SceneWorld::bodies.
    std::size_t index_of(BodyId id) const { return index_[id.index]; }
    std::string name(std::size_t body) const;
    std::size_t source(std::size_t body) const { return built_->bodies[body].source; }

private:
    void add_new_bodies();
    void update_body(std::size_t body);
    void mark_contacts();

    const Scene& scene_;
    const SceneWorld* built_ = nullptr;
    bool is_first_ = true;
    WorldLimits limits_;
    std::vector<SeenBody> bodies_, before_;
    std::vector<ContactPoint> contacts_;
    std::vector<std::size_t> index_;  // of BodyId::index, or kNoBody
};

}  // namespace tumble::scene
