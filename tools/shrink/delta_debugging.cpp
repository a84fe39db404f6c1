#include "tools/shrink/delta_debugging.hpp"

#include <algorithm>
#include <numeric>

namespace tumble::tools {

namespace {

KeptParts without_part(const KeptParts& kept, std::size_t begin, std::size_t count) {
    KeptParts rest(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(begin));
    const std::size_t end = std::min(kept.size(), begin + count);
    rest.insert(rest.end(), kept.begin() + static_cast<std::ptrdiff_t>(end), kept.end());
    return rest;
}

// Tries once to remove each run of `chunk` parts.
void remove_chunks(KeptParts& kept, std::size_t chunk, const FirstFailing& first_failing) {
    for (std::size_t begin = 0; begin < kept.size();) {
        const std::size_t count = (kept.size() - begin + chunk - 1) / chunk;
        const std::size_t found =
            first_failing(count, [&](std::size_t index) { return without_part(kept, begin + index * chunk, chunk); });
        if (found == count) return;
        begin += found * chunk;
        kept = without_part(kept, begin, chunk);
    }
}

// Tries to remove single parts, in turns, until none of them can be removed.
void remove_singles(KeptParts& kept, const FirstFailing& first_failing) {
    std::size_t begin = 0;  // after the part that was removed last: those that follow have not been tried for longest
    while (!kept.empty()) {
        const std::size_t count = kept.size();
        const std::size_t found =
            first_failing(count, [&](std::size_t index) { return without_part(kept, (begin + index) % count, 1); });
        if (found == count) return;
        begin = (begin + found) % count;
        kept = without_part(kept, begin, 1);
        if (begin == kept.size()) begin = 0;
    }
}

}  // namespace

KeptParts minimize(std::size_t part_count, std::size_t first_chunk, const FirstFailing& first_failing) {
    KeptParts kept(part_count);
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    for (std::size_t chunk = first_chunk; chunk > 1; chunk = (std::min(chunk, kept.size()) + 1) / 2)
        remove_chunks(kept, chunk, first_failing);
    remove_singles(kept, first_failing);
    return kept;
}

}  // namespace tumble::tools
