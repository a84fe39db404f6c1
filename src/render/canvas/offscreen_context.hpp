// A GL context without a window. One back end is one file; nothing else knows which it is.
#pragma once

#include <cstdint>
#include <memory>

namespace tumble::render {

class OffscreenContext {
public:
    using Procedure = void (*)();

    virtual ~OffscreenContext() = default;

    // Makes the context current on this thread, drawing into `rgba`, [height][width][4], top row first.
    virtual void bind(std::uint8_t* rgba, int width, int height) = 0;

    // The GL entry point of that name, or null.
    virtual Procedure find_procedure(const char* name) const = 0;
};

// A context of OpenGL 3.3, core profile, drawn by Mesa on the processor. The library is loaded on the first call and
// stays loaded. Throws RenderError.
std::unique_ptr<OffscreenContext> make_osmesa_context();

}  // namespace tumble::render
