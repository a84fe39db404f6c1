#include "scene/health/extremes.hpp"

#include <string>

#include "scene/model/display.hpp"
#include "scene/model/joint_gap.hpp"

namespace tumble::scene {

namespace {

void set_extreme(HealthExtreme& extreme, const HealthView& view, double value, std::string subject, DVec2 point) {
    extreme.value = value;
    extreme.subject = std::move(subject);
    extreme.point = point;
    extreme.step = view.step();
    extreme.time = view.world().time();
}

}  // namespace

void Extremes::observe(const HealthView& view) {
    for (const ContactPoint& contact : view.contacts())
        if (-double{contact.separation} > overlap_.value)
            set_extreme(overlap_, view, -double{contact.separation},
                        view.name(view.index_of(contact.body_a)) + " and " + view.name(view.index_of(contact.body_b)),
                        contact.point);
    for (std::size_t i = 0; i < view.bodies().size(); ++i) {
        const SeenBody& body = view.bodies()[i];
        const double speed = body.exists ? length(DVec2(body.state.velocity)) : 0.0;
        if (speed > speed_.value) set_extreme(speed_, view, speed, view.name(i), body.center);
    }
    observe_joints(view);
}

void Extremes::observe_joints(const HealthView& view) {
    for (std::size_t i = 0; i < view.built().joints.size(); ++i) {
        const JointId id = view.built().joints[i].id;
        const double gap = view.world().is_valid(id) ? joint_gap(view.world(), id) : 0.0;
        if (gap > joint_error_.value)
            set_extreme(joint_error_, view, gap, display_joint_name(view.built(), i),
                        view.world().joint_anchors(id).value_or(JointAnchors{}).b);
    }
}

std::vector<HealthExtreme> Extremes::list() const {
    std::vector<HealthExtreme> list;
    for (const HealthExtreme& extreme : {overlap_, joint_error_, speed_})
        if (extreme.value > 0.0) list.push_back(extreme);
    return list;
}

}  // namespace tumble::scene
