// libFuzzer target over the logs of `shrink`: any text is a log, whose results a later search finds, or is refused with
// an error. The first byte chooses whether the title of a log stands before the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "scratch_file.hpp"
#include "tools/shrink/trial_log.hpp"
#include "tumble/file.hpp"

using namespace tumble;

namespace {

constexpr std::uint64_t kTask = 1, kCandidate = 0xabcd;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file("scene.shrink.log");
    if (size == 0) return 0;
    const std::string title = data[0] < 128 ? "tumble shrink 1 0000000000000001\n" : "";
    const std::filesystem::path& log = file.write(title + std::string(fuzz::text_of(data + 1, size - 1)));
    try {
        tools::TrialLog(log, kTask, false).add(kCandidate, {.fails = true, .step = 7});
        const auto found = tools::TrialLog(log, kTask, false).find(kCandidate);
        if (!found || !found->fails || found->step != 7) std::abort();
    } catch (const FileError&) {
    }
    return 0;
}
