// Ids: an index, and a generation that distinguishes the owners that the index has had.
//
// release() raises the generation, which makes old ids stale; recycle() makes the index available again, the last
// recycled first.
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
        std::uint32_t index = static_cast<std::uint32_t>(generations_.size());
        if (free_.empty()) {
            generations_.push_back(0);
        } else {
            index = free_.back();
            free_.pop_back();
        }
        TUMBLE_CHECK(index < generations_.size());
        const IdType id{index, generations_[index]};
        live_.insert(std::lower_bound(live_.begin(), live_.end(), id), id);
        return id;
    }

    // The id becomes stale. acquire() does not return its index before recycle().
    void release(IdType id) {
        TUMBLE_CHECK(is_live(id));
        ++generations_[id.index];
        live_.erase(std::lower_bound(live_.begin(), live_.end(), id));
    }
    void recycle(std::uint32_t index) {
        TUMBLE_CHECK(index < generations_.size());
        TUMBLE_CHECK(!is_live(at(index)));
        free_.push_back(index);
    }

    bool is_live(IdType id) const {
        return id.index < generations_.size() && generations_[id.index] == id.generation &&
               std::binary_search(live_.begin(), live_.end(), id);
    }

    // Whether the id was acquired and released.
    bool was_live(IdType id) const { return id.index < generations_.size() && id.generation < generations_[id.index]; }

    // The id of the present owner of an index, or of the next one if there is none.
    IdType at(std::uint32_t index) const {
        TUMBLE_CHECK(index < generations_.size());
        return {index, generations_[index]};
    }

    std::span<const IdType> live() const { return live_; }  // sorted

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.generations_, self.free_, self.live_);
    }

private:
    std::vector<std::uint32_t> generations_;  // by index, of the present or next owner
    std::vector<std::uint32_t> free_;
    std::vector<IdType> live_;
};

}  // namespace tumble
