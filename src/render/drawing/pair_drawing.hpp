// The two shapes of a distance query, in the coordinates of a drawing: world axes, relative to A's position. A pair
// 10 km from the origin gives the same picture as one at the origin.
#pragma once

#include <string>
#include <vector>

#include "render/drawing/panel.hpp"

namespace tumble::render {

class PairDrawing {
public:
    PairDrawing(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b)
        : a_(a),
          b_(b),
          pose_a_{{}, world_from_a.rotation},
          pose_b_{world_from_b.position - world_from_a.position, world_from_b.rotation},
          origin_(world_from_a.position) {}

    double radii() const { return double{a_.radius()} + double{b_.radius()}; }
    double smaller_extent() const;
    DVec2 from_world(DVec2 point) const { return point - origin_; }

    // The outlines of the cores grown by `radius`, counter-clockwise.
    std::vector<DVec2> outline_a(double radius) const;
    std::vector<DVec2> outline_b(double radius) const;
    std::vector<DVec2> outline_difference(double radius) const;  // of A - B

    // Both shapes with their letters, cores, witness points and normal.
    void draw(Panel& panel, const DistanceResult& result) const;

private:
    DVec2 support_a(DVec2 direction) const { return world_support(a_, pose_a_, direction); }
    DVec2 support_b(DVec2 direction) const { return world_support(b_, pose_b_, direction); }

    const Shape& a_;
    const Shape& b_;
    Pose pose_a_, pose_b_;  // relative to A's position
    DVec2 origin_;          // A's position in the world
};

// Draws a panel with both shapes whole.
void draw_pair_panel(Drawing& drawing, PixelRect rect, const PairDrawing& pair, const DistanceResult& result);

// Five digits at most.
std::string short_number(double value);

DVec2 mean(const std::vector<DVec2>& points);

}  // namespace tumble::render
