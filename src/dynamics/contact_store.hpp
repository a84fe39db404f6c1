// The contacts of awake bodies, contiguous and sorted by shape indices: every loop over them runs in an order that
// depends on ids alone.
#pragma once

#include <vector>

#include "dynamics/contact.hpp"

namespace tumble {

class BodyStore;
class ShapeStore;

class ContactStore {
public:
    // Drops the contacts for which keep(contact) does not hold and adds one for each new pair (sorted, none present
    // yet). One pass, into a second buffer that becomes the first.
    template <class Keep>
    void update(const std::vector<ProxyPair>& new_pairs, const ShapeStore& shapes, Keep&& keep);

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

    std::vector<Contact>& all() { return contacts_; }
    const std::vector<Contact>& all() const { return contacts_; }

private:
    std::vector<Contact> contacts_;
    std::vector<Contact> woken_;
    std::vector<Contact> merged_;
};

Contact make_contact(ProxyPair pair, const ShapeStore& shapes);

// Whether a sensor overlaps now. Its contact has no manifold: nothing that is solved may see one.
void sense_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

// The manifold of this step; impulses stay with the points whose features go on.
void collide_contact(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

template <class Keep>
void ContactStore::update(const std::vector<ProxyPair>& new_pairs, const ShapeStore& shapes, Keep&& keep) {
    merged_.clear();
    auto next_new = new_pairs.begin();
    for (const Contact& contact : contacts_) {
        for (; next_new != new_pairs.end() && *next_new < contact.shapes; ++next_new)
            merged_.push_back(make_contact(*next_new, shapes));
        if (keep(contact)) merged_.push_back(contact);
    }
    for (; next_new != new_pairs.end(); ++next_new) merged_.push_back(make_contact(*next_new, shapes));
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
