// The contact points of a run, packed: one track for each point from its first step to its last.
//
// A point is kept in the coordinates of its body A, where that of a resting or rolling contact hardly moves, and its
// impulse on a logarithmic scale: most differences are 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "render/replay/body_numbers.hpp"
#include "tumble/world.hpp"

namespace tumble::render {

inline constexpr int kNormalsPerTurn = 128;
inline constexpr double kContactQuantum = 10.0;    // of positions, in quanta of poses
inline constexpr double kLeastImpulse = 1e-6;      // N s
inline constexpr double kImpulsesPerOctave = 2.0;  // 41 % each; half of the bytes are impulses

inline constexpr std::size_t kPointsPerTrack = 10;  // a track takes 184 bytes, a point at most 20

// 0 for no impulse, else 1 + the parts of an octave above kLeastImpulse.
double impulse_level(double impulse);

// The integer for a value: the last one if it is at most 3/4 off, else the nearest. A value that trembles about half
// way between two integers keeps one of them.
std::int64_t steady(double value, std::int64_t last);

class ContactTracks {
public:
    explicit ContactTracks(double pose_quantum) : quantum_(kContactQuantum * pose_quantum) {}

    // Appends the present contact points between bodies of the scene.
    void record(const World& world, std::span<const ContactPoint> points, const BodyNumbers& body_numbers);

    // What the points so far cost, in points: a contact that begins costs kPointsPerTrack more, for its track.
    std::size_t cost() const noexcept { return point_count_ + kPointsPerTrack * tracks_.size(); }

    // Number of tracks; for each: steps since the start of the track before, number of steps, bodies A and B; then
    // sequences of first differences: x of each track in turn, then y, the angles of the normals, the impulses.
    std::string bytes() const;

private:
    static constexpr std::size_t kSequences = 4;
    using Key = std::tuple<ShapeId, ShapeId, std::uint32_t>;
    struct Track {
        std::uint64_t from = 0, count = 0;
        std::uint32_t a = 0, b = 0;
        std::array<std::int64_t, kSequences> last{};
        std::array<std::string, kSequences> sequences{};
    };
    struct Open {
        std::size_t track = 0;
        std::uint64_t step = 0;  // of its last point
    };

    Track* find_track(const ContactPoint& point, std::uint64_t step, const BodyNumbers& body_numbers);
    std::array<double, kSequences> values_of(const World& world, const ContactPoint& point) const;

    double quantum_;
    std::vector<Track> tracks_;  // in the order of their first steps
    std::map<Key, Open> open_;
    std::size_t point_count_ = 0;
};

}  // namespace tumble::render
