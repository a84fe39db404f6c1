// libFuzzer target over a line of `tumble distance --stdin`: any text is answered by a result or by a located error.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "distance_query.hpp"
#include "input_error.hpp"
#include "tumble/scene.hpp"

using namespace tumble;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view line(reinterpret_cast<const char*>(data), size);
    try {
        const tools::DistanceQuery query = tools::parse_query_line(line);
        tools::JsonWriter json(tools::JsonWriter::Layout::compact);
        tools::write_answer(json, query, distance(query.a, query.a_pose, query.b, query.b_pose));
    } catch (const tools::InputError&) {
    } catch (const SceneError&) {
    }
    return 0;
}
