// A GL context without a window. Each back end is one source file with a factory declared below; the canvas depends on
// the interface alone.
#pragma once

#include <cstdint>
#include <memory>

namespace tumble::render {

class OffscreenContext {
public:
    using Procedure = void (*)();

    virtual ~OffscreenContext() = default;

    // Makes the context current on this thread with the target `rgba`, [height][width][4], top row first. The buffer
    // must outlive the drawing.
    virtual void bind(std::uint8_t* rgba, int width, int height) = 0;

    // The GL entry point of that name, or null.
    virtual Procedure find_procedure(const char* name) const = 0;
};

// OpenGL 3.3, core profile, by Mesa's software rasteriser. The library is loaded on the first call and stays loaded.
// Throws RenderError.
std::unique_ptr<OffscreenContext> make_osmesa_context();

}  // namespace tumble::render
