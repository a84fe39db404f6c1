// Task systems for tests: real threads, however few processors there are, and none.
#pragma once

#include <thread>
#include <vector>

#include "tumble/threads.hpp"

namespace tumble::test {

// A thread for each task.
inline void run_on_threads(int count, const std::function<void(int)>& task) {
    std::vector<std::thread> threads;
    for (int i = 1; i < count; ++i) threads.emplace_back([&task, i] { task(i); });
    task(0);
    for (std::thread& thread : threads) thread.join();
}

// One task after the other, the last one first.
inline void run_backwards(int count, const std::function<void(int)>& task) {
    for (int i = count; i-- > 0;) task(i);
}

// Threads that share even the smallest step.
inline Threads eager_threads(int count) { return {count, run_on_threads, 0}; }

}  // namespace tumble::test
