// The bounding boxes of a compound's parts, and the lower bound that two boxes are for the distance of their parts.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "narrow/cores/core_pair.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"

namespace tumble {

// The boxes are in the frame that the pose is relative to.
struct PartBoxes {
    std::pmr::vector<Aabb> boxes;  // [parts]
    Aabb all;
    double reach = 0.0;  // of the largest part: the distance of its farthest point from the pose's position (m)
    bool valid = true;   // there are parts, and all are valid

    PartBoxes(std::span<const Shape> parts, const Pose& pose, std::pmr::memory_resource* memory) : boxes(memory) {
        boxes.reserve(parts.size());
        for (const Shape& part : parts) {
            boxes.push_back(bounds(part, pose));
            all = merge(all, boxes.back());
            reach = std::max(reach, turned_radius(part, pose.rotation) + part.radius());
            valid = valid && boxes.back().lower.x <= boxes.back().upper.x && part.radius() >= 0.0f;
        }
        TUMBLE_CHECK(boxes.size() == parts.size());
        valid = valid && !parts.empty();
    }
};

// A lower bound of the signed distance of the shapes in the boxes: the gap of the boxes or, if they overlap, minus the
// shortest displacement that separates them (a subset is never nearer than the whole set). The boxes are rounded
// outwards by 2^-23 of their coordinates, more than the roundings here.
inline double separation(const Aabb& a, const Aabb& b) {
    const auto gap = [](double a_lower, double a_upper, double b_lower, double b_upper) {
        return std::max(a_lower - b_upper, b_lower - a_upper);
    };
    const double x = gap(a.lower.x, a.upper.x, b.lower.x, b.upper.x),
                 y = gap(a.lower.y, a.upper.y, b.lower.y, b.upper.y);
    return x > 0.0 && y > 0.0 ? std::sqrt(x * x + y * y) : std::max(x, y);
}

}  // namespace tumble
