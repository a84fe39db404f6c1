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

template <class PairOf>
std::size_t ContactStore::find_places(const ChunkLists<std::uint32_t>& ended, std::size_t count, PairOf& pair_of) {
    kept_.clear();
    places_.clear();
    const Contact* const all = contacts_.data();
    std::size_t from = 0, to = 0;
    const auto keep_up_to = [&](std::size_t end) {
        TUMBLE_CHECK(from <= end);
        if (from < end) kept_.push_back({from, end, to});
        to += end - from;
        from = end;
    };
    const auto insert_before = [&](std::size_t end) {
        while (places_.size() < count) {
            const ProxyPair pair = pair_of(places_.size());
            const auto place = static_cast<std::size_t>(lower_bound_of(all + from, all + end, pair) - all);
            if (place == end && end < contacts_.size() && all[end].shapes < pair) return;
            keep_up_to(place);
            places_.push_back(to++);
        }
    };
    ended.for_each([&](std::uint32_t index) {
        insert_before(index);
        keep_up_to(index);
        from = index + 1;
    });
    insert_before(contacts_.size());
    keep_up_to(contacts_.size());
    return to;
}

// Runs that move to smaller indices first, in order, then the others from the back: none is written over before it has
// moved, as the runs keep their order.
void ContactStore::move_kept() {
    Contact* const all = contacts_.data();
    for (const KeptRun& run : kept_)
        if (run.to < run.begin) std::copy(all + run.begin, all + run.end, all + run.to);
    for (std::size_t i = kept_.size(); i-- > 0;) {
        const KeptRun& run = kept_[i];
        if (run.to > run.begin)
            std::copy_backward(all + run.begin, all + run.end, all + run.to + (run.end - run.begin));
    }
}

template <class PairOf, class Make>
void ContactStore::rearrange(const ChunkLists<std::uint32_t>& ended, std::size_t count, PairOf&& pair_of, Make&& make) {
    if (count == 0 && ended.empty()) return;
    const std::size_t new_size = find_places(ended, count, pair_of);
    if (new_size > contacts_.capacity())
        // The first reservation has little spare room, as contacts are large, and in most worlds few are added later.
        contacts_.reserve(std::max(new_size + new_size / 8, contacts_.capacity() + contacts_.capacity() / 2));
    contacts_.resize(std::max(new_size, contacts_.size()));
    move_kept();
    contacts_.resize(new_size);
    for (std::size_t i = count; i-- > 0;) contacts_[places_[i]] = make(i);
}

void ContactStore::replace(const ChunkLists<std::uint32_t>& ended, const std::vector<ProxyPair>& new_pairs,
                           BodyStore& bodies, const ShapeStore& shapes, const Tuning& tuning) {
    rearrange(
        ended, new_pairs.size(), [&](std::size_t i) { return new_pairs[i]; },
        [&](std::size_t i) {
            Contact contact = make_contact(new_pairs[i], shapes, tuning);
            draw_colors(contact, bodies);
            return contact;
        });
}

void ContactStore::add(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
                       const Tuning& tuning) {
    replace({}, new_pairs, bodies, shapes, tuning);
}

void ContactStore::add_to_woken(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
                                const Tuning& tuning) {
    for (std::size_t i = new_pairs.size(); i-- > 0;) {
        woken_.push_back(make_contact(new_pairs[i], shapes, tuning));
        draw_colors(woken_.back(), bodies);
    }
}

void ContactStore::remove(const ChunkLists<std::uint32_t>& ended) {
    const auto none = [](std::size_t) { return ProxyPair{}; };
    rearrange(ended, 0, none, [](std::size_t) { return Contact{}; });
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
    rearrange(
        {}, sorted.size(), [&](std::size_t i) { return sorted[i]->shapes; },
        [&](std::size_t i) -> const Contact& { return *sorted[i]; });
    woken_.clear();
}

}  // namespace tumble
