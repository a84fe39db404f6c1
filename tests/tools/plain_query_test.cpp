// The fast reader of query lines against the strict one: both give the same query, or the fast one leaves the line to
// the strict one.
#include "tools/query/plain_query.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "tools/output/input_error.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
using namespace tumble::tools;

namespace {

class LineSource {
public:
    explicit LineSource(unsigned seed) : random_(seed) {}

    std::string line() {
        const std::string a = shape(), b = shape(), a_pose = pose(), b_pose = pose();
        std::string text = "{\"a\": " + a + ",\t\"b\":" + b;
        if (below(4) > 0) text += ", \"a_pose\": " + a_pose;
        if (below(4) > 0) text += ", \"b_pose\" : " + b_pose;
        return text + " }" + (below(2) ? "\r" : "");
    }

private:
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

    // Integers, short decimals or all digits; sometimes with an exponent.
    std::string number(double from, double to) {
        const double value = uniform(from, to);
        std::string text;
        switch (below(4)) {
            case 0: text = std::to_string(static_cast<int>(value)); break;
            case 1: text = std::to_string(value); break;
            case 2: append_number(text, value * 1e-9); break;
            default: append_number(text, value);
        }
        return text;
    }
    std::string coordinate() { return number(-3.0, 3.0); }
    std::string length() { return number(1.0, 3.0); }
    std::string pair(const std::string& x, const std::string& y) { return "[" + x + ", " + y + "]"; }
    std::string point() {
        const std::string x = coordinate(), y = coordinate();
        return pair(x, y);
    }

    std::string cosine_and_sine() {
        const double angle = uniform(-4.0, 4.0);
        std::string x, y;
        append_number(x, std::cos(angle));
        append_number(y, std::sin(angle));
        return pair(x, y);
    }

    std::string shape() {
        switch (below(5)) {
            case 0:
                return R"({"circle": {"radius": )" + length() + (below(2) ? R"(, "center": )" + point() : "") + "}}";
            case 1: {
                const std::string from = point(), to = point();
                return R"({"capsule": {"from": )" + from + R"(, "to": )" + to + R"(, "radius": )" + length() + "}}";
            }
            case 2: {
                std::string size = length();
                size = pair(size, length());
                const std::string center = below(2) ? R"(, "center": )" + point() : "";
                const std::string angle = below(2) ? R"(, "angle": )" + number(-180.0, 180.0) : "";
                return R"({"box": {"size": )" + size + center + angle + (below(2) ? R"(, "radius": 1e-9)" : "") + "}}";
            }
            case 3: {
                std::string vertices = point();
                for (int more = 2 + below(10); more > 0; --more) vertices += "," + point();
                return R"({"polygon": {"vertices": [)" + vertices + "]" +
                       (below(2) ? R"(, "radius": )" + length() : "") + "}}";
            }
            default: {
                const std::string from = point(), to = point();
                return R"({"segment": {"to": )" + to + R"(, "from": )" + from + "}}";
            }
        }
    }

    std::string pose() {
        const std::string position = R"({"position": )" + point();
        switch (below(4)) {
            case 0: return position + "}";
            case 1: return position + R"(, "angle": )" + std::to_string(90 * (below(9) - 4)) + "}";
            case 2: return position + R"(, "rotation": )" + cosine_and_sine() + "}";
            default: return position + R"(, "angle": )" + number(-400.0, 400.0) + "}";
        }
    }

    std::mt19937_64 random_;
};

template <class Number>
auto bits(Number number) {
    if constexpr (sizeof number == 4)
        return std::bit_cast<std::uint32_t>(number);
    else
        return std::bit_cast<std::uint64_t>(number);
}

bool same_bits(const Pose& a, const Pose& b) {
    return bits(a.position.x) == bits(b.position.x) && bits(a.position.y) == bits(b.position.y) &&
           bits(a.rotation.c) == bits(b.rotation.c) && bits(a.rotation.s) == bits(b.rotation.s);
}

bool same_bits(const Shape& a, const Shape& b) {
    if (a.vertex_count() != b.vertex_count() || bits(a.radius()) != bits(b.radius())) return false;
    for (int i = 0; i < a.vertex_count(); ++i)
        if (bits(a.vertex(i).x) != bits(b.vertex(i).x) || bits(a.vertex(i).y) != bits(b.vertex(i).y)) return false;
    return true;
}

bool is_refused(const std::string& line) {
    try {
        parse_query_line(line);
        return false;
    } catch (const InputError&) {
        return true;
    } catch (const SceneError&) {
        return true;
    }
}

// The line with "?" replaced by the text.
std::string with(const std::string& text) {
    const std::string line = R"({"a": {"circle": {"radius": 1}}, "b": ?})";
    std::string result = line;
    return result.replace(result.find('?'), 1, text);
}

}  // namespace

