// The contacts of awake bodies, contiguous and sorted by shape indices, so that the order of every loop over them
// depends on ids alone.
//
// A sorted list of indices, of contacts that never move in memory, gained nothing: smash, where contacts begin by
// thousands, took 0.98 to 1.02 of the time, and large_pyramid and spinner took 1.01 to 1.03 of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/make_contact.hpp"
#include "tasks/chunk_lists.hpp"

namespace tumble {

class ContactStore {
public:
    // Adds a contact for each new pair. `new_pairs` is sorted and contains no pair of all().
    void add(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
             const Tuning& tuning);

    // The same, and removes the contacts of the indices `ended`, which ascend. The others are moved once.
    void replace(const ChunkLists<std::uint32_t>& ended, const std::vector<ProxyPair>& new_pairs, BodyStore& bodies,
                 const ShapeStore& shapes, const Tuning& tuning);

    // Removes contacts by their indices, which ascend.
    void remove(const ChunkLists<std::uint32_t>& ended);

    // Removes the contacts for which keep(contact), called in order, is false.
    template <class Keep>
    void keep_if(Keep&& keep) {
        keep_if(contacts_, 0, keep);
    }

    // The same for the contacts in woken() from the index `first` on.
    template <class Keep>
    void keep_woken_if(std::size_t first, Keep&& keep) {
        keep_if(woken_, first, keep);
    }

    // Adds the contacts of an island that woke. They are in woken(), in the order of waking, until merge_woken() sorts
    // them into all().
    void add_woken(std::span<const Contact> contacts);
    void merge_woken();

    // As add(), but the contacts are in woken() until merge_woken(). `new_pairs` contains no pair of woken() either.
    // Islands that touch each other wake in rounds. Sorting the contacts of each round into all() would take time in
    // proportion to all contacts in each round.
    void add_to_woken(const std::vector<ProxyPair>& new_pairs, BodyStore& bodies, const ShapeStore& shapes,
                      const Tuning& tuning);

    // Sorts the contacts in woken() from the index `first` on.
    void sort_woken(std::size_t first);

    // The contact of a pair among all(), or nullptr.
    Contact* find(ProxyPair pair);
    const Contact* find(ProxyPair pair) const;

    // The contact of a pair in woken(), or nullptr. `rounds` has the first index of each part of woken() that is
    // sorted.
    const Contact* find_in_woken(ProxyPair pair, std::span<const std::uint32_t> rounds) const;

    const std::vector<Contact>& woken() const { return woken_; }
    std::vector<Contact>& woken() { return woken_; }
    std::vector<Contact>& all() { return contacts_; }
    const std::vector<Contact>& all() const { return contacts_; }

    // Bytes of the buffers that are kept from step to step.
    std::size_t spare_bytes() const {
        return kept_.capacity() * sizeof(KeptRun) + places_.capacity() * sizeof(std::size_t);
    }

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.contacts_, self.woken_);
    }

private:
    template <class Keep>
    static void keep_if(std::vector<Contact>& contacts, std::size_t first, Keep&& keep);

    // Removes the contacts `ended` from all(), and inserts `count` others. pair_of(i) ascends, and make(i) is the
    // contact of that pair: called once for each i, in descending order, on which the draws of colours depend.
    template <class PairOf, class Make>
    void rearrange(const ChunkLists<std::uint32_t>& ended, std::size_t count, PairOf&& pair_of, Make&& make);
    // Plans kept_ and places_; returns the new number of contacts.
    template <class PairOf>
    std::size_t find_places(const ChunkLists<std::uint32_t>& ended, std::size_t count, PairOf& pair_of);
    void move_kept();

    // Contacts that stay next to each other: their indices before and after.
    struct KeptRun {
        std::size_t begin, end, to;
    };

    std::vector<Contact> contacts_;    // sorted
    std::vector<Contact> woken_;       // in order of waking, or of beginning in add_to_woken()
    std::vector<KeptRun> kept_;        // of the last rearrange()
    std::vector<std::size_t> places_;  // of the contacts that it inserted
};

template <class Keep>
void ContactStore::keep_if(std::vector<Contact>& contacts, std::size_t first, Keep&& keep) {
    TUMBLE_CHECK(first <= contacts.size());
    std::size_t kept = first;
    for (std::size_t i = first; i < contacts.size(); ++i) {
        TUMBLE_CHECK(kept <= i);
        if (!keep(contacts[i])) continue;
        if (kept < i) contacts[kept] = contacts[i];
        ++kept;
    }
    contacts.resize(kept);
}

}  // namespace tumble
