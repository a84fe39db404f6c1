// The poses of one body, packed: quantised, then the second differences of the integers.
//
// Differences of integers sum up to the integers again; differences of quantised doubles would drift.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "render/replay/bytes.hpp"
#include "tumble/math.hpp"

namespace tumble::render {

inline constexpr int kAnglesPerTurn = 4096;

// The step of the grid to which positions are rounded, m.
double position_quantum(double world_scale);

// A sequence of integers as what the two before do not predict: a body in free motion gives small numbers, a body at
// rest zeros.
class PredictedIntegers {
public:
    void append(std::int64_t value) {
        append_signed(bytes_, value - (2 * last_ - before_));
        before_ = last_;
        last_ = value;
    }
    std::int64_t last() const noexcept { return last_; }
    const std::string& bytes() const noexcept { return bytes_; }

private:
    std::int64_t last_ = 0, before_ = 0;
    std::string bytes_;
};

// The integer nearest to value / quantum, limited so that a browser keeps it in 32 bits.
std::int64_t quantised(double value, double quantum);

class PoseTrack {
public:
    // Positions are relative to the first one.
    PoseTrack(const Pose& first, double quantum) : base_(first.position), quantum_(quantum) {}

    void append(const Pose& pose);
    DVec2 base() const noexcept { return base_; }
    std::uint64_t count() const noexcept { return count_; }

    // The packed sequences of x, of y and of the angle.
    std::array<std::string_view, 3> sequences() const { return {x_.bytes(), y_.bytes(), angle_.bytes()}; }

private:
    DVec2 base_;
    double quantum_;
    std::uint64_t count_ = 0;
    PredictedIntegers x_, y_, angle_;
};

}  // namespace tumble::render
