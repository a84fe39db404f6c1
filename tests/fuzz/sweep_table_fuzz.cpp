// libFuzzer target over the tables of sweeps, as `sweep plot` reads them: any text is drawn, or refused with an error.
// The first byte chooses whether a header stands before the text.
#include <cstddef>
#include <cstdint>
#include <string>

#include "scratch_file.hpp"
#include "tools/output/input_error.hpp"
#include "tools/plot/sweep_plot.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("runs.csv");
    if (size == 0) return 0;
    const std::string header = data[0] < 128 ? "run,scene,seed,speed,angle,outcome,height\n" : "";
    const std::filesystem::path& table = file.write(header + std::string(fuzz::text_of(data + 1, size - 1)));
    for (const char* const y : {"", "angle"}) {
        try {
            to_svg(tools::draw_sweep(table, {.x = "speed", .y = y, .value = "height"}));
        } catch (const tools::InputError&) {
        }
    }
    return 0;
}
