// libFuzzer target over the list of runs that crashed, which each process of a sweep reads: any text skips runs that it
// names twice, each with the name of a signal.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "tools/sweep/crash_log.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("leases/crashes");
    const std::filesystem::path folder = file.write(fuzz::text_of(data, size)).parent_path().parent_path();
    for (const auto& [run, signal] : tools::CrashLog::runs_to_skip(folder))
        if (!signal.starts_with("SIG") || signal.size() > 7) std::abort();
    return 0;
}
