// Lists that the chunks of a stage fill at the same time. One after the other they are in the order of the items,
// however many threads and chunks there were.
#pragma once

#include <cstddef>
#include <vector>

#include "tasks/crew.hpp"

namespace tumble {

template <class T>
class ChunkLists {
public:
    // Clears the lists, then calls work(index, list) for each item; it may add to the list. See Crew::for_each_chunk().
    template <class Work>
    void fill(Crew& crew, std::size_t count, std::size_t least, Work&& work) {
        fill_by_chunk(crew, count, least, [&work](const Chunk& chunk, std::vector<T>& list) {
            for (std::size_t i = chunk.begin; i < chunk.end; ++i) work(i, list);
        });
    }

    // The same with one call for each chunk: work(chunk, list).
    template <class Work>
    void fill_by_chunk(Crew& crew, std::size_t count, std::size_t least, Work&& work) {
        used_ = crew.chunk_count(count, least);
        if (lists_.size() < used_) lists_.resize(used_);
        crew.for_each_chunk(count, least, [&](const Chunk& chunk) {
            std::vector<T>& list = lists_[chunk.index].values;
            list.clear();
            work(chunk, list);
        });
    }

    // Calls visit(value) for each value, in order.
    template <class Visitor>
    void for_each(Visitor&& visit) const {
        for (std::size_t i = 0; i < used_; ++i)
            for (const T& value : lists_[i].values) visit(value);
    }

    // Calls visit(list) for each list, at the same time; it may change the list.
    template <class Visitor>
    void for_each_list(Crew& crew, Visitor&& visit) {
        crew.for_each(used_, 1, [&](std::size_t i) { visit(lists_[i].values); });
    }

    // Removes the values for which predicate(value), called in order, is true.
    template <class Predicate>
    void erase_if(Predicate&& predicate) {
        for (std::size_t i = 0; i < used_; ++i) std::erase_if(lists_[i].values, predicate);
    }

    bool empty() const {
        for (std::size_t i = 0; i < used_; ++i)
            if (!lists_[i].values.empty()) return false;
        return true;
    }

    std::size_t bytes() const {
        std::size_t bytes = lists_.capacity() * sizeof(List);
        for (const List& list : lists_) bytes += list.values.capacity() * sizeof(T);
        return bytes;
    }

private:
    struct alignas(64) List {  // a cache line each: threads add to neighbours at the same time
        std::vector<T> values;
    };

    std::vector<List> lists_;
    std::size_t used_ = 0;
};

}  // namespace tumble
