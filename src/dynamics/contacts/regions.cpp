#include "dynamics/contacts/regions.hpp"

#include <algorithm>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

void find_regions(std::span<const std::uint32_t> farthest, std::uint32_t least_bodies,
                  std::vector<std::uint32_t>& bounds) {
    TUMBLE_CHECK(least_bodies > 0);
    const auto count = static_cast<std::uint32_t>(farthest.size());
    bounds.assign(1, kStaticSolverBody + 1);
    std::uint32_t last = 0;  // the last body that one before i is connected with, or is
    for (std::uint32_t i = bounds[0]; i < count; ++i) {
        if (i > last && i - bounds.back() >= least_bodies && count - i >= least_bodies) bounds.push_back(i);
        last = std::max({last, i, farthest[i]});
    }
    bounds.push_back(count);
}

}  // namespace tumble
