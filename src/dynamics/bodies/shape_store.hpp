// The shapes of bodies and their proxies in the broad phase, where a shape's index is its key.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "broad/broad_phase.hpp"
#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/bodies/id_pool.hpp"
#include "tumble/body.hpp"
#include "tumble/shape.hpp"

namespace tumble {

struct ShapeRecord {
    Shape shape;  // body coordinates
    SurfaceMaterial material;
    CollisionFilter filter;
    std::uint32_t body = 0;       // index
    float smaller_extent = 0.0f;  // m
    float reach = 0.0f;           // distance of the farthest point from the body's origin, m
    Vec2 center;                  // of its area, body coordinates
    bool is_sensor = false;
    bool is_live = false;
    bool is_placed = false;         // has a proxy: the body is enabled
    std::optional<ChainLink> link;  // if the shape is a chain's segment
    std::uint64_t user_data = 0;
};

// The extent that scales the contact of two shapes, m. A segment has the extent 0 and leaves the scale to the other
// one.
inline float smaller_extent(const ShapeRecord& a, const ShapeRecord& b) {
    const float smaller = std::min(a.smaller_extent, b.smaller_extent);
    return smaller > 0.0f ? smaller : std::max(a.smaller_extent, b.smaller_extent);
}

class ShapeStore {
public:
    // Creates a shape without a proxy.
    ShapeId create(std::uint32_t body, const ShapeDef& def);

    // place() adds a proxy at the body's pose, displace() removes it. Its layer follows from the body's type, and from
    // whether the shape is a sensor. displace() has no effect on a shape without a proxy.
    void place(std::uint32_t shape, const BodyFrame& frame, const Tuning& tuning, BroadPhase& broad);
    void displace(std::uint32_t shape, BroadPhase& broad);

    void set_material(std::uint32_t shape, const SurfaceMaterial& material) { records_[shape].material = material; }
    void set_filter(std::uint32_t shape, const CollisionFilter& filter) { records_[shape].filter = filter; }
    void set_user_data(std::uint32_t shape, std::uint64_t data) { records_[shape].user_data = data; }

    // The index is not used again before forget_destroyed(), because contacts may still refer to it.
    void destroy(ShapeId id, BroadPhase& broad);
    bool has_destroyed() const { return !destroyed_.empty(); }
    void forget_destroyed();

    // The box that the proxy needs, with a new margin, if the shape is not inside its box at the body's pose and during
    // the motion ahead.
    std::optional<Aabb> new_box(std::uint32_t shape, const Pose& world_from_body, const FreeMotion& ahead,
                                const Tuning& tuning, const BroadPhase& broad) const;

    const ShapeRecord& operator[](std::uint32_t index) const {
        TUMBLE_CHECK(index < records_.size());
        return records_[index];
    }
    // Starts to load what new_box() will read: the first 150 bytes of a record.
    void prefetch(std::uint32_t index) const {
        __builtin_prefetch(&records_[index]);
        __builtin_prefetch(reinterpret_cast<const char*>(&records_[index]) + 64);
        __builtin_prefetch(&records_[index].smaller_extent);
    }
    std::size_t capacity() const { return records_.size(); }

    IdPool<ShapeId> ids;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.ids, self.records_, self.destroyed_);
    }

private:
    std::vector<ShapeRecord> records_;  // by shape index
    std::vector<std::uint32_t> destroyed_;
};

// The mass of a dynamic body from its shapes, sensors apart. If they have none: 1 kg with infinite inertia.
BodyMass body_mass(const std::vector<ShapeId>& shapes, const ShapeStore& store);

// The distance of the farthest point of the shapes from a point in body coordinates, m.
float body_reach(Vec2 from, const std::vector<ShapeId>& shapes, const ShapeStore& store);

// The smallest extent of the shapes that are not sensors, m; infinite if there are none.
float smallest_extent(const std::vector<ShapeId>& shapes, const ShapeStore& store);

}  // namespace tumble
