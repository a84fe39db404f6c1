#include "tools/compare/box2d_states.hpp"

#include <cmath>

namespace tumble::tools {

Box2dStates::Box2dStates(const Scene& scene)
    : SceneStates(scene), shown_(build_world(scene)), world_(scene), last_step_(count_steps(scene)) {}

bool Box2dStates::next(StepStates& states) {
    if (started_ && step_ >= last_step_) return false;
    if (started_) {
        world_.step();
        ++step_;
    }
    started_ = true;
    show();
    list(states, step_, static_cast<double>(step_) / scene()->world.steps_per_second);
    return true;
}

void Box2dStates::show() {
    for (std::size_t i = 0; i < shown_.bodies.size(); ++i) {
        const BodyId id = shown_.bodies[i].id;
        if (shown_.world.type(id) == BodyType::static_body) continue;
        const int body = static_cast<int>(i);
        const Pose pose = world_.pose(body);
        const Vec2 velocity = world_.velocity(body);
        const float spin = world_.angular_velocity(body);
        const bool is_known = is_finite(pose.position) && std::isfinite(pose.rotation.c) &&
                              std::isfinite(pose.rotation.s) && std::isfinite(velocity.x) &&
                              std::isfinite(velocity.y) && std::isfinite(spin);
        if (!is_known) throw SimulationDiverged(id, step_, output_name(shown_.bodies[i], i) + " in Box2D");
        shown_.world.set_transform(id, pose);
        if (shown_.world.is_enabled(id)) shown_.world.set_velocity(id, velocity, spin);
    }
}

std::vector<std::string> Box2dStates::notes() const {
    std::vector<std::string> notes = world_.notes();
    if (!scene()->timeline.empty()) notes.emplace_back("the events of the timeline are left out");
    return notes;
}

}  // namespace tumble::tools
