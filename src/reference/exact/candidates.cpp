#include "reference/exact/candidates.hpp"

#include <algorithm>

#include "debug/check.hpp"

namespace tumble::reference {

namespace {

Interval smallest_distance(const std::vector<EstimatedSegment>& segments) {
    TUMBLE_CHECK(!segments.empty());
    Interval smallest = segments[0].distance;
    for (const EstimatedSegment& segment : segments) {
        smallest.low = std::min(smallest.low, segment.distance.low);
        smallest.high = std::min(smallest.high, segment.distance.high);
    }
    return smallest;
}

void find_nearest_segments(const IntervalPair& pair, Candidates& found) {
    found.segments = pair.segments();
    found.distance = smallest_distance(found.segments);
    std::erase_if(found.segments, [high = found.distance.high](const auto& it) { return it.distance.low > high; });
}

}  // namespace

Interval largest_separation(const std::vector<EstimatedFace>& faces) {
    TUMBLE_CHECK(!faces.empty());
    Interval largest = faces[0].separation;
    for (const EstimatedFace& face : faces) {
        largest.low = std::max(largest.low, face.separation.low);
        largest.high = std::max(largest.high, face.separation.high);
    }
    return largest;
}

Candidates find_candidates(const IntervalPair& pair) {
    Candidates found;
    found.faces = pair.faces();
    if (found.faces.empty()) {  // two points
        find_nearest_segments(pair, found);
        return found;
    }
    const Interval deepest = largest_separation(found.faces);
    std::erase_if(found.faces, [low = deepest.low](const auto& it) { return it.separation.high < low; });
    if (deepest.high < 0) {
        found.distance = deepest;
        return found;
    }
    find_nearest_segments(pair, found);
    // If the cores overlap, the depth is at most -deepest.low, and a segment is as near to the origin.
    if (deepest.low > 0 || found.distance.low > -deepest.low) {
        found.faces.clear();
    } else {
        found.distance.low = std::min(found.distance.low, deepest.low);
    }
    return found;
}

}  // namespace tumble::reference
