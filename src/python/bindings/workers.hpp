// Threads that share the work of one call: each takes the next part of a range when it has finished one.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tumble::python {

// Items from `begin` up to `end`, and the number of the thread that works on them; the calling thread has number 0.
struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t thread = 0;
};

class Workers {
public:
    // The calling thread is one of them. Throws std::system_error if a thread cannot start.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t count() const { return errors_.size(); }

    // Calls work(part) for parts of [0, count) of at most `size` on all threads, and returns when all are done. Throws
    // the exception of one of them, if they have any.
    void run(std::size_t count, std::size_t size, const std::function<void(const Part&)>& work);

private:
    void end();  // of all threads
    void wait_for_work(std::size_t thread);
    void run_parts(std::size_t thread);

    std::vector<std::thread> threads_;
    std::vector<std::exception_ptr> errors_;  // [threads], the caller's first
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const std::function<void(const Part&)>* work_ = nullptr;
    std::size_t count_ = 0, size_ = 1;
    std::atomic<std::size_t> next_ = 0;
    std::size_t round_ = 0;
    std::size_t busy_ = 0;
    bool ends_ = false;
};

}  // namespace tumble::python
