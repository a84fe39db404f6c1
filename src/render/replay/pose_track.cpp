#include "render/replay/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace tumble::render {

namespace {

constexpr double kMillimetre = 1e-3;  // m: below a pixel in any frame of a world of bodies of 1 m
constexpr double kLargest = 0x1p30;   // 1000 km at 1 mm

// The integer that differs from `angle` by whole turns and is nearest to `near`: angles grow over a turn, so that
// prediction works.
std::int64_t unwrapped(std::int64_t angle, std::int64_t near) {
    const std::int64_t turn = kAnglesPerTurn, half = turn / 2;
    const std::int64_t apart = ((angle - near + half) % turn + turn) % turn - half;
    return near + apart;
}

}  // namespace

double position_quantum(double world_scale) { return kMillimetre * std::min(1.0, world_scale); }

std::int64_t quantised(double value, double quantum) {
    return std::llround(std::clamp(value / quantum, -kLargest, kLargest));
}

void PoseTrack::append(const Pose& pose) {
    x_.append(quantised(pose.position.x - base_.x, quantum_));
    y_.append(quantised(pose.position.y - base_.y, quantum_));
    const double turns = angle(pose.rotation) / (2.0 * kPi);
    angle_.append(unwrapped(std::llround(turns * kAnglesPerTurn), angle_.last()));
    ++count_;
}

}  // namespace tumble::render
