// Threads that share the work of one call: equal parts of a range, in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tumble::python {

class Workers {
public:
    // The calling thread is one of them.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // Calls part(begin, end) for parts of [0, count) on all threads, and returns when all are done. Throws the
    // exception of the first part that has one.
    void run(std::size_t count, const std::function<void(std::size_t, std::size_t)>& part);

private:
    void work(std::size_t thread);
    void run_part(std::size_t thread);

    std::vector<std::thread> threads_;
    std::vector<std::exception_ptr> errors_;  // [threads], the caller's first
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const std::function<void(std::size_t, std::size_t)>* part_ = nullptr;
    std::size_t count_ = 0;
    std::size_t round_ = 0;
    std::size_t busy_ = 0;
    bool ends_ = false;
};

}  // namespace tumble::python
