// Ids: an index, and a generation that distinguishes the owners that the index has had.
//
// release() raises the generation, which makes old ids stale; recycle() makes the index available again, the last
// recycled first. An index may have 2^31 owners.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "tumble/id.hpp"

namespace tumble {

template <class IdType>
class IdPool {
public:
    IdType acquire() {
        std::uint32_t index = static_cast<std::uint32_t>(changes_.size());
        if (free_.empty()) {
            changes_.push_back(0);
        } else {
            index = free_.back();
            free_.pop_back();
        }
        const IdType id = at(index);
        TUMBLE_CHECK(!is_live(id));
        ++changes_[index];
        live_.insert(std::lower_bound(live_.begin(), live_.end(), id), id);
        return id;
    }

    // The id becomes stale. acquire() does not return its index before recycle().
    void release(IdType id) {
        TUMBLE_CHECK(is_live(id));
        ++changes_[id.index];
        live_.erase(std::lower_bound(live_.begin(), live_.end(), id));
    }
    void recycle(std::uint32_t index) {
        TUMBLE_CHECK(!is_live(at(index)));
        free_.push_back(index);
    }

    bool is_live(IdType id) const {
        return id.index < changes_.size() && changes_[id.index] == 2 * std::uint64_t{id.generation} + 1;
    }

    // Whether the id was acquired and released.
    bool was_live(IdType id) const { return id.index < changes_.size() && id.generation < at(id.index).generation; }

    // The id of the present owner of an index, or of the next one if there is none.
    IdType at(std::uint32_t index) const {
        TUMBLE_CHECK(index < changes_.size());
        return {index, changes_[index] / 2};
    }

    std::span<const IdType> live() const { return live_; }  // sorted

    // Whether the list of live ids is sorted and agrees with the counts. O(indices).
    bool is_sound() const {
        const auto owned = std::ranges::count_if(changes_, [](std::uint32_t changes) { return changes % 2 == 1; });
        return static_cast<std::size_t>(owned) == live_.size() && std::ranges::is_sorted(live_) &&
               std::ranges::adjacent_find(live_) == live_.end() &&
               std::ranges::all_of(live_, [this](IdType id) { return is_live(id); });
    }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.changes_, self.free_, self.live_);
    }

private:
    std::vector<std::uint32_t> changes_;  // by index: how often it was acquired and released; odd while it has an owner
    std::vector<std::uint32_t> free_;
    std::vector<IdType> live_;
};

}  // namespace tumble
