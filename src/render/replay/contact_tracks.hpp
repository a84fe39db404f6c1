// The contact points of a run, packed: one track for each point from its first step to its last.
//
// A point is kept in the coordinates of its body A, where that of a resting or rolling contact hardly moves, and its
// impulse on a logarithmic scale: most differences are 0.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "tumble/world.hpp"

namespace tumble::render {

inline constexpr int kNormalsPerTurn = 128;
inline constexpr double kContactQuantum = 10.0;    // of positions, in quanta of poses
inline constexpr double kLeastImpulse = 1e-6;      // N s
inline constexpr double kImpulsesPerOctave = 2.0;  // 41 % each; half of the bytes are impulses

// 0 for no impulse, else 1 + the parts of an octave above kLeastImpulse.
double impulse_level(double impulse);

// The integer for a value: the last one if it is at most 3/4 off, else the nearest. A value that trembles about half
// way between two integers keeps one of them.
std::int64_t steady(double value, std::int64_t last);

class ContactTracks {
public:
    explicit ContactTracks(double pose_quantum) : quantum_(kContactQuantum * pose_quantum) {}

    // `body_numbers` gives the number in the replay of the body with an id's index.
    void record(const World& world, std::span<const std::uint32_t> body_numbers);

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

    Track& track_of(const ContactPoint& point, std::uint64_t step, std::span<const std::uint32_t> body_numbers);
    std::array<double, kSequences> values_of(const World& world, const ContactPoint& point) const;

    double quantum_;
    std::vector<Track> tracks_;  // in the order of their first steps
    std::map<Key, Open> open_;
};

}  // namespace tumble::render
