#include "distance_query.hpp"

#include <nlohmann/json.hpp>

#include "input_error.hpp"
#include "shape_json.hpp"

namespace tumble::tools {

using Json = nlohmann::json;

namespace {

Json parse_json(std::string_view text, const std::string& what) {
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        throw InputError(what + " is not valid JSON: " + error.what());
    }
}

Json parse_object(std::string_view text, const std::string& what) {
    Json object = parse_json(text, what);
    if (!object.is_object()) throw InputError(what + " must be a JSON object, got " + object.dump());
    return object;
}

Pose optional_pose(const Json& object, const char* key, const std::string& source) {
    const auto found = object.find(key);
    return found == object.end() ? Pose{} : parse_pose(*found, source);
}

const char* to_text(DistanceStatus status) {
    switch (status) {
        case DistanceStatus::separated: return "separated";
        case DistanceStatus::touching: return "touching";
        case DistanceStatus::overlapping: return "overlapping";
        case DistanceStatus::invalid: break;
    }
    return "invalid";
}

void write_pair(JsonWriter& json, const char* key, double x, double y) {
    json.key(key).open_array().value(x).value(y).close_array();
}

void write_pose(JsonWriter& json, const char* key, const Pose& pose) {
    json.key(key).open_object();
    write_pair(json, "position", pose.position.x, pose.position.y);
    json.key("rotation").open_array().value(pose.rotation.c).value(pose.rotation.s).close_array();
    json.close_object();
}

void write_certificate(JsonWriter& json, const Certificate& certificate) {
    json.key("certificate").open_object();
    write_pair(json, "direction", certificate.direction.x, certificate.direction.y);
    json.key("pairs").open_array();
    for (std::size_t i = 0; i < certificate.pair_count; ++i)
        json.open_array().value(certificate.pairs[i].a).value(certificate.pairs[i].b).close_array();
    json.close_array().member("cores_overlap", certificate.cores_overlap).close_object();
}

std::string point_text(DVec2 point) {
    std::string text = "(";
    append_number(text, point.x);
    text += ", ";
    append_number(text, point.y);
    return text + ")";
}

}  // namespace

DistanceQuery parse_query_line(std::string_view line) {
    const Json object = parse_object(line, "the line");
    for (const auto& item : object.items())
        if (item.key() != "a" && item.key() != "b" && item.key() != "a_pose" && item.key() != "b_pose")
            throw InputError(item.key() + ": unknown key; a line has a, b, a_pose and b_pose");
    if (!object.contains("a") || !object.contains("b")) throw InputError("needs the keys a and b");
    return {parse_shape(object["a"], "a"), parse_shape(object["b"], "b"), optional_pose(object, "a_pose", "a_pose"),
            optional_pose(object, "b_pose", "b_pose")};
}

DistanceQuery parse_query_arguments(std::string_view a, std::string_view b) {
    Json object_a = parse_object(a, "A");
    Json object_b = parse_object(b, "B");
    const Pose a_pose = optional_pose(object_a, "pose", "A/pose");
    const Pose b_pose = optional_pose(object_b, "pose", "B/pose");
    object_a.erase("pose");
    object_b.erase("pose");
    return {parse_shape(object_a, "A"), parse_shape(object_b, "B"), a_pose, b_pose};
}

void write_answer(JsonWriter& json, const DistanceQuery& query, const DistanceResult& result) {
    json.open_object()
        .member("distance", result.distance)
        .member("lower", result.lower)
        .member("upper", result.upper);
    write_pair(json, "point_a", result.point_a.x, result.point_a.y);
    write_pair(json, "point_b", result.point_b.x, result.point_b.y);
    write_pair(json, "normal", result.normal.x, result.normal.y);
    json.member("status", to_text(result.status)).member("iterations", result.iterations);
    write_pose(json, "a_pose", query.a_pose);
    write_pose(json, "b_pose", query.b_pose);
    write_certificate(json, result.certificate);
    json.close_object();
}

std::string answer_text(const DistanceResult& result) {
    std::string text = to_text(result.status);
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
