#include "render/replay/joint_tracks.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>
#include <variant>

#include "render/replay/header_json.hpp"

namespace tumble::render {

namespace {

std::vector<DVec2> wheels_of(const JointDef& def) {
    if (const auto* pulley = std::get_if<PulleyJointDef>(&def))
        return {pulley->ground_anchor_a, pulley->ground_anchor_b};
    return {};
}

}  // namespace

void JointTracks::append(Track& track, std::uint64_t step, DVec2 a, DVec2 b) const {
    const bool goes_on = !track.spans.empty() && track.spans.back().until == step &&
                         length(track.spans.back().a - a) <= tolerance_ &&
                         length(track.spans.back().b - b) <= tolerance_;
    if (!goes_on) track.spans.push_back({step, step, a, b});
    track.spans.back().until = step + 1;
}

void JointTracks::record(const SceneWorld& built, std::uint64_t step, const BodyNumbers& body_numbers) {
    const World& world = built.world;
    tracks_.resize(built.joints.size());
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const JointId id = built.joints[i].id;
        if (!world.is_valid(id)) continue;
        const std::optional<JointAnchors> anchors = world.joint_anchors(id);
        if (!anchors) continue;
        const auto [a, b] =
            std::visit([](const auto& joint) { return std::pair(joint.body_a, joint.body_b); }, world.joint(id));
        Track& track = tracks_[i];
        if (track.spans.empty()) {
            const auto number_a = find_number(body_numbers, a), number_b = find_number(body_numbers, b);
            if (!number_a || !number_b) continue;
            track = {output_name(built.joints[i], i), *number_a, *number_b, wheels_of(world.joint(id))};
        }
        append(track, step, inverse_transform_point(world.state(a).pose, anchors->a),
               inverse_transform_point(world.state(b).pose, anchors->b));
    }
}

nlohmann::ordered_json JointTracks::to_json() const {
    nlohmann::ordered_json joints = nlohmann::ordered_json::array();
    for (const Track& track : tracks_) {
        if (track.spans.empty()) continue;
        nlohmann::ordered_json spans = nlohmann::ordered_json::array();
        for (const Span& span : track.spans)
            spans.push_back(
                {span.from, span.until, brief(span.a.x), brief(span.a.y), brief(span.b.x), brief(span.b.y)});
        joints.push_back({{"name", track.name},
                          {"a", track.a},
                          {"b", track.b},
                          {"wheels", numbers(track.wheels)},
                          {"spans", spans}});
    }
    return joints;
}

}  // namespace tumble::render
