#include "tools/query/plain_query.hpp"

#include <rapidjson/document.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tools/query/shape_json.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

namespace {

using Value = rapidjson::Value;

// The strict reader accepts every number up to this size, for lengths and angles alike.
constexpr double kPlainLargest = 1e5;

// Continues after a value that is not plain; the caller discards the query then.
class PlainReader {
public:
    bool is_plain() const { return is_plain_; }

    void require(bool holds) { is_plain_ = is_plain_ && holds; }

    // The members with these names, null if absent. Other members, and duplicates, are not plain.
    template <std::size_t Count>
    std::array<const Value*, Count> members(const Value& object, const std::string_view (&names)[Count]) {
        std::array<const Value*, Count> found{};
        require(object.IsObject());
        if (!object.IsObject()) return found;
        for (const Value::Member& member : object.GetObject()) {
            const std::string_view name(member.name.GetString(), member.name.GetStringLength());
            std::size_t slot = 0;
            while (slot < Count && names[slot] != name) ++slot;
            require(slot < Count && !found[slot]);
            if (!is_plain_) return {};
            found[slot] = &member.value;
        }
        return found;
    }

    // rapidjson keeps numbers as text, because its exact conversion is undefined for 0e72; a value after a quote is a
    // string. Negative zero is not plain: the strict reader keeps it in poses only.
    double number(const Value& value) {
        double number = NAN;
        if (value.IsString() && value.GetString()[-1] != '"')
            std::from_chars(value.GetString(), value.GetString() + value.GetStringLength(), number);
        const bool is_usual = std::abs(number) <= kPlainLargest && !(number == 0.0 && std::signbit(number));
        require(is_usual);
        return is_usual ? number : 0.0;
    }

    DVec2 pair(const Value& value) {
        const bool is_pair = value.IsArray() && value.Size() == 2;
        require(is_pair);
        return is_pair ? DVec2{number(value[0]), number(value[1])} : DVec2{};
    }

    double required_number(const Value* value) {
        require(value);
        return value ? number(*value) : 0.0;
    }
    DVec2 required_pair(const Value* value) {
        require(value);
        return value ? pair(*value) : DVec2{};
    }
    double optional_number(const Value* value) { return value ? number(*value) : 0.0; }
    DVec2 optional_pair(const Value* value) { return value ? pair(*value) : DVec2{}; }

    double radius(double read) {
        require(read >= 0.0);
        return read;
    }

private:
    bool is_plain_ = true;
};

CircleGeometry read_circle(PlainReader& reader, const Value& value) {
    const auto [radius, center] = reader.members(value, {"radius", "center"});
    return {reader.radius(reader.required_number(radius)), reader.optional_pair(center)};
}

CapsuleGeometry read_capsule(PlainReader& reader, const Value& value) {
    const auto [from, to, radius] = reader.members(value, {"from", "to", "radius"});
    return {reader.required_pair(from), reader.required_pair(to), reader.radius(reader.required_number(radius))};
}

BoxGeometry read_box(PlainReader& reader, const Value& value) {
    const auto [size, radius, center, angle] = reader.members(value, {"size", "radius", "center", "angle"});
    const BoxGeometry box{reader.required_pair(size), reader.radius(reader.optional_number(radius)),
                          reader.optional_pair(center), reader.optional_number(angle)};
    reader.require(box.size.x > 0.0 && box.size.y > 0.0);
    return box;
}

PolygonGeometry read_polygon(PlainReader& reader, const Value& value) {
    const auto [vertices, radius] = reader.members(value, {"vertices", "radius"});
    PolygonGeometry polygon{{}, reader.radius(reader.optional_number(radius))};
    const bool is_list = vertices && vertices->IsArray() && vertices->Size() >= 3 &&
                         vertices->Size() <= static_cast<rapidjson::SizeType>(Shape::kMaxVertices);
    reader.require(is_list);
    if (!is_list) return polygon;
    polygon.vertices.reserve(vertices->Size());
    for (const Value& vertex : vertices->GetArray()) polygon.vertices.push_back(reader.pair(vertex));
    return polygon;
}

SegmentGeometry read_segment(PlainReader& reader, const Value& value) {
    const auto [from, to] = reader.members(value, {"from", "to"});
    return {reader.required_pair(from), reader.required_pair(to)};
}

// An object with one key, the kind of the shape.
ShapeGeometry read_geometry(PlainReader& reader, const Value& shape) {
    const auto [circle, capsule, box, polygon, segment] =
        reader.members(shape, {"circle", "capsule", "box", "polygon", "segment"});
    reader.require(shape.IsObject() && shape.MemberCount() == 1);
    if (!reader.is_plain()) return CircleGeometry{};
    if (circle) return read_circle(reader, *circle);
    if (capsule) return read_capsule(reader, *capsule);
    if (box) return read_box(reader, *box);
    if (polygon) return read_polygon(reader, *polygon);
    return read_segment(reader, *segment);
}

Pose read_pose(PlainReader& reader, const Value* pose) {
    if (!pose) return {};
    const auto [position, angle, rotation] = reader.members(*pose, {"position", "angle", "rotation"});
    reader.require(!(angle && rotation));
    Pose read{reader.optional_pair(position), {}};
    if (angle) read.rotation = make_rotation_degrees(reader.number(*angle));
    if (rotation) {
        const DVec2 cosine_sine = reader.pair(*rotation);
        reader.require(is_cosine_and_sine(cosine_sine));
        read.rotation = {static_cast<float>(cosine_sine.x), static_cast<float>(cosine_sine.y)};
    }
    return read;
}

std::optional<DistanceQuery> read_query(const Value& line) {
    PlainReader reader;
    const auto [a, b, a_pose, b_pose] = reader.members(line, {"a", "b", "a_pose", "b_pose"});
    reader.require(a && b);
    if (!reader.is_plain()) return std::nullopt;
    const ShapeGeometry geometry_a = read_geometry(reader, *a), geometry_b = read_geometry(reader, *b);
    const Pose pose_a = read_pose(reader, a_pose), pose_b = read_pose(reader, b_pose);
    if (!reader.is_plain()) return std::nullopt;
    try {
        std::vector<Shape> shape_a = make_exact_shapes(geometry_a), shape_b = make_exact_shapes(geometry_b);
        return DistanceQuery{std::move(shape_a.front()), std::move(shape_b.front()), pose_a, pose_b};
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<DistanceQuery> read_plain_query(std::string_view line) {
    using Pool = rapidjson::MemoryPoolAllocator<>;
    using Document = rapidjson::GenericDocument<rapidjson::UTF8<>, Pool, Pool>;
    constexpr std::size_t kStackBytes = 1024;
    // rapidjson ends at a null character, and the strict reader does not resolve escapes in keys.
    if (line.find('\0') != std::string_view::npos || line.find('\\') != std::string_view::npos) return std::nullopt;
    std::string text(line);                                    // parsed in place
    alignas(std::max_align_t) char values[4096], stack[4096];  // enough for most lines
    Pool value_pool(values, sizeof values), stack_pool(stack, sizeof stack);
    Document document(&value_pool, kStackBytes, &stack_pool);
    document.ParseInsitu<rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseIterativeFlag>(text.data());
    if (document.HasParseError()) return std::nullopt;
    return read_query(document);
}

}  // namespace tumble::tools
