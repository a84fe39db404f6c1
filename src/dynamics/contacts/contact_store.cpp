#include "dynamics/contacts/contact_store.hpp"

#include <algorithm>

namespace tumble {

namespace {

// The first contact, of sorted ones, that is not before the pair.
template <class Iterator>
Iterator lower_bound_of(Iterator begin, Iterator end, ProxyPair pair) {
    TUMBLE_CHECK(pair.a < pair.b);
    return std::lower_bound(begin, end, pair,
                            [](const Contact& contact, ProxyPair key) { return contact.shapes < key; });
}

template <class Contacts>
auto* find_in(Contacts&& contacts, ProxyPair pair) {
    const auto found = lower_bound_of(contacts.begin(), contacts.end(), pair);
    return found != contacts.end() && found->shapes == pair ? &*found : nullptr;
}

std::vector<const Contact*> in_order(const std::vector<Contact>& contacts) {
    std::vector<const Contact*> sorted;
    sorted.reserve(contacts.size());
    for (const Contact& contact : contacts) sorted.push_back(&contact);
    std::sort(sorted.begin(), sorted.end(), [](const Contact* a, const Contact* b) { return a->shapes < b->shapes; });
    return sorted;
}

}  // namespace

Contact* ContactStore::find(ProxyPair pair) { return find_in(contacts_, pair); }
const Contact* ContactStore::find(ProxyPair pair) const { return find_in(contacts_, pair); }

const Contact* ContactStore::find_in_woken(ProxyPair pair, std::span<const std::uint32_t> rounds) const {
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        const std::size_t end = i + 1 < rounds.size() ? rounds[i + 1] : woken_.size();
        TUMBLE_CHECK(rounds[i] <= end);
        if (const Contact* const found = find_in(std::span(woken_).subspan(rounds[i], end - rounds[i]), pair))
            return found;
    }
    return nullptr;
}

template <class PairOf, class Make>
void ContactStore::insert(std::size_t count, PairOf&& pair_of, Make&& make) {
    const std::size_t old_size = contacts_.size(), size = old_size + count;
    if (size > contacts_.capacity())
        // The first reservation has little spare room, as contacts are large, and in most worlds few are added later.
        contacts_.reserve(std::max(size + size / 8, contacts_.capacity() + contacts_.capacity() / 2));
    contacts_.resize(size);
    Contact* const begin = contacts_.data();
    Contact *from = begin + old_size, *to = begin + size;
    while (count > 0) {
        Contact* const position = lower_bound_of(begin, from, pair_of(--count));
        TUMBLE_CHECK((position == from || position->shapes != pair_of(count)));
        to = std::copy_backward(position, from, to);
        from = position;
        *--to = make(count);
    }
}

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

void ContactStore::add_to_woken(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
                                const Tuning& tuning) {
    for (std::size_t i = new_pairs.size(); i-- > 0;) {
        woken_.push_back(make_contact(new_pairs[i], shapes, tuning));
        draw_colors(woken_.back(), bodies);
    }
}

// Moves the contacts between two removed ones together.
void ContactStore::remove(const ChunkLists<std::uint32_t>& indices) {
    if (indices.empty()) return;
    std::size_t kept = 0, next = 0;
    const auto keep_up_to = [&](std::size_t end) {
        TUMBLE_CHECK(next <= end);
        if (kept < next) std::copy(contacts_.data() + next, contacts_.data() + end, contacts_.data() + kept);
        kept += end - next;
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

void ContactStore::sort_woken(std::size_t first) {
    TUMBLE_CHECK(first <= woken_.size());
    const std::vector<Contact> unsorted(woken_.begin() + static_cast<std::ptrdiff_t>(first), woken_.end());
    for (const Contact* const contact : in_order(unsorted)) woken_[first++] = *contact;
}

void ContactStore::merge_woken() {
    if (woken_.empty()) return;
    const std::vector<const Contact*> sorted = in_order(woken_);
    insert(
        sorted.size(), [&](std::size_t i) { return sorted[i]->shapes; },
        [&](std::size_t i) -> const Contact& { return *sorted[i]; });
    woken_.clear();
}

}  // namespace tumble
