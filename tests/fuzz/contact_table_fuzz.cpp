// libFuzzer target over the contacts beside a trajectory, which `diff` lists for the body that differs first: any text
// is listed, or refused with an error. The first byte chooses whether a header stands before the text.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "scratch_file.hpp"
#include "tools/diff/body_states.hpp"
#include "tools/diff/diff_report.hpp"
#include "tools/diff/trajectory_diff.hpp"
#include "tools/output/input_error.hpp"

using namespace tumble;

namespace {

constexpr const char* kHeader = "step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse\n";
// The bodies differ at step 2.
constexpr const char* kStates =
    "step,time,body,x,y,angle,vx,vy,omega\n"
    "0,0,a,0,0,0,0,0,0\n1,0.1,a,0,1,0,0,0,0\n2,0.2,a,0,";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ScratchFile contacts("contacts.csv"), other("b.csv");
    static const std::filesystem::path a = contacts.write_beside("a.csv", std::string(kStates) + "2,0,0,0,0\n");
    static const std::filesystem::path b = other.write(std::string(kStates) + "3,0,0,0,0\n");
    if (size == 0) return 0;
    contacts.write((data[0] < 128 ? kHeader : "") + std::string(fuzz::text_of(data + 1, size - 1)));
    try {
        const std::unique_ptr<tools::StateSource> of_a = tools::open_states(a), of_b = tools::open_states(b);
        to_json(tools::compare_states(*of_a, *of_b, 0.0));
    } catch (const tools::InputError&) {
    }
    return 0;
}
