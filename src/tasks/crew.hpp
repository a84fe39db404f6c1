// A crew of threads that shares the work of a step.
//
// The stages of a step are short: a colour of contacts is a few microseconds of work, less than it takes to start
// tasks. So work_together() starts one task for each thread and keeps them: the first to arrive leads and runs the
// stages in their order, the others help. for_each_chunk() publishes a stage by one store for each thread, as Box2D
// does [Catto 2024, "SIMD Matters"]. Each thread has a range of chunks of its own, the same range in every stage of the
// same length, so that its cache keeps what it works on; a thread that has finished takes chunks of the others. The
// leader waits for claimed chunks only: threads that come late or never cost nothing but their help.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "tumble/threads.hpp"

namespace tumble {

// Items from `begin` up to `end`, and the number of their chunk in the stage.
struct Chunk {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t index = 0;
};

class Crew {
public:
    Crew();  // the calling thread alone
    explicit Crew(const Threads& threads);
    ~Crew();
    Crew(Crew&&) noexcept;
    Crew& operator=(Crew&&) noexcept;

    // Runs work() on one of the threads, while the others help in its for_each_chunk(). Runs it on the calling thread
    // alone if `amount`, in the measure of Threads::least_work, is too little. An exception of work() is thrown here.
    template <class Work>
    void work_together(std::size_t amount, Work&& work) {
        if (!is_enough(amount) || is_together())
            work();
        else
            run(std::ref(work));
    }

    std::size_t thread_count() const;

    // The number of chunks into which for_each_chunk() divides `count` items: one if it runs on this thread alone.
    // On average, one of several chunks has more than half of `least` items, and each has at least one. If there are
    // enough items, the number of chunks is a multiple of the number of threads, or less than that.
    std::size_t chunk_count(std::size_t count, std::size_t least) const {
        return team_ && count > 0 ? divide(count, least) : 1;
    }

    // Calls work(Chunk) for chunks that cover `count` items, at the same time, and returns when all calls have
    // returned. Calls it once with all items outside of work_together(). If calls throw, the first of these exceptions
    // is thrown.
    template <class Work>
    void for_each_chunk(std::size_t count, std::size_t least, Work&& work) {
        const std::size_t chunks = chunk_count(count, least);
        if (chunks == 1) return work(Chunk{0, count, 0});
        const auto call = [](void* context, std::size_t index, std::size_t of, std::size_t items) {
            (*static_cast<std::remove_reference_t<Work>*>(context))(
                Chunk{items * index / of, items * (index + 1) / of, index});
        };
        publish({call, const_cast<void*>(static_cast<const void*>(&work)), chunks, count});
    }

    // The same, item by item: work(index).
    template <class Work>
    void for_each(std::size_t count, std::size_t least, Work&& work) {
        for_each_chunk(count, least, [&work](const Chunk& chunk) {
            for (std::size_t i = chunk.begin; i < chunk.end; ++i) work(i);
        });
    }

private:
    struct Stage {
        void (*call)(void* context, std::size_t index, std::size_t of, std::size_t items);
        void* context;
        std::size_t chunks;
        std::size_t items;
    };
    class Team;

    bool is_enough(std::size_t amount) const { return team_ && amount >= least_work_; }
    bool is_together() const;
    std::size_t divide(std::size_t count, std::size_t least) const;
    void run(const std::function<void()>& work);
    void publish(const Stage& stage);

    std::unique_ptr<Team> team_;  // null: one thread
    std::size_t least_work_ = 0;
};

}  // namespace tumble
