// A crew does all of the work once, whatever the task system does.
#include "tasks/crew.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/thread_tasks.hpp"
#include "tasks/chunk_lists.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Counts how often each item of several stages is worked on.
std::vector<int> count_work(Crew& crew, std::size_t items, int stages) {
    std::vector<std::atomic<int>> counts(items);
    crew.work_together(items, [&] {
        for (int stage = 0; stage < stages; ++stage) crew.for_each(items, 1, [&](std::size_t i) { ++counts[i]; });
    });
    return {counts.begin(), counts.end()};
}

}  // namespace

TEST_CASE("every stage works on every item once") {
    for (const int threads : {1, 2, 3, 8})
        for (const TaskSystem& tasks : {TaskSystem(run_on_threads), TaskSystem(run_backwards), TaskSystem()})
            for (const std::size_t items : {0u, 1u, 2u, 3u, 7u, 64u, 1000u}) {
                Crew crew({threads, tasks, 0});
                CHECK(count_work(crew, items, 50) == std::vector<int>(items, 50));
            }
}

TEST_CASE("each stage sees the results of the stage before") {
    constexpr std::size_t kItems = 97;
    Crew crew(eager_threads(3));
    std::vector<long> sums(kItems, 1), next(kItems);
    crew.work_together(kItems, [&] {
        for (int stage = 0; stage < 40; ++stage) {
            crew.for_each(kItems, 1, [&](std::size_t i) { next[i] = (sums[i] + sums[(i + 1) % kItems]) % 1009; });
            sums.swap(next);
        }
    });
    // The items are alike, so that each is 2^40 modulo 1009.
    long power = 1;
    for (int stage = 0; stage < 40; ++stage) power = 2 * power % 1009;
    CHECK(sums == std::vector<long>(kItems, power));
}

TEST_CASE("threads take part in a stage that lasts") {
    std::set<std::thread::id> seen;
    std::mutex mutex;
    Crew crew(eager_threads(2));
    crew.work_together(1, [&] {
        // The leader waits in its first chunk until the other thread has worked on one of the others.
        crew.for_each(8, 1, [&](std::size_t) {
            const auto size = [&] {
                const std::scoped_lock lock(mutex);
                seen.insert(std::this_thread::get_id());
                return seen.size();
            };
            while (size() < 2) std::this_thread::yield();
        });
    });
    CHECK(seen.size() == 2);
}

TEST_CASE("too little work stays on the calling thread, without a call of the task system") {
    int calls = 0;
    const auto count_calls = [&](int count, const std::function<void(int)>& task) {
        ++calls;
        run_on_threads(count, task);
    };
    Crew crew({4, count_calls, 100});
    std::thread::id seen;
    crew.work_together(99, [&] { crew.for_each(99, 1, [&](std::size_t) { seen = std::this_thread::get_id(); }); });
    CHECK(calls == 0);
    CHECK(seen == std::this_thread::get_id());
    crew.work_together(100, [&] { CHECK(crew.chunk_count(100, 10) == 12); });
    CHECK(calls == 1);
    CHECK(crew.chunk_count(100, 10) == 1);  // outside of work_together()
}

TEST_CASE("all threads get equally many chunks, none of which is too small") {
    for (const std::size_t threads : {2u, 3u, 8u}) {
        Crew crew({static_cast<int>(threads), run_backwards, 1});
        crew.work_together(1, [&] {
            for (std::size_t count = 0; count < 3000; ++count) {
                const std::size_t least = 1 + count % 17, chunks = crew.chunk_count(count, least);
                const bool is_even = chunks % threads == 0 || chunks < threads || chunks == count;
                const bool is_large = chunks == 1 || 2 * count >= chunks * least;
                const bool is_divided = chunks > 1 || count < 2 * least;
                if (!is_even || !is_large || !is_divided || chunks > 8 * threads) FAIL(count << ": " << chunks);
            }
            CHECK(crew.chunk_count(3000, 1) == 8 * threads);
        });
    }
}

TEST_CASE("an exception in a chunk or between stages reaches the caller, and the crew goes on") {
    for (const TaskSystem& tasks : {TaskSystem(run_on_threads), TaskSystem(run_backwards)}) {
        Crew crew({3, tasks, 0});
        const auto fail_in_chunk = [&] {
            crew.for_each(30, 1, [](std::size_t i) {
                if (i == 17) throw std::runtime_error("chunk");
            });
        };
        CHECK_THROWS_WITH_AS(crew.work_together(1, fail_in_chunk), "chunk", std::runtime_error);
        CHECK_THROWS_WITH_AS(crew.work_together(1, [] { throw std::logic_error("leader"); }), "leader",
                             std::logic_error);
        CHECK(count_work(crew, 20, 3) == std::vector<int>(20, 3));
    }
}

TEST_CASE("lists of chunks are in the order of the items") {
    for (const int threads : {1, 2, 5}) {
        Crew crew(eager_threads(threads));
        ChunkLists<std::size_t> lists;
        std::vector<std::size_t> found, expected;
        for (const std::size_t count : {1000u, 10u}) {
            crew.work_together(count, [&] {
                lists.fill(crew, count, 1, [](std::size_t i, std::vector<std::size_t>& list) {
                    if (i % 3 == 1) list.push_back(i);
                });
            });
            CHECK_FALSE(lists.empty());
            found.clear();
            expected.clear();
            lists.for_each([&](std::size_t i) { found.push_back(i); });
            for (std::size_t i = 1; i < count; i += 3) expected.push_back(i);
            CHECK(found == expected);
        }
        lists.fill(crew, 10, 1, [](std::size_t, std::vector<std::size_t>&) {});
        CHECK(lists.empty());
    }
}