TEST_CASE("both readers give the same query for a plain line, bit for bit") {
    LineSource source(91);
    int plain_lines = 0;
    constexpr int kLines = 3000;
    for (int i = 0; i < kLines; ++i) {
        const std::string line = source.line();
        CAPTURE(line);
        const std::optional<DistanceQuery> plain = read_plain_query(line);
        if (!plain) continue;  // degenerate: points on a line, "-0", a capsule's end on the other
        ++plain_lines;
        const DistanceQuery strict = parse_query_line_strictly(line);
        CHECK(same_bits(plain->a, strict.a));
        CHECK(same_bits(plain->b, strict.b));
        CHECK(same_bits(plain->a_pose, strict.a_pose));
        CHECK(same_bits(plain->b_pose, strict.b_pose));
    }
    CHECK(plain_lines > kLines * 7 / 10);
}

TEST_CASE("the fast reader leaves invalid lines to the strict one, which refuses them") {
    for (const char* shape : {"1",
                              "null",
                              "[]",
                              "{}",
                              R"({"disc": {"radius": 1}})",
                              R"({"circle": {}})",
                              R"({"circle": {"radius": -1}})",
                              R"({"circle": {"radius": "1"}})",
                              R"({"circle": {"radius": 1e999}})",
                              R"({"circle": {"radius": NaN}})",
                              R"({"circle": {"radius": 2e5}})",
                              R"({"circle": {"radius": 1, "radius": 2}})",
                              R"({"circle": {"radius": 1, "r": 2}})",
                              R"({"circle": {"radius": 1}, "box": {"size": [1, 1]}})",
                              R"({"circle": {"radius": 1, "center": [0, 0, 0]}})",
                              R"({"circle": {"radius": 1, "center": [0, [0]]}})",
                              R"({"box": {"size": [0, 1]}})",
                              R"({"box": {"size": [1, 1], "radius": 0.6}})",
                              R"({"polygon": {"vertices": [[0, 0], [1, 0]]}})",
                              R"({"polygon": {"vertices": [[0, 0], [1, 1], [2, 2]]}})",
                              R"({"polygon": {"vertices": [[0, 0], [1, 0], 1]}})",
                              R"({"segment": {"from": [1, 1], "to": [1, 1]}})",
                              R"({"capsule": {"from": [0, 0], "to": [1, 0]}})",
                              R"({"circle": {"radius": 1}}, "b": {"circle": {"radius": 1}})",
                              R"({"circle": {"radius": 1}}, "c": 1)",
                              R"({"circle": {"radius": 1}}, "a_pose": {"position": [0]})",
                              R"({"circle": {"radius": 1}}, "a_pose": {"x": 0})",
                              R"({"circle": {"radius": 1}}, "a_pose": {"angle": 0, "rotation": [1, 0]})",
                              R"({"circle": {"radius": 1}}, "a_pose": {"rotation": [1, 1]})",
                              R"({"circle": {"radius": 1}}, "a_pose": {"rotation": [0.7, 0.7]})",
                              R"({"circle": {"radius": 1}}} {)"}) {
        CAPTURE(shape);
        CHECK_FALSE(read_plain_query(with(shape)));
        CHECK(is_refused(with(shape)));
    }
    CHECK_FALSE(read_plain_query(""));
    CHECK_FALSE(read_plain_query(std::string(100000, '[')));
    const std::string ends_early = with(R"({"circle": {"radius": 1}})") + std::string(1, '\0') + "more";
    CHECK_FALSE(read_plain_query(ends_early));
    CHECK(is_refused(ends_early));
}

TEST_CASE("valid lines that are not plain are left to the strict reader") {
    for (const char* shape : {R"({"circle": {"radius": 1}, "custom": 3})", R"({"circle": {"radius": 1 /* metre */}})",
                              R"({"chain": {"points": [[0, 0], [1, 0]]}})"}) {
        CAPTURE(shape);
        CHECK_FALSE(read_plain_query(with(shape)));
        CHECK_FALSE(is_refused(with(shape)));
    }
    const std::string far = with(R"({"circle": {"radius": 1}}, "b_pose": {"position": [-0.0, 1e300]})");
    CHECK_FALSE(read_plain_query(far));
    CHECK(std::signbit(parse_query_line(far).b_pose.position.x));
    CHECK(parse_query_line(far).b_pose.position.y == 1e300);
}
