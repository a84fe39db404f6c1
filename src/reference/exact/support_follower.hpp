// Support values of outlines for a sequence of directions that turns counter-clockwise, in any arithmetic:
// kSetDot(Number& target, const Point& p, const Point& q) sets the target to p . q.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace tumble::reference {

// An outline of at most this many vertices is searched. In a larger one the support vertex is followed, which requires
// convexity; rounding may then stop the search at a vertex before the support, with a value that is too small.
inline constexpr std::size_t kSearchAll = 64;

template <class Point, class Number, auto kSetDot>
class SupportFollower {
public:
    explicit SupportFollower(const std::vector<Point>& vertices) : vertices_(vertices) {}

    // Valid until the next call.
    const Number& maximum(const Point& direction) {
        if (vertices_.size() <= kSearchAll || !started_) {
            search_all(direction);
        } else {
            follow(direction);
        }
        started_ = true;
        return value_;
    }

private:
    void search_all(const Point& direction) {
        using std::swap;
        kSetDot(value_, vertices_[0], direction);
        index_ = 0;
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            kSetDot(next_value_, vertices_[i], direction);
            if (next_value_ > value_) {
                swap(value_, next_value_);
                index_ = i;
            }
        }
    }

    void follow(const Point& direction) {
        using std::swap;
        kSetDot(value_, vertices_[index_], direction);
        for (std::size_t step = 0; step < vertices_.size(); ++step) {
            const std::size_t next = index_ + 1 == vertices_.size() ? 0 : index_ + 1;
            kSetDot(next_value_, vertices_[next], direction);
            if (next_value_ < value_) return;
            swap(value_, next_value_);
            index_ = next;
        }
    }

    const std::vector<Point>& vertices_;
    Number value_{}, next_value_{};
    std::size_t index_ = 0;
    bool started_ = false;
};

// h for directions that turn counter-clockwise: max direction . a + max (-direction) . b.
template <class Point, class Number, auto kSetDot>
class MinkowskiFollower {
public:
    MinkowskiFollower(const std::vector<Point>& a, const std::vector<Point>& b) : a_(a), b_(b) {}

    Number support_value(const Point& direction) {
        opposite_.x = -direction.x;
        opposite_.y = -direction.y;
        return a_.maximum(direction) + b_.maximum(opposite_);
    }

private:
    SupportFollower<Point, Number, kSetDot> a_, b_;
    Point opposite_{};
};

}  // namespace tumble::reference
