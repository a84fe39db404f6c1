#include "render/replay/contact_tracks.hpp"

#include <algorithm>
#include <cmath>

#include "render/replay/bytes.hpp"

namespace tumble::render {

double impulse_level(double impulse) {
    if (!(impulse > kLeastImpulse)) return 0.0;
    return 1.0 + kImpulsesPerOctave * std::log2(impulse / kLeastImpulse);
}

std::int64_t steady(double value, std::int64_t last) {
    constexpr double kMargin = 0.75;
    constexpr double kLargest = 0x1p30;  // a browser keeps it in 32 bits
    if (std::abs(value - static_cast<double>(last)) <= kMargin) return last;
    return std::llround(std::clamp(value, -kLargest, kLargest));
}

ContactTracks::Track* ContactTracks::find_track(const ContactPoint& point, std::uint64_t step,
                                                const BodyNumbers& body_numbers) {
    const auto entry = open_.find({point.shape_a, point.shape_b, point.feature});
    if (entry != open_.end() && entry->second.step + 1 == step) {
        entry->second.step = step;
        return &tracks_[entry->second.track];
    }
    const auto a = find_number(body_numbers, point.body_a), b = find_number(body_numbers, point.body_b);
    if (!a || !b) return nullptr;
    open_[{point.shape_a, point.shape_b, point.feature}] = {tracks_.size(), step};
    return &tracks_.emplace_back(Track{step, 0, *a, *b, {}, {}});
}

std::array<double, ContactTracks::kSequences> ContactTracks::values_of(const World& world,
                                                                       const ContactPoint& point) const {
    const Pose pose = world.state(point.body_a).pose;
    const DVec2 local = inverse_transform_point(pose, point.point);
    const Vec2 normal = inverse_rotate(pose.rotation, point.normal);
    return {local.x / quantum_, local.y / quantum_, angle({normal.x, normal.y}) * kNormalsPerTurn / (2.0 * kPi),
            impulse_level(double{point.normal_impulse})};
}

void ContactTracks::record(const World& world, std::span<const ContactPoint> points, const BodyNumbers& body_numbers) {
    const std::uint64_t step = world.step_count();
    for (const ContactPoint& point : points) {
        Track* const found = find_track(point, step, body_numbers);
        if (!found) continue;
        Track& track = *found;
        const std::array<double, kSequences> values = values_of(world, point);
        for (std::size_t i = 0; i < kSequences; ++i) {
            const std::int64_t integer = steady(values[i], track.last[i]);
            append_signed(track.sequences[i], integer - track.last[i]);
            track.last[i] = integer;
        }
        ++track.count;
        ++point_count_;
    }
    std::erase_if(open_, [step](const auto& entry) { return entry.second.step != step; });
}

std::string ContactTracks::bytes() const {
    std::string bytes;
    append_varint(bytes, tracks_.size());
    std::uint64_t from = 0;
    for (const Track& track : tracks_) {
        for (const std::uint64_t number :
             {track.from - from, track.count, std::uint64_t{track.a}, std::uint64_t{track.b}})
            append_varint(bytes, number);
        from = track.from;
    }
    for (std::size_t kind = 0; kind < kSequences; ++kind)
        for (const Track& track : tracks_) bytes += track.sequences[kind];
    return bytes;
}

}  // namespace tumble::render
