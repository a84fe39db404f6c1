#include "tools/diff/scene_states.hpp"

#include <algorithm>
#include <utility>

#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

std::string name_of(const SceneWorld& built, BodyId id) {
    const auto found = std::ranges::find(built.bodies, id, &SceneInstance::id);
    return output_name(*found, static_cast<std::size_t>(found - built.bodies.begin()));
}

std::string text_of(const ContactPoint& contact, const std::string& a, const std::string& b) {
    const auto text = [](auto number) {
        std::string digits;
        append_number(digits, number);
        return digits;
    };
    return contact_text(a, b,
                        {text(contact.point.x), text(contact.point.y), text(contact.normal.x), text(contact.normal.y),
                         text(contact.separation), text(contact.normal_impulse)});
}

}  // namespace

std::string contact_text(const std::string& a, const std::string& b, const std::array<std::string, 6>& numbers) {
    const auto& [x, y, normal_x, normal_y, separation, impulse] = numbers;
    return a + " and " + b + " at [" + x + ", " + y + "], normal [" + normal_x + ", " + normal_y + "], separation " +
           separation + " m, impulse " + impulse + " N s";
}

SceneStates::SceneStates(Scene scene) : scene_(std::move(scene)), energy_("kinetic + potential", scene_) {}

double SceneStates::energy() const { return energy_.value(*built()); }

void SceneStates::list(StepStates& states, std::uint64_t step, double time) {
    states.step = step;
    states.time = time;
    states.bodies.clear();
    const SceneWorld& of = *built();
    for (std::size_t i = 0; i < of.bodies.size(); ++i) {
        if (!of.world.is_valid(of.bodies[i].id)) continue;
        const BodyState state = of.world.state(of.bodies[i].id);
        const DVec2 position = state.pose.position;
        states.bodies.push_back({output_name(of.bodies[i], i),
                                 {position.x, position.y, angle(state.pose.rotation), double{state.velocity.x},
                                  double{state.velocity.y}, double{state.angular_velocity}},
                                 !of.bodies[i].name.empty(),
                                 shapes_of(of.bodies[i])});
    }
}

std::vector<std::string> SceneStates::contacts_of(const std::string& body) {
    std::vector<std::string> found;
    for (const ContactPoint& contact : built()->world.contacts()) {
        const std::string a = name_of(*built(), contact.body_a), b = name_of(*built(), contact.body_b);
        if (a == body || b == body) found.push_back(text_of(contact, a, b));
    }
    return found;
}

// A hash of the geometry of the entry that the body came from.
std::uint64_t SceneStates::shapes_of(const SceneInstance& body) {
    const auto [known, is_new] = shapes_.try_emplace(body.source);
    if (!is_new) return known->second;
    Scene alone;
    for (const SceneShape& shape : source_of(scene_, body).shapes) {
        if (alone.bodies.empty()) alone.bodies.emplace_back();
        alone.bodies.back().shapes.push_back({shape.geometry, "", ""});
    }
    return known->second = scene_hash(alone);
}

}  // namespace tumble::tools
