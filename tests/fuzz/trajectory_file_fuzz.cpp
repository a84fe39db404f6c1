// libFuzzer target over the HDF5 files of sweeps, as `sweep export` reads them: any bytes are trajectories of the sizes
// that they state, or are refused with an error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "sweep/hdf5/trajectory_reader.hpp"
#include "tumble/file.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("shard-000000.h5");
    try {
        const sweep::TrajectoryReader reader(file.write(fuzz::text_of(data, size)));
        for (std::size_t i = 0; i < reader.size(); ++i) {
            const auto& states = reader.read(i).states;
            if (states.numbers.size() != states.steps * states.bodies * sweep::kStateNumbers) std::abort();
        }
    } catch (const FileError&) {
    }
    return 0;
}
