// libFuzzer target over picture files, as `diff`, the claims on pictures and the images of bodies read them: any bytes
// are a picture with all its pixels, or an error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "tumble/render.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("fuzzed_picture");
    try {
        const Image image = read_picture(file.write(fuzz::text_of(data, size)));
        const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        if (image.rgba.size() != 4 * pixels) std::abort();
    } catch (const PictureError&) {
    }
    return 0;
}
