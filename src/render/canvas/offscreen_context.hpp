// A GL context without a window. Each back end is one source file with a factory declared below; the canvas depends on
// the interface alone.
#pragma once

#include <cstdint>
#include <memory>

namespace tumble::render {

class OffscreenContext {
public:
    using Procedure = void (*)();

    OffscreenContext() = default;
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    // Makes the context current on this thread with the target `rgba`, [height][width][4], top row first. The buffer
    // must outlive the drawing.
    void bind(std::uint8_t* rgba, int width, int height);

    // Completes the target after glFinish: until then it need not hold what was drawn.
    virtual void finish() = 0;

    // The GL entry point of that name, or null.
    virtual Procedure find_procedure(const char* name) const = 0;

protected:
    // Mesa's OSMesa and EGL share one variable for the current context of a thread, and each takes what is there for
    // its own: the context of one must be released before the other binds or destroys any. A back end calls this first
    // in its destructor.
    void release_current();

private:
    virtual void make_current(std::uint8_t* rgba, int width, int height) = 0;

    // No context is current on this thread any more.
    virtual void release() = 0;
};

// OpenGL 3.3, core profile. A library is loaded on the first call and stays loaded. Both throw RenderError.
std::unique_ptr<OffscreenContext> make_osmesa_context();
std::unique_ptr<OffscreenContext> make_egl_context();

}  // namespace tumble::render
