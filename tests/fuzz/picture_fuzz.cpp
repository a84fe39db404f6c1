// libFuzzer target over PNG files, as `diff` and the claims on pictures read them: any bytes are a picture with all its
// pixels, or an error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "tools/diff/png_reader.hpp"
#include "tools/output/input_error.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("fuzzed.png");
    try {
        const Image image = tools::read_png(file.write(fuzz::text_of(data, size)));
        const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        if (image.rgba.size() != 4 * pixels) std::abort();
    } catch (const tools::InputError&) {
    }
    return 0;
}
