#include "tools/query/distance_query.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "tools/output/input_error.hpp"
#include "tools/query/json_members.hpp"
#include "tools/query/plain_query.hpp"
#include "tools/query/shape_json.hpp"

namespace tumble::tools {

namespace {

// The members of an object. Throws InputError for any other text.
std::vector<JsonMember> members_of(std::string_view text, const std::string& source) {
    if (std::optional<std::vector<JsonMember>> members = split_members(text)) return *std::move(members);
    throw InputError(source + ": must be a JSON object, got " + parse_json(text, source).dump());
}

// Throws InputError for the second value of a key.
void set_once(std::optional<std::string_view>& value, const JsonMember& member) {
    if (value) throw InputError(std::string(member.key) + ": the key is given twice");
    value = member.value;
}

Pose optional_pose(std::optional<std::string_view> text, const std::string& source) {
    return text ? parse_pose(*text, source) : Pose{};
}

struct ShapeAtPose {
    Shape shape;
    Pose pose;
};

// Reads a SHAPE with an optional key "pose". `pose` is one that is given beside the shape; both are an error.
ShapeAtPose parse_posed(std::string_view text, const std::string& source, std::optional<std::string_view> pose = {}) {
    const std::string pose_source = source + (pose ? "_pose" : "/pose");
    std::string shape;
    for (const JsonMember& member : members_of(text, source)) {
        if (member.key == "pose") {
            set_once(pose, member);
            continue;
        }
        for (const std::string_view part : {"position", "angle", "rotation"})
            if (member.key == part)
                throw InputError(source + "/" + std::string(part) +
                                 ": belongs to the pose: \"pose\": {\"position\": [x, y], \"angle\": degrees}");
        shape += shape.empty() ? "{\"" : ", \"";
        shape.append(member.key).append("\": ").append(member.value);
    }
    shape += shape.empty() ? "{}" : "}";
    return {parse_shape(shape, source), optional_pose(pose, pose_source)};
}

void write_pose(JsonWriter& json, const char* key, const Pose& pose) {
    json.key(key).open_object().member("position", pose.position);
    json.key("rotation").open_array().value(pose.rotation.c).value(pose.rotation.s).close_array();
    json.close_object();
}

void write_certificate(JsonWriter& json, const Certificate& certificate) {
    json.key("certificate").open_object().member("direction", certificate.direction);
    json.key("pairs").open_array();
    for (std::size_t i = 0; i < certificate.pair_count; ++i) write_pair(json, certificate.pairs[i]);
    json.close_array().member("cores_overlap", certificate.cores_overlap).close_object();
}

// Adding 0 turns -0 into 0.
std::string point_text(DVec2 point) {
    std::string text = "(";
    append_number(text, point.x + 0.0);
    text += ", ";
    append_number(text, point.y + 0.0);
    return text + ")";
}

}  // namespace

DistanceQuery parse_query_line(std::string_view line) {
    std::optional<DistanceQuery> plain = read_plain_query(line);
    return plain ? *std::move(plain) : parse_query_line_strictly(line);
}

DistanceQuery parse_query_line_strictly(std::string_view line) {
    std::optional<std::string_view> a, b, a_pose, b_pose;
    for (const JsonMember& member : members_of(line, "the line")) {
        if (member.key == "a")
            set_once(a, member);
        else if (member.key == "b")
            set_once(b, member);
        else if (member.key == "a_pose")
            set_once(a_pose, member);
        else if (member.key == "b_pose")
            set_once(b_pose, member);
        else
            throw InputError(std::string(member.key) + ": unknown key; expected a, b, a_pose and b_pose");
    }
    if (!a || !b) throw InputError("a query needs the keys \"a\" and \"b\"");
    ShapeAtPose at_a = parse_posed(*a, "a", a_pose), at_b = parse_posed(*b, "b", b_pose);
    return {std::move(at_a.shape), std::move(at_b.shape), at_a.pose, at_b.pose};
}

DistanceQuery parse_query_arguments(std::string_view a, std::string_view b) {
    ShapeAtPose at_a = parse_posed(a, "A"), at_b = parse_posed(b, "B");
    return {std::move(at_a.shape), std::move(at_b.shape), at_a.pose, at_b.pose};
}

void write_pair(JsonWriter& json, VertexPair pair) { json.open_array().value(pair.a).value(pair.b).close_array(); }

void write_answer(JsonWriter& json, const DistanceQuery& query, const DistanceResult& result) {
    json.open_object()
        .member("distance", result.distance)
        .member("lower", result.lower)
        .member("upper", result.upper)
        .member("point_a", result.point_a)
        .member("point_b", result.point_b)
        .member("normal", result.normal);
    json.member("status", to_string(result.status)).member("iterations", result.iterations);
    write_pose(json, "a_pose", query.a_pose);
    write_pose(json, "b_pose", query.b_pose);
    write_certificate(json, result.certificate);
    json.close_object();
}

std::string answer_text(const DistanceResult& result) {
    std::string text(to_string(result.status));
    text += "\n  distance    ";
    append_number(text, result.distance);
    text += " m\n  proved      from ";
    append_number(text, result.lower);
    text += " to ";
    append_number(text, result.upper);
    text += " m\n  point on A  " + point_text(result.point_a);
    text += "\n  point on B  " + point_text(result.point_b);
    text += "\n  normal      " + point_text(result.normal) + ", from A to B";
    text += "\n  iterations  " + std::to_string(result.iterations) + "\n";
    return text;
}

}  // namespace tumble::tools
