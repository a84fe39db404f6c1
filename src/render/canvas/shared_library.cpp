#include "render/canvas/shared_library.hpp"

#include <dlfcn.h>

#include <cstdlib>

#include "tumble/render.hpp"

namespace tumble::render {

SharedLibrary::SharedLibrary(std::initializer_list<const char*> names, const std::string& package) {
    // One thread draws while others encode: rasteriser threads would compete with them. Mesa reads the variable while
    // it loads. A value set by the user is kept.
    setenv("LP_NUM_THREADS", "0", 0);
    std::string reasons;
    for (const char* const name : names) {
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        name_ = name;
        if (handle_) return;
        reasons += std::string(reasons.empty() ? "" : "; ") + dlerror();
    }
    throw RenderError("no off-screen OpenGL: " + reasons + " (Debian: apt install " + package + ")");
}

void* SharedLibrary::find_symbol(const char* name) const {
    if (void* const symbol = dlsym(handle_, name)) return symbol;
    throw RenderError("no off-screen OpenGL: " + name_ + " has no " + name);
}

}  // namespace tumble::render
