#include "tools/run/frame_drawers.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "tools/measure/stopwatch.hpp"

namespace tumble::tools {

// One thread, which draws one frame at a time. Its context of OpenGL belongs to the thread.
class FrameDrawers::Drawer {
public:
    Drawer(const Scene& scene, const RunOptions& options)
        : scene_(scene), options_(options), thread_([this] { run(); }) {}

    ~Drawer() {
        set(State::closing);
        thread_.join();
    }
    Drawer(const Drawer&) = delete;
    Drawer& operator=(const Drawer&) = delete;

    // The frame before must be taken.
    void start(const SceneWorld& world, const Camera& camera, const Marking& marking, Image image) {
        world_.world.assign(world.world);
        world_.bodies = world.bodies;
        world_.joints = world.joints;
        camera_ = camera;
        marking_ = marking;
        image_ = std::move(image);
        set(State::drawing);
    }

    // Waits for the renderer or the frame.
    void wait() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return state_ == State::waiting; });
        if (error_) std::rethrow_exception(error_);
    }

    Image take() {
        wait();
        return std::move(image_);
    }

    double seconds() const noexcept { return seconds_; }  // of the frame that was taken

private:
    enum class State { waiting, drawing, closing };

    void set(State state) {
        const std::lock_guard lock(mutex_);
        state_ = state;
        changed_.notify_all();
    }

    void run() {
        std::optional<Renderer> renderer;
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return state_ != State::waiting; });
            if (state_ == State::closing) return;
            lock.unlock();
            const Stopwatch watch;
            std::exception_ptr error;
            try {
                if (renderer)
                    renderer->draw(scene_, world_, camera_, world_.world.time(), image_, options_.overlay, marking_);
                else
                    renderer.emplace(options_.size.width, options_.size.height, options_.renderer);
            } catch (...) {
                error = std::current_exception();
            }
            lock.lock();
            seconds_ = watch.seconds();
            error_ = error;
            if (state_ == State::drawing) state_ = State::waiting;
            changed_.notify_all();
        }
    }

    const Scene& scene_;
    const RunOptions& options_;
    SceneWorld world_;
    Camera camera_;
    Marking marking_;
    Image image_;
    double seconds_ = 0.0;
    std::exception_ptr error_;
    State state_ = State::drawing;  // at first of nothing: it makes its renderer
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;  // last: it uses all of the above
};

FrameDrawers::FrameDrawers(const Scene& scene, const RunOptions& options, Take take)
    : scene_(scene), options_(options), take_(std::move(take)) {
    if (options.jobs == 1)
        renderer_ = std::make_unique<Renderer>(options.size.width, options.size.height, options.renderer);
    else
        for (int i = 0; i < options.jobs; ++i) drawers_.push_back(std::make_unique<Drawer>(scene, options));
    for (const auto& drawer : drawers_) drawer->wait();
}

FrameDrawers::~FrameDrawers() = default;

void FrameDrawers::draw(const SceneWorld& world, const Camera& camera, const Marking& marking, Image image) {
    if (renderer_) {
        const Stopwatch watch;
        renderer_->draw(scene_, world, camera, world.world.time(), image, options_.overlay, marking);
        seconds_ += watch.seconds();
        return take_(std::move(image));
    }
    if (given_ - taken_ == drawers_.size()) take_next();
    drawers_[given_++ % drawers_.size()]->start(world, camera, marking, std::move(image));
}

void FrameDrawers::take_next() {
    Drawer& drawer = *drawers_[taken_++ % drawers_.size()];
    Image image = drawer.take();
    seconds_ += drawer.seconds();
    take_(std::move(image));
}

void FrameDrawers::finish() {
    while (taken_ < given_) take_next();
}

}  // namespace tumble::tools
