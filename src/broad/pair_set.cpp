#include "broad/pair_set.hpp"

#include <bit>
#include <utility>

#include "debug/check.hpp"

namespace tumble {

std::size_t PairSet::find_slot(std::uint64_t packed) const {
    std::size_t slot = home(packed);
    while (slots_[slot] != kEmpty && slots_[slot] != packed) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
}

bool PairSet::contains(ProxyPair pair) const { return !slots_.empty() && slots_[find_slot(pack(pair))] != kEmpty; }

void PairSet::insert(ProxyPair pair) {
    TUMBLE_CHECK(pair.a < pair.b);
    TUMBLE_CHECK(!contains(pair));
    if (2 * (size_ + 1) > slots_.size()) grow();
    TUMBLE_CHECK(std::has_single_bit(slots_.size()));
    TUMBLE_CHECK(2 * (size_ + 1) <= slots_.size());
    slots_[find_slot(pack(pair))] = pack(pair);
    ++size_;
}

void PairSet::grow() {
    const std::vector<std::uint64_t> old = std::exchange(slots_, {});
    slots_.assign(old.empty() ? 64 : 2 * old.size(), kEmpty);
    for (const std::uint64_t packed : old)
        if (packed != kEmpty) slots_[find_slot(packed)] = packed;
}

// Closes the gap by moving each following entry back, unless its home slot is after the gap. No tombstones are needed.
void PairSet::erase(ProxyPair pair) {
    if (slots_.empty()) return;
    std::size_t gap = find_slot(pack(pair));
    if (slots_[gap] == kEmpty) return;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = (gap + 1) & mask; slots_[slot] != kEmpty; slot = (slot + 1) & mask) {
        const std::size_t distance_from_home = (slot - home(slots_[slot])) & mask;
        if (distance_from_home >= ((slot - gap) & mask)) {
            slots_[gap] = slots_[slot];
            gap = slot;
        }
    }
    slots_[gap] = kEmpty;
    TUMBLE_CHECK(size_ > 0);
    --size_;
}

}  // namespace tumble
