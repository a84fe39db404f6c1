#include "render/canvas/offscreen_context.hpp"

namespace tumble::render {

namespace {

thread_local OffscreenContext* current_on_thread = nullptr;

}  // namespace

void OffscreenContext::bind(std::uint8_t* rgba, int width, int height) {
    if (current_on_thread != this) release_current();
    make_current(rgba, width, height);
    current_on_thread = this;
}

void OffscreenContext::release_current() {
    if (current_on_thread) current_on_thread->release();
    current_on_thread = nullptr;
}

}  // namespace tumble::render
