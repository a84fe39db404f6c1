// Delta debugging: removes parts of something that fails while it still fails.
//
// Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input", IEEE Transactions on Software Engineering
// 28 (2002), section 3: the algorithm ddmin, of which this keeps the tests of complements. Their tests of subsets find
// a core sooner only if it is contiguous, and cost as many calls again if it is not.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tumble::tools {

// The indices of the parts that are kept, ascending.
using KeptParts = std::vector<std::size_t>;

// Answers the index of the first of `count` candidates that still fails, or `count` if none does. `candidate` makes the
// candidate of an index; the answer must not depend on how many are made or tested at once.
using FirstFailing =
    std::function<std::size_t(std::size_t count, const std::function<KeptParts(std::size_t index)>& candidate)>;

// Parts 0 to part_count - 1, all of which together fail. Removes runs of `first_chunk` parts, then of half as many, and
// so on down to single ones, as long as the rest fails. The result is 1-minimal: without any single one of its parts it
// does not fail. A core of k of n parts takes about 2 k log2(n / k) + k calls of a candidate, and never more than
// n^2 + 3 n.
KeptParts minimize(std::size_t part_count, std::size_t first_chunk, const FirstFailing& first_failing);

}  // namespace tumble::tools
