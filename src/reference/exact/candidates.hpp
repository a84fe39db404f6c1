// The features of two cores that may attain their signed distance, by intervals: a few, of which exact arithmetic finds
// the right one. INTERVALS.md, 6 proves that it is among them.
#pragma once

#include <vector>

#include "reference/exact/interval_pair.hpp"

namespace tumble::reference {

struct Candidates {
    Interval distance;                       // contains the signed core distance
    std::vector<EstimatedFace> faces;        // that may have the largest separation; none if the cores do not overlap
    std::vector<EstimatedSegment> segments;  // that may be nearest to the origin; none if the cores overlap
};

// Both lists have elements if the intervals do not decide whether the cores overlap.
Candidates find_candidates(const IntervalPair& pair);

// Contains the largest separation of the faces, of which there must be one.
Interval largest_separation(const std::vector<EstimatedFace>& faces);

}  // namespace tumble::reference
