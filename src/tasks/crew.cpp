#include "tasks/crew.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "debug/check.hpp"
#include "tasks/default_tasks.hpp"

namespace tumble {

namespace {

// A range of chunks that a thread takes one by one, in one atomic number: the stage (32 bits), the end of the range and
// the next chunk (16 bits each). A thread that takes a chunk in vain makes `next` exceed `end` by one, so that `next`
// exceeds `end` by no more than the number of threads.
struct Range {
    std::uint32_t stage = 0;
    std::uint32_t end = 0;
    std::uint32_t next = 0;

    static Range unpack(std::uint64_t bits) {
        return {static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits >> 16) & 0xffffu,
                static_cast<std::uint32_t>(bits) & 0xffffu};
    }
    std::uint64_t pack() const { return std::uint64_t{stage} << 32 | end << 16 | next; }
    bool has_next() const { return next < end; }
};

constexpr int kMostThreads = 256;
constexpr std::size_t kChunksOfThread = 8;  // in a stage: enough for a thread that is late to leave some to the others
static_assert(kMostThreads * (kChunksOfThread + 1) <= 0xffff);

// About 40 ns: short compared with a stage.
void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// Waits a little; after some 20 us each time it lets another thread run, which may be the one that is waited for.
class Patience {
public:
    void wait() {
        if (++waits_ < kSpins)
            pause();
        else
            std::this_thread::yield();
    }

private:
    static constexpr int kSpins = 500;
    int waits_ = 0;
};

}  // namespace

class Crew::Team {
public:
    explicit Team(const Threads& threads, int count)
        : tasks_(threads.tasks ? threads.tasks : make_default_tasks(count)),
          is_for_tests_(threads.least_work == 0),
          lines_(static_cast<std::size_t>(count)) {}

    std::size_t thread_count() const { return lines_.size(); }
    bool is_together() const { return is_together_; }

    std::size_t divide(std::size_t count, std::size_t least) const {
        if (!is_together_) return 1;
        const std::size_t most = is_for_tests_ ? count : count / least, threads = lines_.size();
        if (most < threads) return std::max(most, std::size_t{1});
        // Equally many for each thread: of three chunks, one of two threads would have two.
        const std::size_t even = (most + threads - 1) / threads * threads;
        return std::min({even, count, kChunksOfThread * threads});
    }

    void run(const std::function<void()>& work) {
        arrived_.store(0, std::memory_order_relaxed);
        is_over_.store(false, std::memory_order_relaxed);
        std::exception_ptr error;
        const auto take_part = [&](int) {
            const std::size_t self = arrived_.fetch_add(1, std::memory_order_acq_rel);
            if (self == 0)
                lead(work, error);
            else if (self < lines_.size())
                help(self);
        };
        tasks_(static_cast<int>(lines_.size()), std::ref(take_part));  // by reference: a copy would allocate
        if (error) std::rethrow_exception(error);
    }

    // The leader's part of a stage.
    void publish(const Stage& stage) {
        const std::size_t threads = lines_.size();
        stage_ = stage;
        left_.store(stage.chunks, std::memory_order_relaxed);
        ++stage_number_;
        for (std::size_t i = threads; i-- > 0;) {
            const Range range{stage_number_, static_cast<std::uint32_t>(stage.chunks * (i + 1) / threads),
                              static_cast<std::uint32_t>(stage.chunks * i / threads)};
            lines_[i].range.store(range.pack(), std::memory_order_release);
        }
        work_off(0);
        Patience patience;
        while (left_.load(std::memory_order_acquire) > 0) patience.wait();
        if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    }

private:
    struct alignas(64) Line {
        std::atomic<std::uint64_t> range{0};
    };

    void lead(const std::function<void()>& work, std::exception_ptr& error) {
        is_together_ = true;
        try {
            work();
        } catch (...) {
            error = std::current_exception();
        }
        is_together_ = false;
        is_over_.store(true, std::memory_order_release);
    }

    void help(std::size_t self) {
        std::uint32_t seen = 0;
        Patience patience;
        while (!is_over_.load(std::memory_order_acquire)) {
            const Range range = Range::unpack(lines_[self].range.load(std::memory_order_acquire));
            if (range.stage == seen) {
                patience.wait();
                continue;
            }
            seen = range.stage;
            work_off(self);
            patience = {};
        }
    }

    // Works on chunks of the own range, then on those of the others.
    void work_off(std::size_t self) {
        std::size_t done = 0;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            std::atomic<std::uint64_t>& line = lines_[(self + i) % lines_.size()].range;
            for (std::size_t chunk = 0; take(line, chunk); ++done) work_on(chunk);
        }
        if (done > 0) left_.fetch_sub(done, std::memory_order_release);
    }

    // A chunk that is taken belongs to the stage of now, even if a new stage began since `line` was read: a stage ends
    // only when all of its chunks are done.
    static bool take(std::atomic<std::uint64_t>& line, std::size_t& chunk) {
        if (!Range::unpack(line.load(std::memory_order_relaxed)).has_next()) return false;
        const Range taken = Range::unpack(line.fetch_add(1, std::memory_order_acq_rel));
        chunk = taken.next;
        return taken.has_next();
    }

    void work_on(std::size_t chunk) {
        try {
            stage_.call(stage_.context, chunk, stage_.chunks, stage_.items);
        } catch (...) {
            const std::scoped_lock lock(error_mutex_);
            if (!error_) error_ = std::current_exception();
        }
    }

    TaskSystem tasks_;
    bool is_for_tests_;                 // chunks may be of one item
    std::vector<Line> lines_;           // by thread
    Stage stage_{};                     // written by the leader, while no chunk is left
    std::uint32_t stage_number_ = 0;    // counts the stages; a thread that starts to help has seen none: 0
    std::atomic<std::size_t> left_{0};  // chunks of the stage that are not done
    std::atomic<std::size_t> arrived_{0};
    std::atomic<bool> is_over_{false};
    bool is_together_ = false;  // of the leader
    std::mutex error_mutex_;
    std::exception_ptr error_;
};

Crew::Crew() = default;
Crew::~Crew() = default;
Crew::Crew(Crew&&) noexcept = default;
Crew& Crew::operator=(Crew&&) noexcept = default;

Crew::Crew(const Threads& threads) : least_work_(static_cast<std::size_t>(threads.least_work)) {
    TUMBLE_CHECK(threads.count >= 0);
    // oneTBB would warn of threads that it does not have.
    const int most = threads.tasks ? kMostThreads : std::min(default_thread_count(), kMostThreads);
    const int all = threads.tasks ? static_cast<int>(std::thread::hardware_concurrency()) : most;
    const int wanted = threads.count > 0 ? threads.count : all;
    const int count = std::min(wanted, most);
    if (count > 1) team_ = std::make_unique<Team>(threads, count);
}

std::size_t Crew::thread_count() const { return team_ ? team_->thread_count() : 1; }
bool Crew::is_together() const { return team_->is_together(); }
std::size_t Crew::divide(std::size_t count, std::size_t least) const { return team_->divide(count, least); }
void Crew::run(const std::function<void()>& work) { team_->run(work); }
void Crew::publish(const Stage& stage) { team_->publish(stage); }

}  // namespace tumble
