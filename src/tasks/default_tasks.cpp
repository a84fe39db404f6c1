#include "tasks/default_tasks.hpp"

#ifdef TUMBLE_HAS_TBB

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

namespace tumble {

TaskSystem make_default_tasks(int threads) {
    const auto arena = std::make_shared<tbb::task_arena>(threads);
    return [arena](int count, const std::function<void(int)>& task) {
        arena->execute([&] { tbb::parallel_for(0, count, task, tbb::static_partitioner{}); });
    };
}

int default_thread_count() { return tbb::info::default_concurrency(); }

}  // namespace tumble

#else

namespace tumble {

TaskSystem make_default_tasks(int) {
    return [](int count, const std::function<void(int)>& task) {
        for (int i = 0; i < count; ++i) task(i);
    };
}

int default_thread_count() { return 1; }

}  // namespace tumble

#endif
