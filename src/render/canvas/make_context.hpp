// The choice of a back end.
#pragma once

#include <memory>

#include "render/canvas/offscreen_context.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

// Of OSMesa, or EGL if that fails, by default. Throws RenderError, which names all that was tried.
std::unique_ptr<OffscreenContext> make_context(RenderBackend backend);

}  // namespace tumble::render
