#include "shape_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "input_error.hpp"
#include "tumble/scene.hpp"

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
    const double largest = std::numeric_limits<float>::max();
    if (std::abs(pair.x) > largest || std::abs(pair.y) > largest)
        fail(source, "must be [cosine, sine], got " + rotation.dump());
    return {static_cast<float>(pair.x), static_cast<float>(pair.y)};
}

}  // namespace

Shape parse_shape(const Json& shape, const std::string& source) {
    const ShapeGeometry geometry = parse_geometry(shape.dump(), source);
    try {
        const std::vector<Shape> shapes = make_shapes(geometry);
        if (shapes.size() == 1) return shapes.front();
    } catch (const std::invalid_argument& error) {
        fail(source, error.what());
    }
    fail(source, "must be one convex shape; of a chain or an outline, give one piece");
}

Pose parse_pose(const Json& pose, const std::string& source) {
    if (!pose.is_object()) fail(source, "must be an object, got " + pose.dump());
    Pose parsed;
    for (const auto& item : pose.items()) {
        const std::string place = source + "/" + item.key();
        if (item.key() == "position")
            parsed.position = read_pair(item.value(), place);
        else if (item.key() == "angle")
            parsed.rotation = make_rotation_degrees(read_number(item.value(), place));
        else if (item.key() == "rotation")
            parsed.rotation = read_rotation(item.value(), place);
        else
            fail(place, "unknown key; a pose has a position, and an angle or a rotation");
    }
    if (pose.contains("angle") && pose.contains("rotation")) fail(source, "needs an angle or a rotation, got both");
    return parsed;
}

}  // namespace tumble::tools
