// libFuzzer target over the tables that `diff` reads: any two texts are compared, or refused with an error. The first
// byte chooses the kind of table and whether its header stands before each text, the second where the first text ends.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "scratch_file.hpp"
#include "tools/diff/body_states.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/diff/event_diff.hpp"
#include "tools/diff/hash_diff.hpp"
#include "tools/diff/trajectory_diff.hpp"
#include "tools/output/input_error.hpp"

using namespace tumble;
using std::filesystem::path;

namespace {

constexpr std::array<std::string_view, 3> kHeaders{"step,hash\n", "step,time,event,a,b,x,y,nx,ny,speed\n",
                                                   "step,time,body,x,y,angle,vx,vy,omega\n"};
constexpr double kTolerance = 0.5;

void compare(std::size_t kind, const path& a, const path& b) {
    if (kind == 0) {
        to_json(tools::compare_hash_files(a.string(), b.string()));
    } else if (kind == 1) {
        to_json(tools::compare_event_files(a, b, kTolerance));
    } else {
        const std::unique_ptr<tools::StateSource> of_a = tools::open_states(a), of_b = tools::open_states(b);
        to_json(tools::compare_states(*of_a, *of_b, kTolerance));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile file_a("a.csv"), file_b("b.csv");
    if (size < 2) return 0;
    const std::size_t kind = data[0] % kHeaders.size();
    const std::string header(data[0] < 128 ? kHeaders[kind] : "");
    const std::string_view text = fuzz::text_of(data + 2, size - 2);
    const std::size_t end = text.size() * data[1] / 256;
    const path& a = file_a.write(header + std::string(text.substr(0, end)));
    const path& b = file_b.write(header + std::string(text.substr(end)));
    for (const path& other : {a, b}) {
        try {
            compare(kind, a, other);
        } catch (const tools::InputError&) {
        }
    }
    return 0;
}
