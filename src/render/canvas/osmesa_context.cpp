// OSMesa: Mesa's software rasteriser, which draws into a buffer of the caller.
//
// The library is opened at run time. Linked, it would cost every process 50 MB and 9 ms, and export names that clash
// with a real GL. The buffer holds the frame after glFinish: no pixels are read back.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstdlib>
#include <string>

#include "render/canvas/offscreen_context.hpp"
#include "tumble/render.hpp"

namespace tumble::render {
namespace {

struct Library {
    decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaPixelStore) pixel_store = nullptr;
    decltype(&OSMesaGetProcAddress) get_procedure = nullptr;
};

void* open_library() {
    // One thread draws while others encode: rasteriser threads would compete with them. The library reads the variable
    // while it loads. A value set by the user is kept.
    setenv("LP_NUM_THREADS", "0", 0);
    std::string reasons;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"}) {
        if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return handle;
        reasons += std::string(reasons.empty() ? "" : "; ") + dlerror();
    }
    throw RenderError("no off-screen OpenGL: " + reasons + " (Debian: apt install libosmesa6)");
}

template <class Function>
void find(void* handle, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    if (!function) throw RenderError(std::string("no off-screen OpenGL: libOSMesa has no ") + name);
}

Library load_library() {
    void* const handle = open_library();
    Library library;
    find(handle, "OSMesaCreateContextAttribs", library.create_context);
    find(handle, "OSMesaDestroyContext", library.destroy_context);
    find(handle, "OSMesaMakeCurrent", library.make_current);
    find(handle, "OSMesaPixelStore", library.pixel_store);
    find(handle, "OSMesaGetProcAddress", library.get_procedure);
    return library;
}

const Library& library() {
    static const Library loaded = load_library();
    return loaded;
}

class OsmesaContext final : public OffscreenContext {
public:
    OsmesaContext() {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_STENCIL_BITS,
                                  0,
                                  OSMESA_ACCUM_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context_ = library().create_context(attributes, nullptr);
        if (!context_) throw RenderError("OSMesa offers no OpenGL 3.3 core context");
    }

    ~OsmesaContext() override {
        library().make_current(nullptr, nullptr, 0, 0, 0);
        library().destroy_context(context_);
    }

    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    void bind(std::uint8_t* rgba, int width, int height) override {
        if (!library().make_current(context_, rgba, GL_UNSIGNED_BYTE, width, height))
            throw RenderError("OSMesa refuses a frame of " + std::to_string(width) + "x" + std::to_string(height));
        library().pixel_store(OSMESA_Y_UP, 0);
    }

    Procedure find_procedure(const char* name) const override { return library().get_procedure(name); }

private:
    OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace tumble::render
