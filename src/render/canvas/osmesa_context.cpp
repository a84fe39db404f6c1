// OSMesa: Mesa's software rasteriser, which draws into a buffer of the caller.
//
// The library is opened at run time. Linked, it would cost every process 50 MB and 9 ms, and export names that clash
// with a real GL. The buffer holds the frame after glFinish: no pixels are read back. Its header is not needed either:
// Mesa has none since version 25.1, and what is used of it is declared here.
#include <GL/glcorearb.h>

#include <string>

#include "render/canvas/offscreen_context.hpp"
#include "render/canvas/shared_library.hpp"
#include "tumble/render.hpp"

namespace tumble::render {
namespace {

// From GL/osmesa.h, version 11.2.
constexpr int kOsmesaFormat = 0x22, kOsmesaRgba = GL_RGBA;
constexpr int kOsmesaDepthBits = 0x30, kOsmesaStencilBits = 0x31, kOsmesaAccumBits = 0x32;
constexpr int kOsmesaProfile = 0x33, kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaMajorVersion = 0x36, kOsmesaMinorVersion = 0x37;
constexpr int kOsmesaYUp = 0x11;

struct Library {
    void* (*create_context)(const int* attributes, void* shared) = nullptr;
    void (*destroy_context)(void* context) = nullptr;
    GLboolean (*make_current)(void* context, void* buffer, GLenum type, GLsizei width, GLsizei height) = nullptr;
    void (*pixel_store)(GLint name, GLint value) = nullptr;
    OffscreenContext::Procedure (*get_procedure)(const char* name) = nullptr;

    Library() {
        const SharedLibrary osmesa({"libOSMesa.so.8", "libOSMesa.so"}, "libosmesa6");
        osmesa.find("OSMesaCreateContextAttribs", create_context);
        osmesa.find("OSMesaDestroyContext", destroy_context);
        osmesa.find("OSMesaMakeCurrent", make_current);
        osmesa.find("OSMesaPixelStore", pixel_store);
        osmesa.find("OSMesaGetProcAddress", get_procedure);
    }
};

const Library& library() {
    static const Library loaded;
    return loaded;
}

class OsmesaContext final : public OffscreenContext {
public:
    OsmesaContext() {
        const int attributes[] = {kOsmesaFormat,
                                  kOsmesaRgba,
                                  kOsmesaDepthBits,
                                  0,
                                  kOsmesaStencilBits,
                                  0,
                                  kOsmesaAccumBits,
                                  0,
                                  kOsmesaProfile,
                                  kOsmesaCoreProfile,
                                  kOsmesaMajorVersion,
                                  3,
                                  kOsmesaMinorVersion,
                                  3,
                                  0};
        context_ = library().create_context(attributes, nullptr);
        if (!context_) throw RenderError("OSMesa offers no OpenGL 3.3 core context");
    }

    ~OsmesaContext() override {
        release_current();
        library().destroy_context(context_);
    }

    Procedure find_procedure(const char* name) const override { return library().get_procedure(name); }

    void finish() override {}

private:
    void make_current(std::uint8_t* rgba, int width, int height) override {
        if (!library().make_current(context_, rgba, GL_UNSIGNED_BYTE, width, height))
            throw RenderError("OSMesa refuses a frame of " + std::to_string(width) + "x" + std::to_string(height));
        library().pixel_store(kOsmesaYUp, 0);
    }

    void release() override { library().make_current(nullptr, nullptr, 0, 0, 0); }

    void* context_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace tumble::render
