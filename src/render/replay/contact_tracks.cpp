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

ContactTracks::Track& ContactTracks::track_of(const ContactPoint& point, std::uint64_t step,
                                              std::span<const std::uint32_t> body_numbers) {
    const auto [entry, is_new] = open_.try_emplace({point.shape_a, point.shape_b, point.feature});
    Open& open = entry->second;
    if (is_new || open.step + 1 != step) {
        open.track = tracks_.size();
        tracks_.push_back({step, 0, body_numbers[point.body_a.index], body_numbers[point.body_b.index], {}, {}});
    }
    open.step = step;
    return tracks_[open.track];
}

std::array<double, ContactTracks::kSequences> ContactTracks::values_of(const World& world,
                                                                       const ContactPoint& point) const {
    const Pose pose = world.state(point.body_a).pose;
    const DVec2 local = inverse_transform_point(pose, point.point);
    const Vec2 normal = inverse_rotate(pose.rotation, point.normal);
    return {local.x / quantum_, local.y / quantum_, angle({normal.x, normal.y}) * kNormalsPerTurn / (2.0 * kPi),
            impulse_level(double{point.normal_impulse})};
}

void ContactTracks::record(const World& world, std::span<const std::uint32_t> body_numbers) {
    const std::uint64_t step = world.step_count();
    for (const ContactPoint& point : world.contacts()) {
        Track& track = track_of(point, step, body_numbers);
        const std::array<double, kSequences> values = values_of(world, point);
        for (std::size_t i = 0; i < kSequences; ++i) {
            const std::int64_t integer = steady(values[i], track.last[i]);
            append_signed(track.sequences[i], integer - track.last[i]);
            track.last[i] = integer;
        }
        ++track.count;
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
