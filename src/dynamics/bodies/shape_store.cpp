#include "dynamics/bodies/shape_store.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "debug/check.hpp"

namespace tumble {

ShapeId ShapeStore::create(std::uint32_t body, const ShapeDef& def) {
    const ShapeId id = ids.acquire();
    if (id.index == records_.size()) records_.emplace_back();
    const float smaller = std::min(extent(def.shape).smaller, std::numeric_limits<float>::max());
    const float reach = farthest_distance(def.shape, {});
    TUMBLE_CHECK(id.index < records_.size());
    TUMBLE_CHECK(!records_[id.index].is_live);
    TUMBLE_CHECK(smaller >= 0.0f);
    TUMBLE_CHECK(reach >= 0.0f);

    records_[id.index] = {
        def.shape,  def.material, def.filter, body,     smaller,      reach, mass_properties(def.shape).center,
        def.sensor, true,         false,      def.link, def.user_data};
    return id;
}

namespace {

ProxyLayer layer_of(const ShapeRecord& shape, BodyType body) {
    if (body == BodyType::static_body) return ProxyLayer::fixed;
    return shape.is_sensor || body == BodyType::kinematic_body ? ProxyLayer::kinematic : ProxyLayer::dynamic;
}

}  // namespace

void ShapeStore::place(std::uint32_t shape, const BodyFrame& frame, const Tuning& tuning, BroadPhase& broad) {
    ShapeRecord& record = records_[shape];
    TUMBLE_CHECK(record.is_live);
    TUMBLE_CHECK(!record.is_placed);
    record.is_placed = true;
    const ProxyLayer layer = layer_of(record, frame.type);
    const Aabb box = bounds(record.shape, frame.pose);
    const float margin = tuning.aabb_margin(record.smaller_extent);
    broad.add(shape, layer == ProxyLayer::fixed ? box : enlarged(box, margin), layer);
}

void ShapeStore::displace(std::uint32_t shape, BroadPhase& broad) {
    if (records_[shape].is_placed) broad.remove(shape);
    records_[shape].is_placed = false;
}

void ShapeStore::destroy(ShapeId id, BroadPhase& broad) {
    TUMBLE_CHECK(ids.is_live(id));
    displace(id.index, broad);
    records_[id.index] = ShapeRecord{};
    ids.release(id);
    destroyed_.push_back(id.index);
}

void ShapeStore::forget_destroyed() {
    for (const std::uint32_t index : destroyed_) {
        TUMBLE_CHECK(!records_[index].is_live);
        ids.recycle(index);
    }
    destroyed_.clear();
}

std::optional<Aabb> ShapeStore::new_box(std::uint32_t shape, const Pose& world_from_body, const FreeMotion& ahead,
                                        const Tuning& tuning, const BroadPhase& broad) const {
    const ShapeRecord& record = records_[shape];
    TUMBLE_CHECK(record.is_placed);
    const float margin = tuning.aabb_margin(record.smaller_extent);
    Aabb box = bounds(record.shape, world_from_body);
    const float turned = std::min(std::abs(ahead.turn), 2.0f) * record.reach;
    if (turned > margin) box = enlarged(box, turned);
    box = merge(box, {box.lower + ahead.path, box.upper + ahead.path});
    if (contains(broad.box(shape), box)) return std::nullopt;
    return enlarged(box, margin);
}

BodyMass body_mass(const std::vector<ShapeId>& shapes, const ShapeStore& store) {
    double mass = 0.0, inertia = 0.0;  // inertia about the body's origin until the centre is known
    DVec2 moment;
    for (const ShapeId id : shapes) {
        const ShapeRecord& record = store[id.index];
        TUMBLE_CHECK(record.is_live);
        if (record.is_sensor) continue;
        const MassProperties part = mass_properties(record.shape);
        const double part_mass = static_cast<double>(record.material.density) * part.area;
        const DVec2 center(part.center);
        mass += part_mass;
        moment += part_mass * center;
        inertia += static_cast<double>(record.material.density) * part.inertia + part_mass * length_sq(center);
    }
    // The inverse of a mass between these is neither 0 nor infinite.
    constexpr double kLightest = std::numeric_limits<float>::min(), kHeaviest = std::numeric_limits<float>::max();
    if (!(mass >= kLightest)) return {1.0f, {}, 0.0f};
    const DVec2 center = (1.0 / mass) * moment;
    inertia -= mass * length_sq(center);
    return {static_cast<float>(std::min(mass, kHeaviest)), to_float(center),
            static_cast<float>(std::min(inertia, kHeaviest))};
}

float body_reach(Vec2 from, const std::vector<ShapeId>& shapes, const ShapeStore& store) {
    float reach = 0.0f;
    for (const ShapeId id : shapes) reach = std::max(reach, farthest_distance(store[id.index].shape, from));
    return reach;
}

float smallest_extent(const std::vector<ShapeId>& shapes, const ShapeStore& store) {
    float smallest = std::numeric_limits<float>::infinity();
    for (const ShapeId id : shapes)
        if (!store[id.index].is_sensor) smallest = std::min(smallest, store[id.index].smaller_extent);
    return smallest;
}

}  // namespace tumble
