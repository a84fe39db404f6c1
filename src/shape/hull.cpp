// Hull by the monotone chain of Andrew 1979 with exact turns, then a greedy walk that replaces runs of vertices by
// chords.
#include "shape/hull.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "shape/orientation.hpp"
#include "shape/segment_distance.hpp"

namespace tumble {

namespace {

// Appends the chain of strict left turns over points that are sorted along it, without its last point, which begins the
// other chain.
template <typename Iterator>
void append_chain(std::vector<Vec2>& hull, Iterator begin, Iterator end) {
    const std::size_t first = hull.size();
    for (Iterator point = begin; point != end; ++point) {
        while (hull.size() >= first + 2 && orientation(hull[hull.size() - 2], hull.back(), *point) <= 0)
            hull.pop_back();
        hull.push_back(*point);
    }
    hull.pop_back();
}

// Walks a closed hull by indices that may exceed its size.
class HullWalk {
public:
    HullWalk(const std::vector<Vec2>& hull, double tolerance) : hull_(hull), tolerance_(tolerance) {}

    Vec2 at(std::size_t index) const { return hull_[index % hull_.size()]; }

    // True if all vertices strictly between lie within the tolerance of the chord.
    bool chord_fits(std::size_t first, std::size_t last) const {
        for (std::size_t skipped = first + 1; skipped < last; ++skipped)
            if (segment_distance(at(skipped), at(first), at(last)) > tolerance_) return false;
        return true;
    }

    // The end, at most `limit`, of the longest chord from `first` that fits. The vertices that a chord skips are no
    // nearer to a longer chord, which lies behind it, so doubling and bisecting find the end.
    std::size_t longest_chord(std::size_t first, std::size_t limit) const {
        TUMBLE_CHECK(first < limit);
        std::size_t step = 1;
        while (first + 2 * step <= limit && chord_fits(first, first + 2 * step)) step *= 2;
        std::size_t fits = first + step, fails = std::min(limit + 1, first + 2 * step);
        while (fails - fits > 1) {
            const std::size_t middle = fits + (fails - fits) / 2;
            (chord_fits(first, middle) ? fits : fails) = middle;
        }
        return fits;
    }

private:
    const std::vector<Vec2>& hull_;
    double tolerance_;
};

bool is_near_vertex(Vec2 point, const std::vector<Vec2>& kept, double tolerance) {
    return std::any_of(kept.begin(), kept.end(),
                       [&](Vec2 vertex) { return length(DVec2(vertex) - DVec2(point)) <= tolerance; });
}

bool is_near_edge(Vec2 point, const std::vector<Vec2>& kept, double tolerance) {
    for (std::size_t edge = 0; edge < kept.size(); ++edge)
        if (segment_distance(point, kept[edge], kept[(edge + 1) % kept.size()]) <= tolerance) return true;
    return false;
}

}  // namespace

std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), is_before);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    TUMBLE_CHECK(!sorted.empty());
    if (sorted.size() < 3) return sorted;
    std::vector<Vec2> hull;
    hull.reserve(sorted.size() + 2);
    append_chain(hull, sorted.begin(), sorted.end());
    append_chain(hull, sorted.rbegin(), sorted.rend());
    TUMBLE_CHECK(hull.size() >= 2u);
    TUMBLE_CHECK(hull.size() <= sorted.size());
    return hull;
}

std::vector<Vec2> simplify_hull(const std::vector<Vec2>& hull, double tolerance) {
    if (hull.size() < 3) return hull;
    const HullWalk ring(hull, tolerance);
    std::vector<std::size_t> kept;
    for (std::size_t at = 0; at < hull.size(); at = ring.longest_chord(at, hull.size())) kept.push_back(at);
    // The walk never drops its first vertex; drop it here if the chord over it fits.
    if (kept.size() > 2 && ring.chord_fits(kept.back(), hull.size() + kept[1])) kept.erase(kept.begin());
    std::vector<Vec2> result;
    for (const std::size_t index : kept) result.push_back(hull[index]);
    TUMBLE_CHECK(!result.empty());
    TUMBLE_CHECK(result.size() <= hull.size());
    std::rotate(result.begin(), std::min_element(result.begin(), result.end(), is_before), result.end());
    return result;
}

HullReport classify_points(std::span<const Vec2> points, const std::vector<Vec2>& kept, double tolerance) {
    HullReport report;
    report.kept = static_cast<int>(kept.size());
    for (const Vec2 point : points) {
        if (is_near_vertex(point, kept, tolerance))
            ++report.duplicate;
        else if (is_near_edge(point, kept, tolerance))
            ++report.collinear;
        else
            ++report.interior;
    }
    report.duplicate -= report.kept;  // each kept vertex is one of the points and near to itself
    TUMBLE_CHECK(report.duplicate >= 0);
    return report;
}

}  // namespace tumble
