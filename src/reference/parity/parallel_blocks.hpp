// Runs independent blocks of work on several threads and takes their results in the order of the blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tumble::reference {

// work(i) runs for every i < count on `threads` threads (0: one per core). take(i, result) is called in ascending i, by
// one thread at a time. The first exception ends the run and is rethrown to the caller.
template <class Result, class Work, class Take>
void run_blocks(std::size_t count, int threads, Work work, Take take) {
    std::mutex mutex;
    std::map<std::size_t, Result> waiting;  // results of blocks after one that is not finished
    std::size_t next_block = 0, next_taken = 0;
    std::exception_ptr failure;
    const auto run = [&] {
        for (;;) {
            std::size_t block = 0;
            {
                const std::scoped_lock lock(mutex);
                if (next_block == count || failure) return;
                block = next_block++;
            }
            try {
                Result result = work(block);
                const std::scoped_lock lock(mutex);
                waiting.emplace(block, std::move(result));
                for (auto first = waiting.begin(); first != waiting.end() && first->first == next_taken;
                     first = waiting.erase(first), ++next_taken)
                    take(first->first, first->second);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                if (!failure) failure = std::current_exception();
            }
        }
    };
    const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < std::min(std::max<std::size_t>(wanted, 1), count); ++i) workers.emplace_back(run);
    run();
    workers.clear();  // joins
    if (failure) std::rethrow_exception(failure);
}

}  // namespace tumble::reference
