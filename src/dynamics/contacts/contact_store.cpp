#include "dynamics/contacts/contact_store.hpp"

#include <algorithm>

namespace tumble {

namespace {

template <class Contacts>
auto* find_in(Contacts& contacts, ProxyPair pair) {
    TUMBLE_CHECK(pair.a < pair.b);
    const auto found = std::lower_bound(contacts.begin(), contacts.end(), pair,
                                        [](const Contact& contact, ProxyPair key) { return contact.shapes < key; });
    return found != contacts.end() && found->shapes == pair ? &*found : nullptr;
}

}  // namespace

Contact* ContactStore::find(ProxyPair pair) { return find_in(contacts_, pair); }
const Contact* ContactStore::find(ProxyPair pair) const { return find_in(contacts_, pair); }

void ContactStore::add(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
                       const Tuning& tuning) {
    insert(
        new_pairs.size(), [&](std::size_t i) { return new_pairs[i]; },
        [&](std::size_t i) {
            Contact contact = make_contact(new_pairs[i], shapes, tuning);
            draw_colors(contact, bodies);
            return contact;
        });
}

// Moves the contacts between two removed ones together.
void ContactStore::remove(const ChunkLists<std::uint32_t>& indices) {
    if (indices.empty()) return;
    std::size_t kept = 0, next = 0;
    const auto keep_up_to = [&](std::size_t end) {
        TUMBLE_CHECK(next <= end);
        if (kept == next)
            kept = end;
        else
            for (; next < end; ++next) contacts_[kept++] = contacts_[next];
        next = end + 1;
    };
    indices.for_each(keep_up_to);
    keep_up_to(contacts_.size());
    contacts_.resize(kept);
}

void ContactStore::add_woken(std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        TUMBLE_CHECK(contact.shapes.a < contact.shapes.b);
        woken_.push_back(contact);
        woken_.back().is_new = true;
        woken_.back().applied[0] = woken_.back().applied[1] = {};
    }
}

void ContactStore::merge_woken() {
    if (woken_.empty()) return;
    std::vector<const Contact*> sorted;
    sorted.reserve(woken_.size());
    for (const Contact& contact : woken_) sorted.push_back(&contact);
    std::sort(sorted.begin(), sorted.end(), [](const Contact* a, const Contact* b) { return a->shapes < b->shapes; });
    insert(
        sorted.size(), [&](std::size_t i) { return sorted[i]->shapes; },
        [&](std::size_t i) -> const Contact& { return *sorted[i]; });
    woken_.clear();
}

}  // namespace tumble
