// Distances, casts and times of impact by Box2D v3, as b2_distance.hpp and b2_cast.hpp have those of 2.4.
#pragma once

#include <optional>
#include <string>

#include "reference/box2d/b2_cast.hpp"
#include "reference/box2d/b2_distance.hpp"
#include "reference/box2d_v3/library/v3_library.hpp"

namespace tumble::reference {

// Whether this build has it.
bool has_box2d_v3();
std::string box2d_v3_version();  // "3.2.0"
std::string box2d_v3_build();    // how it was compiled

// The core and radius of a shape with at most eight vertices, for the library.
class V3Points {
public:
    explicit V3Points(const Shape& shape, std::optional<float> radius = {});
    bool fits() const { return count_ > 0; }
    box2d_v3::Points get() const { return {xy_, count_, radius_}; }

private:
    float xy_[2 * box2d_v3::kMostPoints] = {};
    int count_ = 0;
    float radius_ = 0.0f;
};

// The pose of B in the frame of A, computed in double: Box2D v3 takes that instead of two world poses.
box2d_v3::Place relative_place(const Pose& a, const Pose& b);

box2d_v3::Motion v3_motion(const Sweep& sweep);

// Nothing for cores of more than eight vertices, numbers that are not finite as a float, and rotations that are not of
// unit length, which Box2D v3 does not accept.
std::optional<B2Distance> b2_v3_distance(const PairQuery& query, bool use_radii);

// Nothing where query_box2d() has no answer, for cores of more than eight vertices, and for a time of impact of a shape
// that turns by more than 0.25 rad, which Box2D v3 moves otherwise.
std::optional<B2Cast> query_box2d_v3(const CastQuery& query);

}  // namespace tumble::reference
