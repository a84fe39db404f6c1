// The contacts of awake bodies, contiguous and sorted by shape indices: every loop over them runs in an order that
// depends on ids alone.
#pragma once

#include <vector>

#include "dynamics/contact.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;
struct Tuning;

class ContactStore {
public:
    // Drops the contacts for which keep(contact) does not hold and adds one for each new pair (sorted, none present
    // yet). One pass, into a second buffer that becomes the first.
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

    std::vector<Contact>& woken() { return woken_; }
    std::vector<Contact>& all() { return contacts_; }
    const std::vector<Contact>& all() const { return contacts_; }

    // Of the second buffer.
    std::size_t spare_bytes() const { return merged_.capacity() * sizeof(Contact); }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.contacts_, self.woken_);
    }

private:
    std::vector<Contact> contacts_;
    std::vector<Contact> woken_;
    std::vector<Contact> merged_;
};

// Radii, friction and what else the pair has of its two surfaces.
void mix_surfaces(Contact& contact, const ShapeStore& shapes);

Contact make_contact(ProxyPair pair, const ShapeStore& shapes, const Tuning& tuning);

// Whether a sensor overlaps now. Its contact has no manifold: nothing that is solved may see one.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

// The manifold of this step; impulses stay with the points whose features go on. False if it was recycled.
bool collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

template <class Keep>
void ContactStore::update(const std::vector<ProxyPair>& new_pairs, const ShapeStore& shapes, const Tuning& tuning,
                          Keep&& keep) {
    merged_.clear();
    auto next_new = new_pairs.begin();
    for (const Contact& contact : contacts_) {
        for (; next_new != new_pairs.end() && *next_new < contact.shapes; ++next_new)
            merged_.push_back(make_contact(*next_new, shapes, tuning));
        if (keep(contact)) merged_.push_back(contact);
    }
    for (; next_new != new_pairs.end(); ++next_new)
        merged_.push_back(make_contact(*next_new, shapes, tuning));
    contacts_.swap(merged_);
}

template <class Keep>
void ContactStore::keep_if(Keep&& keep) {
    std::size_t kept = 0;
    for (const Contact& contact : contacts_)
        if (keep(contact)) contacts_[kept++] = contact;
    contacts_.resize(kept);
}

}  // namespace tumble
