// Sleeping islands: their bodies and touching contacts.
//
// A contact is here if it touches and none of its bodies is awake. Pairs of sleeping bodies that do not touch are not
// stored, and found again when one of the bodies wakes.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/contacts/contact.hpp"

namespace tumble {

struct SleepingIsland {
    std::vector<std::uint32_t> bodies;  // by index
    std::vector<Contact> contacts;
};

class SleepingIslands {
public:
    // Adds an empty island and returns its number.
    std::uint32_t add() {
        ++count_;
        if (free_.empty()) {
            islands_.emplace_back();
            return static_cast<std::uint32_t>(islands_.size() - 1);
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        TUMBLE_CHECK(islands_[index].bodies.empty());
        TUMBLE_CHECK(islands_[index].contacts.empty());
        return index;
    }

    // Removes an island and returns it. Its number may be used again.
    SleepingIsland take(std::uint32_t index) {
        TUMBLE_CHECK(index < islands_.size());
        TUMBLE_CHECK(!islands_[index].bodies.empty());
        --count_;
        free_.push_back(index);
        SleepingIsland island = std::move(islands_[index]);
        islands_[index] = SleepingIsland{};
        TUMBLE_CHECK(island.contacts.size() <= contact_count_);
        contact_count_ -= island.contacts.size();
        for (const Contact& contact : island.contacts) point_count_ -= points(contact);
        return island;
    }

    void add_contact(std::uint32_t index, const Contact& contact) {
        TUMBLE_CHECK(index < islands_.size());
        TUMBLE_CHECK(contact.manifold.point_count > 0);
        islands_[index].contacts.push_back(contact);
        ++contact_count_;
        point_count_ += points(contact);
    }

    // Calls visit(contact) for each contact. It must not change the number of manifold points.
    template <class Visitor>
    void for_each_contact(Visitor&& visit) {
        for (SleepingIsland& island : islands_)
            for (Contact& contact : island.contacts) visit(contact);
    }

    SleepingIsland& operator[](std::uint32_t index) {
        TUMBLE_CHECK(index < islands_.size());
        return islands_[index];
    }
    const std::vector<SleepingIsland>& all() const { return islands_; }  // removed ones are empty
    std::size_t count() const { return count_; }
    std::size_t contact_count() const { return contact_count_; }
    std::size_t point_count() const { return point_count_; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.islands_, self.free_, self.count_, self.contact_count_, self.point_count_);
    }

private:
    static std::size_t points(const Contact& contact) { return static_cast<std::size_t>(contact.manifold.point_count); }

    std::vector<SleepingIsland> islands_;
    std::vector<std::uint32_t> free_;
    std::size_t count_ = 0;
    std::size_t contact_count_ = 0;
    std::size_t point_count_ = 0;
};

}  // namespace tumble
