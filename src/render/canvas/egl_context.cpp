// EGL without a surface: drawing into a renderbuffer, whose pixels are read back after each frame.
//
// Mesa offers the platform on every machine, by a graphics card or by the software rasteriser that OSMesa uses too. The
// library is opened at run time. OpenGL is that of the driver: its frames differ by 1/255 from those of OSMesa.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "render/canvas/offscreen_context.hpp"
#include "render/canvas/shared_library.hpp"
#include "tumble/render.hpp"

namespace tumble::render {
namespace {

std::string hexadecimal(EGLint number) {
    std::string digits;
    for (auto rest = static_cast<unsigned>(number); rest > 0; rest /= 16) digits += "0123456789abcdef"[rest % 16];
    return "0x" + std::string(digits.rbegin(), digits.rend());
}

// The library with its display, which all contexts share and which is never closed.
struct EglLibrary {
    decltype(&eglGetProcAddress) get_procedure = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglCreateContext) create_context = nullptr;
    decltype(&eglDestroyContext) destroy_context = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    decltype(&eglGetError) get_error = nullptr;
    EGLDisplay display = EGL_NO_DISPLAY;

    EglLibrary() {
        const SharedLibrary egl({"libEGL.so.1", "libEGL.so"}, "libegl1");
        egl.find("eglGetProcAddress", get_procedure);
        egl.find("eglInitialize", initialize);
        egl.find("eglBindAPI", bind_api);
        egl.find("eglCreateContext", create_context);
        egl.find("eglDestroyContext", destroy_context);
        egl.find("eglMakeCurrent", make_current);
        egl.find("eglGetError", get_error);
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_procedure("eglGetPlatformDisplayEXT"));
        if (get_display) display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        require(display != EGL_NO_DISPLAY, "has no display without a surface (Debian: apt install libegl-mesa0)");
        require(initialize(display, nullptr, nullptr) == EGL_TRUE,
                "does not start (Debian: apt install libgl1-mesa-dri)");
    }

    void require(bool condition, const std::string& failure) const {
        if (!condition) throw RenderError("EGL " + failure + ", error " + hexadecimal(get_error()));
    }
};

const EglLibrary& egl() {
    static const EglLibrary loaded;
    return loaded;
}

class EglContext final : public OffscreenContext {
public:
    EglContext() {
        const EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        egl().require(egl().bind_api(EGL_OPENGL_API) == EGL_TRUE, "offers no OpenGL");
        context_ = egl().create_context(egl().display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        egl().require(context_ != EGL_NO_CONTEXT, "offers no OpenGL 3.3 core context");
    }

    ~EglContext() override {
        release_current();
        egl().destroy_context(egl().display, context_);  // with its objects
    }

    Procedure find_procedure(const char* name) const override { return egl().get_procedure(name); }

    void finish() override {
        read_pixels_(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rows_.data());
        // OpenGL's rows start at the bottom.
        const auto row = 4 * static_cast<std::size_t>(width_);
        for (std::size_t from = rows_.size(), to = 0; from > 0; to += row) {
            from -= row;
            std::copy_n(rows_.data() + from, row, target_ + to);
        }
    }

private:
    void make_current(std::uint8_t* rgba, int width, int height) override {
        egl().require(egl().make_current(egl().display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE,
                      "refuses to draw without a surface");
        if (width != width_ || height != height_) make_target(width, height);
        target_ = rgba;
    }

    void release() override { egl().make_current(egl().display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

    template <class Function>
    Function find(const char* name) const {
        if (const Procedure procedure = find_procedure(name)) return reinterpret_cast<Function>(procedure);
        throw RenderError(std::string("the OpenGL context has no ") + name);
    }

    // A renderbuffer of that size, which all later drawing goes to.
    void make_target(int width, int height) {
        GLuint frame = 0, colors = 0;
        find<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &frame);
        find<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, frame);
        find<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(1, &colors);
        find<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, colors);
        find<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(GL_RENDERBUFFER, GL_RGBA8, width, height);
        find<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                                            GL_RENDERBUFFER, colors);
        if (find<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus")(GL_FRAMEBUFFER) !=
            GL_FRAMEBUFFER_COMPLETE)
            throw RenderError("EGL refuses a frame of " + std::to_string(width) + "x" + std::to_string(height));
        read_pixels_ = find<PFNGLREADPIXELSPROC>("glReadPixels");
        rows_.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        width_ = width;
        height_ = height;
    }

    EGLContext context_ = EGL_NO_CONTEXT;
    PFNGLREADPIXELSPROC read_pixels_ = nullptr;
    std::vector<std::uint8_t> rows_;
    std::uint8_t* target_ = nullptr;
    int width_ = 0, height_ = 0;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace tumble::render
