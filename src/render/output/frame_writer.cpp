// Encoder threads behind a bounded queue. Image buffers are reused, so that a run allocates only a few.
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "debug/check.hpp"
#include "render/output/png.hpp"

namespace tumble {

struct FrameWriter::Impl {
    struct Job {
        Image image;
        std::filesystem::path file;
    };

    explicit Impl(int thread_count) : queue_limit(static_cast<std::size_t>(thread_count) + 1) {
        for (int i = 0; i < thread_count; ++i) threads.emplace_back([this] { run(); });
    }

    ~Impl() {
        {
            const std::lock_guard lock(mutex);
            closing = true;
        }
        work_arrived.notify_all();
        for (std::thread& thread : threads) thread.join();
    }

    void run() {
        std::unique_lock lock(mutex);
        for (;;) {
            work_arrived.wait(lock, [&] { return closing || !queue.empty(); });
            if (queue.empty()) return;
            Job job = std::move(queue.front());
            queue.pop_front();
            ++busy;
            lock.unlock();
            encode(job);
            lock.lock();
            TUMBLE_CHECK(busy > 0);
            --busy;
            spare.push_back(std::move(job.image));
            work_done.notify_all();
        }
    }

    // Writes the frame unless an earlier one failed: a full disk is reported once, not tried again for each frame.
    void encode(const Job& job) {
        {
            const std::lock_guard lock(mutex);
            if (error) return;
        }
        const auto start = std::chrono::steady_clock::now();
        std::uint64_t bytes = 0;
        std::exception_ptr failure;
        try {
            bytes = render::write_png_file(job.image, job.file);
        } catch (...) {
            failure = std::current_exception();
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        const std::lock_guard lock(mutex);
        written.encode_seconds += elapsed.count();
        if (failure) {
            if (!error) error = failure;
            return;
        }
        ++written.files;
        written.bytes += bytes;
    }

    void rethrow_error() const {
        if (error) std::rethrow_exception(error);
    }

    const std::size_t queue_limit;
    std::mutex mutex;
    std::condition_variable work_arrived;
    std::condition_variable work_done;
    std::deque<Job> queue;
    std::vector<Image> spare;
    std::size_t busy = 0;
    bool closing = false;
    std::exception_ptr error;
    Written written;
    std::vector<std::thread> threads;  // last: they use all of the above
};

FrameWriter::FrameWriter(int threads) {
    constexpr int kMostThreads = 256;
    if (threads < 1 || threads > kMostThreads)
        throw std::invalid_argument("a frame writer needs 1 to 256 threads, got " + std::to_string(threads));
    impl_ = std::make_unique<Impl>(threads);
}

FrameWriter::~FrameWriter() = default;

Image FrameWriter::take_image() {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->spare.empty()) return {};
    Image image = std::move(impl_->spare.back());
    impl_->spare.pop_back();
    return image;
}

void FrameWriter::submit(Image image, std::filesystem::path file) {
    std::unique_lock lock(impl_->mutex);
    impl_->work_done.wait(lock, [&] { return impl_->error || impl_->queue.size() < impl_->queue_limit; });
    impl_->rethrow_error();
    impl_->queue.push_back({std::move(image), std::move(file)});
    TUMBLE_CHECK(impl_->queue.size() <= impl_->queue_limit);
    impl_->work_arrived.notify_one();
}

FrameWriter::Written FrameWriter::finish() {
    std::unique_lock lock(impl_->mutex);
    impl_->work_done.wait(lock, [&] { return impl_->queue.empty() && impl_->busy == 0; });
    impl_->rethrow_error();
    return impl_->written;
}

}  // namespace tumble
