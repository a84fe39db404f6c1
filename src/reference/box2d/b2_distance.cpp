#include "reference/box2d/b2_distance.hpp"

#include <box2d/b2_distance.h>

#include <array>
#include <cmath>
#include <vector>

#include "reference/box2d/b2_types.hpp"

namespace tumble::reference {

namespace {

// Vertices in an array for b2DistanceProxy, which keeps a pointer to them.
class VertexBuffer {
public:
    explicit VertexBuffer(const Shape& shape) {
        const auto count = static_cast<std::size_t>(shape.vertex_count());
        if (count > inline_.size()) large_.resize(count);
        b2Vec2* vertices = large_.empty() ? inline_.data() : large_.data();
        for (std::size_t i = 0; i < count; ++i) vertices[i].Set(shape.x()[i], shape.y()[i]);
        data_ = vertices;
    }
    VertexBuffer(const VertexBuffer&) = delete;
    VertexBuffer& operator=(const VertexBuffer&) = delete;

    const b2Vec2* data() const { return data_; }

private:
    std::array<b2Vec2, Shape::kInlineVertices> inline_;
    std::vector<b2Vec2> large_;
    const b2Vec2* data_ = nullptr;
};

bool fits_float(const PairQuery& query) {
    const auto fits = [](DVec2 position) { return is_finite(to_float(position)); };
    return is_finite(query) && fits(query.pose_a.position) && fits(query.pose_b.position);
}

DVec2 from_b2(const b2Vec2& v) { return {double{v.x}, double{v.y}}; }

}  // namespace

std::optional<B2Distance> b2_distance(const PairQuery& query, bool use_radii) {
    if (!fits_float(query)) return std::nullopt;
    const VertexBuffer vertices_a(query.a), vertices_b(query.b);
    b2DistanceInput input;
    input.proxyA.Set(vertices_a.data(), query.a.vertex_count(), query.a.radius());
    input.proxyB.Set(vertices_b.data(), query.b.vertex_count(), query.b.radius());
    input.transformA = to_b2(query.pose_a);
    input.transformB = to_b2(query.pose_b);
    input.useRadii = use_radii;
    b2SimplexCache cache{};  // count 0: a cold start
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return B2Distance{double{output.distance}, from_b2(output.pointA), from_b2(output.pointB), output.iterations};
}

}  // namespace tumble::reference
