#include "tools/query/shape_json.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "tools/output/input_error.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

using Json = nlohmann::json;

namespace {

[[noreturn]] void fail(const std::string& source, const std::string& message) {
    throw InputError(source + ": " + message);
}

double read_number(const Json& number, const std::string& source) {
    if (!number.is_number()) fail(source, "must be a number, got " + number.dump());
    return number.get<double>();
}

DVec2 read_pair(const Json& pair, const std::string& source) {
    if (!pair.is_array() || pair.size() != 2) fail(source, "must be two numbers, got " + pair.dump());
    return {read_number(pair[0], source + "/0"), read_number(pair[1], source + "/1")};
}

Rotation read_rotation(const Json& rotation, const std::string& source) {
    const DVec2 pair = read_pair(rotation, source);
    if (!is_cosine_and_sine(pair)) fail(source, "must be the cosine and the sine of an angle, got " + rotation.dump());
    return {static_cast<float>(pair.x), static_cast<float>(pair.y)};
}

}  // namespace

bool is_cosine_and_sine(DVec2 pair) {
    constexpr double kRounding = 0.01;  // of a cosine with two decimals
    return std::abs(length(pair) - 1.0) <= kRounding;
}

Json parse_json(std::string_view text, const std::string& source) {
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        // Without the name of the exception: "[json.exception.parse_error.101] parse error at ...".
        const std::string what = error.what();
        fail(source, "not valid JSON: " + what.substr(what.starts_with('[') ? what.find(']') + 2 : 0));
    }
}

Shape parse_shape(std::string_view text, const std::string& source) {
    std::vector<Shape> shapes = parse_shapes(text, source);
    if (shapes.size() == 1) return std::move(shapes.front());
    fail(source, "must be one convex shape; of a chain or an outline, query one piece at a time");
}

Pose parse_pose(std::string_view text, const std::string& source) {
    const Json pose = parse_json(text, source);
    if (!pose.is_object()) fail(source, "must be an object, got " + pose.dump());
    Pose parsed;
    for (const auto& item : pose.items()) {
        const std::string member = source + "/" + item.key();
        if (item.key() == "position")
            parsed.position = read_pair(item.value(), member);
        else if (item.key() == "angle")
            parsed.rotation = make_rotation_degrees(read_number(item.value(), member));
        else if (item.key() == "rotation")
            parsed.rotation = read_rotation(item.value(), member);
        else
            fail(member, "unknown key; expected position, and angle or rotation");
    }
    if (pose.contains("angle") && pose.contains("rotation")) fail(source, "must have an angle or a rotation, got both");
    return parsed;
}

}  // namespace tumble::tools
