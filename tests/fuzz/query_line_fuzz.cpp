// libFuzzer target over a line of `tumble distance --stdin`: the answer to any text is a result or an error
// with its location, and the strict reader gives the same answer to each line that the fast reader accepts.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "tools/output/input_error.hpp"
#include "tools/query/distance_query.hpp"
#include "tools/query/plain_query.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

std::string answer_to(const tools::DistanceQuery& query) {
    tools::JsonWriter json(tools::JsonWriter::Layout::compact);
    tools::write_answer(json, query, distance(query.a, query.a_pose, query.b, query.b_pose));
    return json.text();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view line(reinterpret_cast<const char*>(data), size);
    const std::optional<tools::DistanceQuery> plain = tools::read_plain_query(line);
    try {
        const tools::DistanceQuery strict = tools::parse_query_line_strictly(line);
        const std::string answer = answer_to(strict);
        if (plain && answer_to(*plain) != answer) std::abort();
    } catch (const tools::InputError&) {
        if (plain) std::abort();
    } catch (const SceneError&) {
        if (plain) std::abort();
    }
    return 0;
}
