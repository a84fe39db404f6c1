#include "dynamics/contacts/contact_store.hpp"

#include <algorithm>

namespace tumble {

namespace {

template <class Contacts>
auto* find_in(Contacts& contacts, ProxyPair pair) {
    const auto found = std::lower_bound(contacts.begin(), contacts.end(), pair,
                                        [](const Contact& contact, ProxyPair key) { return contact.shapes < key; });
    return found != contacts.end() && found->shapes == pair ? &*found : nullptr;
}

}  // namespace

Contact* ContactStore::find(ProxyPair pair) { return find_in(contacts_, pair); }
const Contact* ContactStore::find(ProxyPair pair) const { return find_in(contacts_, pair); }

void ContactStore::add_woken(std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) {
        TUMBLE_CHECK(contact.shapes.a < contact.shapes.b);
        woken_.push_back(contact);
        woken_.back().is_new = true;
    }
}

void ContactStore::merge_woken() {
    if (woken_.empty()) return;
    std::sort(woken_.begin(), woken_.end(), [](const Contact& a, const Contact& b) { return a.shapes < b.shapes; });
    insert(
        woken_.size(), [&](std::size_t i) { return woken_[i].shapes; }, [&](std::size_t i) { return woken_[i]; });
    woken_.clear();
}

}  // namespace tumble
