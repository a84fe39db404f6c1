// libFuzzer target over summaries of runs, as `diff` reads them: any text is compared with another one, or refused with
// an error. A summary equals itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "scratch_file.hpp"
#include "tools/diff/summary_diff.hpp"
#include "tools/output/input_error.hpp"

using namespace tumble;

namespace {

constexpr const char* kOther = R"({"complete": true, "state_hash": "00", "wall_s": {"total": 1}, "steps": 60,
    "files": [{"path": "a/b.csv"}], "counters": {"bodies": 3}})";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile fuzzed("fuzzed.json"), other("other.json");
    const std::filesystem::path& file = fuzzed.write(fuzz::text_of(data, size));
    try {
        if (!tools::is_summary_file(file)) return 0;
        if (!tools::compare_summaries(file, file, 0.0).different.empty()) std::abort();
        to_text(tools::compare_summaries(file, other.write(kOther), 0.5));
        to_json(tools::compare_summaries(file, other.write(kOther), 0.5));
    } catch (const tools::InputError&) {
    }
    return 0;
}
