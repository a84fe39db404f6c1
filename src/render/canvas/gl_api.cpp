#include "render/canvas/gl_api.hpp"

#include <string>

#include "tumble/render.hpp"

namespace tumble::render {
namespace {

template <class Function>
void find(const OffscreenContext& context, const char* name, Function& function) {
    function = reinterpret_cast<Function>(context.find_procedure(name));
    if (!function) throw RenderError(std::string("the OpenGL context has no ") + name);
}

}  // namespace

GlApi load_gl_api(const OffscreenContext& context) {
    GlApi api;
#define TUMBLE_GL_FIND(name, type) find(context, "gl" #name, api.name);
    TUMBLE_GL_FUNCTIONS(TUMBLE_GL_FIND)
#undef TUMBLE_GL_FIND
    return api;
}

}  // namespace tumble::render
