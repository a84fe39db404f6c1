// The algorithm alone: sets of numbers of which some are needed.
#include "tools/shrink/delta_debugging.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <set>

using tumble::tools::KeptParts;
using tumble::tools::minimize;

namespace {

using Fails = std::function<bool(const KeptParts&)>;

struct Search {
    KeptParts kept;
    std::size_t calls = 0;
};

// Asks one candidate after the other, up to the first that fails.
Search search(std::size_t part_count, std::size_t first_chunk, const Fails& fails) {
    Search result;
    result.kept = minimize(part_count, first_chunk, [&](std::size_t count, const auto& candidate) {
        for (std::size_t i = 0; i < count; ++i) {
            ++result.calls;
            if (fails(candidate(i))) return i;
        }
        return count;
    });
    return result;
}

bool contains(const KeptParts& kept, const KeptParts& needed) { return std::ranges::includes(kept, needed); }

}  // namespace

TEST_CASE("of parts that are each needed, delta debugging keeps exactly those, in their order") {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const std::size_t count = 1 + random() % 150, most = std::min<std::size_t>(count, 1 + random() % 6);
        std::set<std::size_t> drawn;
        while (drawn.size() < most) drawn.insert(random() % count);
        const KeptParts needed(drawn.begin(), drawn.end());
        const Search found = search(count, count, [&](const KeptParts& kept) { return contains(kept, needed); });
        CHECK(found.kept == needed);
        // Each halving of the runs tries at most the one of each needed part in vain and removes at most as many.
        const double levels = std::ceil(std::log2(static_cast<double>(count))) + 1.0;
        CHECK(static_cast<double>(found.calls) <=
              (2.0 * static_cast<double>(most) + 1.0) * levels + static_cast<double>(most));
    }
}

TEST_CASE("what delta debugging keeps is 1-minimal, also if parts depend on each other") {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        // Part i needs part of[i], or the set does not fail: removing a single one can be useless until another is
        // gone.
        const std::size_t count = 2 + random() % 40;
        std::vector<std::size_t> of(count);
        for (std::size_t i = 0; i < count; ++i) of[i] = random() % count;
        const std::size_t needed = random() % count;
        const Fails fails = [&](const KeptParts& kept) {
            if (!std::ranges::binary_search(kept, needed)) return false;
            return std::ranges::all_of(kept, [&](std::size_t i) { return std::ranges::binary_search(kept, of[i]); });
        };
        for (const std::size_t chunk : {std::size_t{1}, count}) {
            const Search found = search(count, chunk, fails);
            REQUIRE(fails(found.kept));
            CHECK(found.calls <= count * count + 3 * count);
            for (std::size_t i = 0; i < found.kept.size(); ++i) {
                KeptParts fewer = found.kept;
                fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
                CHECK_FALSE(fails(fewer));
            }
        }
    }
}

TEST_CASE("without needed parts nothing is kept, and without parts nothing is asked") {
    const Search all = search(100, 100, [](const KeptParts&) { return true; });
    CHECK(all.kept.empty());
    CHECK(all.calls == 1);
    CHECK(search(0, 0, [](const KeptParts&) { return true; }).calls == 0);
    CHECK(search(5, 5, [](const KeptParts&) { return false; }).kept == KeptParts{0, 1, 2, 3, 4});
}
