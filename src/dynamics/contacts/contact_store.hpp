// The contacts of awake bodies, contiguous and sorted by shape indices: every loop over them runs in an order that
// depends on ids alone.
#pragma once

#include <vector>

#include "dynamics/contacts/contact.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;
struct Tuning;

class ContactStore {
public:
    // Drops the contacts for which keep(contact) does not hold and adds one for each new pair (sorted, none present
    // yet).
    template <class Keep>
    void update(const std::vector<ProxyPair>& new_pairs, const ShapeStore& shapes, const Tuning& tuning, Keep&& keep);

    // Takes out the contacts for which keep(contact), called in order, does not hold.
    template <class Keep>
    void keep_if(Keep&& keep);

    // Contacts come back from an island that woke: at once for whoever asks, in their place by merge_woken().
    void add_woken(const std::vector<Contact>& contacts) {
        for (const Contact& contact : contacts) {
            woken_.push_back(contact);
            woken_.back().is_new = true;
        }
    }
    const std::vector<Contact>& woken() const { return woken_; }
    void merge_woken();

    // The contact of a pair among all(), or nullptr.
    Contact* find(ProxyPair pair);
    const Contact* find(ProxyPair pair) const;

    std::vector<Contact>& woken() { return woken_; }
    std::vector<Contact>& all() { return contacts_; }
    const std::vector<Contact>& all() const { return contacts_; }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.contacts_, self.woken_);
    }

private:
    // Puts `count` contacts in their places, from the back and without a second buffer: pair_of(i) ascends, make(i) is
    // the contact of that pair.
    template <class PairOf, class Make>
    void insert(std::size_t count, PairOf&& pair_of, Make&& make);

    std::vector<Contact> contacts_;
    std::vector<Contact> woken_;
};

// Radii, friction and what else the pair has of its two surfaces.
void mix_surfaces(Contact& contact, const ShapeStore& shapes);

Contact make_contact(ProxyPair pair, const ShapeStore& shapes, const Tuning& tuning);

// Whether a sensor overlaps now. Its contact has no manifold: nothing that is solved may see one.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

// The two do not touch in this step: takes manifold and impulses away.
void drop(Contact& contact);

// The manifold of this step of `duration` (s); impulses stay with the points whose features go on. False if it was
// recycled.
bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, float duration);

template <class Keep>
void ContactStore::update(const std::vector<ProxyPair>& new_pairs, const ShapeStore& shapes, const Tuning& tuning,
                          Keep&& keep) {
    keep_if(keep);
    insert(
        new_pairs.size(), [&](std::size_t i) { return new_pairs[i]; },
        [&](std::size_t i) { return make_contact(new_pairs[i], shapes, tuning); });
}

template <class PairOf, class Make>
void ContactStore::insert(std::size_t count, PairOf&& pair_of, Make&& make) {
    std::size_t from = contacts_.size(), to = from + count;
    if (to > contacts_.capacity()) contacts_.reserve(to + to / 8);  // a contact is large, and their number settles
    contacts_.resize(to);
    while (count > 0) {
        const bool is_last = from == 0 || contacts_[from - 1].shapes < pair_of(count - 1);
        contacts_[--to] = is_last ? make(--count) : contacts_[--from];
    }
}

template <class Keep>
void ContactStore::keep_if(Keep&& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (!keep(contacts_[i])) continue;
        if (kept < i) contacts_[kept] = contacts_[i];
        ++kept;
    }
    contacts_.resize(kept);
}

}  // namespace tumble
