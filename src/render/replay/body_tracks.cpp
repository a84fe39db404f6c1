#include "render/replay/body_tracks.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

#include "render/replay/header_json.hpp"

namespace tumble::render {

namespace {

// Copies of a body follow each other: an equal shape is among the newest, or it is added again.
constexpr std::size_t kNewest = 64;

int type_number(BodyType type) {
    if (type == BodyType::static_body) return 0;
    return type == BodyType::kinematic_body ? 1 : 2;
}

}  // namespace

std::size_t BodyTracks::shape_number(const Shape& shape) {
    const std::size_t oldest = shapes_.size() > kNewest ? shapes_.size() - kNewest : 0;
    const auto found = std::find(shapes_.begin() + static_cast<std::ptrdiff_t>(oldest), shapes_.end(), shape);
    if (found == shapes_.end()) {
        shapes_.push_back(shape);
        return shapes_.size() - 1;
    }
    return static_cast<std::size_t>(found - shapes_.begin());
}

void BodyTracks::add(const SceneWorld& built, std::size_t number, std::uint64_t step) {
    const SceneInstance& body = built.bodies[number];
    const World& world = built.world;
    ordinal_ = number > 0 && built.bodies[number - 1].source == body.source ? ordinal_ + 1 : 0;
    numbers_.emplace(body.id, static_cast<std::uint32_t>(number));
    Track track{output_name(body, number), {}, {}, step, {}, 0.0, PoseTrack(Pose{}, quantum_), {}};
    if (world.is_valid(body.id)) {
        const BodyMass mass = world.mass(body.id);
        track.type = world.type(body.id);
        track.center = DVec2(mass.center);
        track.mass = double{mass.mass};
        track.poses = PoseTrack(world.state(body.id).pose, quantum_);
        const std::span<const ShapeId> ids = world.shapes(body.id);
        std::vector<Paint> paints(ids.size());
        palette_.paint_body(body.source, ordinal_, paints);
        for (std::size_t i = 0; i < ids.size(); ++i)
            track.shapes.push_back({shape_number(world.shape(ids[i])), paints[i].fill, world.is_sensor(ids[i])});
    }
    tracks_.push_back(std::move(track));
}

void BodyTracks::record(const SceneWorld& built, std::uint64_t step) {
    const World& world = built.world;
    while (tracks_.size() < built.bodies.size()) add(built, tracks_.size(), step);
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const BodyId id = built.bodies[i].id;
        if (!world.is_valid(id)) continue;
        Track& track = tracks_[i];
        track.poses.append(world.state(id).pose);
        ++pose_count_;
        const bool was_asleep = track.asleep.size() % 2 == 1;
        const bool is_asleep = track.type == BodyType::dynamic_body && !world.is_awake(id);
        if (is_asleep != was_asleep) track.asleep.push_back(step);
    }
}

nlohmann::ordered_json BodyTracks::shapes_json() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Shape& shape : shapes_) {
        nlohmann::ordered_json points = nlohmann::ordered_json::array();
        for (int i = 0; i < shape.vertex_count(); ++i) {
            points.push_back(brief(double{shape.vertex(i).x}));
            points.push_back(brief(double{shape.vertex(i).y}));
        }
        list.push_back({{"points", std::move(points)}, {"radius", brief(double{shape.radius()})}});
    }
    return list;
}

nlohmann::ordered_json BodyTracks::bodies_json() const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Track& track : tracks_) {
        nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
        for (const DrawnShape& shape : track.shapes)
            shapes.push_back({shape.shape, to_hex(shape.fill), shape.is_sensor ? 1 : 0});
        list.push_back({{"name", track.name},
                        {"type", type_number(track.type)},
                        {"shapes", std::move(shapes)},
                        {"from", track.from},
                        {"count", track.poses.count()},
                        {"base", {track.poses.base().x, track.poses.base().y}},
                        {"center", {brief(track.center.x), brief(track.center.y)}},
                        {"mass", brief(track.mass)},
                        {"asleep", track.asleep}});
    }
    return list;
}

std::string BodyTracks::pose_bytes() const {
    std::string bytes;
    for (std::size_t kind = 0; kind < 3; ++kind)
        for (const Track& track : tracks_) bytes += track.poses.sequences()[kind];
    return bytes;
}

}  // namespace tumble::render
