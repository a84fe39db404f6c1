// The position of a driven row (rad or m): known, or bounded until it is needed.
#pragma once

namespace tumble {

struct PositionRange {
    float lower = 0.0f, upper = 0.0f;
};

// A position that takes no time to find.
struct KnownPosition {
    float value = 0.0f;

    float now() const { return value; }
    PositionRange range() const { return {value, value}; }
};

// Finds a position once, when it is first needed. `position.range()` contains `position.now()` and takes less time.
template <class Position>
class LazyPosition {
public:
    explicit LazyPosition(const Position& position) : position_(position), range_(position.range()) {}

    PositionRange range() const { return range_; }
    float now() {
        if (range_.lower < range_.upper) range_.lower = range_.upper = position_.now();
        return range_.lower;
    }

private:
    const Position& position_;
    PositionRange range_;
};

}  // namespace tumble
