// Threads that draw the frames of a run while it goes on. Each has a renderer and a copy of the world.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tools/run/run_options.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// Frames are the same for each number of threads, and are taken in the order in which they were given.
class FrameDrawers {
public:
    using Take = std::function<void(Image image)>;

    // Draws on `options.jobs` threads; if that is 1, on the caller's. The scene and the options must live longer.
    // Throws RenderError if there is no back end.
    FrameDrawers(const Scene& scene, const RunOptions& options, Take take);
    ~FrameDrawers();
    FrameDrawers(const FrameDrawers&) = delete;
    FrameDrawers& operator=(const FrameDrawers&) = delete;

    // Draws the present state of the world, now or later, into `image`, whose buffer is used again. Earlier frames may
    // be taken meanwhile. Throws what drawing one of them has thrown.
    void draw(const SceneWorld& world, const Camera& camera, const Marking& marking, Image image);

    // Waits until all frames are taken.
    void finish();

    double seconds() const noexcept { return seconds_; }  // of drawing, summed over the threads

private:
    class Drawer;

    void take_next();

    const Scene& scene_;
    const RunOptions& options_;
    Take take_;
    std::unique_ptr<Renderer> renderer_;            // of the caller's thread, or
    std::vector<std::unique_ptr<Drawer>> drawers_;  // threads: frame k is drawn by number k modulo their count
    std::uint64_t given_ = 0, taken_ = 0;           // frames
    double seconds_ = 0.0;
};

}  // namespace tumble::tools
