#include "python/bindings/workers.hpp"

#include <algorithm>

namespace tumble::python {

Workers::Workers(int threads) {
    errors_.resize(static_cast<std::size_t>(threads));
    try {
        for (std::size_t i = 1; i < errors_.size(); ++i) threads_.emplace_back([this, i] { wait_for_work(i); });
    } catch (...) {
        end();
        throw;
    }
}

Workers::~Workers() { end(); }

void Workers::end() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void Workers::run_parts(std::size_t thread) {
    try {
        while (true) {
            const std::size_t begin = next_.fetch_add(size_);
            if (begin >= count_) return;
            (*work_)({begin, std::min(begin + size_, count_), thread});
        }
    } catch (...) {
        errors_[thread] = std::current_exception();
    }
}

void Workers::run(std::size_t count, std::size_t size, const std::function<void(const Part&)>& work) {
    {
        const std::lock_guard lock(mutex_);
        work_ = &work;
        count_ = count;
        size_ = size;
        next_ = 0;
        busy_ = threads_.size();
        ++round_;
        errors_.assign(errors_.size(), nullptr);
    }
    wake_.notify_all();
    run_parts(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    for (const std::exception_ptr& error : errors_)
        if (error) std::rethrow_exception(error);
}

void Workers::wait_for_work(std::size_t thread) {
    std::size_t seen = 0;
    while (true) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] { return ends_ || round_ != seen; });
        if (ends_) return;
        seen = round_;
        lock.unlock();
        run_parts(thread);
        lock.lock();
        if (--busy_ == 0) done_.notify_one();
    }
}

}  // namespace tumble::python
