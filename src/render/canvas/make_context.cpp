#include "render/canvas/make_context.hpp"

#include <string>

namespace tumble::render {

std::unique_ptr<OffscreenContext> make_context(RenderBackend backend) {
    if (backend == RenderBackend::osmesa) return make_osmesa_context();
    if (backend == RenderBackend::egl) return make_egl_context();
    std::string first;
    try {
        return make_osmesa_context();
    } catch (const RenderError& error) {
        first = error.what();
    }
    try {
        return make_egl_context();
    } catch (const RenderError& error) {
        throw RenderError(first + "\n" + error.what());
    }
}

}  // namespace tumble::render
