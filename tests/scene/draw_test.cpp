// Numbers that are declared as random: what they depend on, their distributions, their errors, and how they are
// written.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/format/draw.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;

namespace {

Scene read(const std::string& bodies, std::uint64_t seed = 1) {
    LoadOptions options;
    options.seed = seed;
    return parse_scene(R"({"format": 1, "bodies": [)" + bodies + "]}", "scene.json", options);
}

constexpr const char* kBall = R"({"name": "ball", "position": [{"uniform": [1, 2]}, {"uniform": [1, 2]}]})";

double draw(const char* declaration, std::uint64_t number, bool whole = false) {
    return scene::draw_number(scene::Json::parse(declaration), "/" + std::to_string(number), 7, whole,
                              [](double) { return true; });
}

std::string message_of(const std::string& body) {
    try {
        read(body);
    } catch (const SceneError& error) {
        return error.diagnostics[0].pointer + ": " + error.diagnostics[0].message;
    }
    return "";
}

}  // namespace

TEST_CASE("a draw depends on the seed, the names and the keys, and on nothing else") {
    const DVec2 alone = read(kBall).bodies[0].position;
    CHECK(alone.x != alone.y);
    CHECK(read(kBall).bodies[0].position == alone);
    CHECK(read(kBall, 2).bodies[0].position.x != alone.x);
    const Scene more = read(R"({"name": "new", "angle": {"uniform": [0, 9]}}, )" + std::string(kBall));
    CHECK(more.bodies[1].position == alone);
    REQUIRE(more.draws.size() == 3);
    CHECK(more.draws[1].pointer == "/bodies/1/position/0");
    CHECK(more.draws[1].key == "/bodies/ball/position/0");
    CHECK(more.draws[1].value == alone.x);
    // The seed of the file counts if no other is given.
    const std::string bodies = R"("bodies": [)" + std::string(kBall) + "]}";
    CHECK(parse_scene(R"({"format": 1, "world": {"seed": 2}, )" + bodies, "s").bodies[0].position ==
          read(kBall, 2).bodies[0].position);
    CHECK(scene_hash(read(kBall)) == scene_hash(read(kBall)));
    CHECK(scene_hash(read(kBall)) != scene_hash(read(kBall, 2)));
}

TEST_CASE("draws have their distributions") {
    constexpr int kCount = 100000;
    double mean = 0.0, square = 0.0, fourth = 0.0, uniform = 0.0;
    int within_one = 0, ones = 0, whole_twos = 0;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        const double z = draw(R"({"normal": [0, 1]})", i);
        mean += z / kCount;
        square += z * z / kCount;
        fourth += z * z * z * z / kCount;
        within_one += std::abs(z) < 1.0;
        const double u = draw(R"({"uniform": [3, 5]})", i);
        CHECK((u >= 3.0 && u <= 5.0));
        uniform += u / kCount;
        ones += draw(R"({"choice": [1, 8]})", i) == 1.0;
        const double whole = draw(R"({"uniform": [1, 4]})", i, true);
        CHECK((whole == 1.0 || whole == 2.0 || whole == 3.0 || whole == 4.0));
        whole_twos += whole == 2.0;
    }
    // Five standard errors: 1, sqrt(2) and sqrt(96) over sqrt(n), and sqrt(p (1 - p) / n) of the counts.
    const double root = std::sqrt(double{kCount});
    CHECK(std::abs(mean) < 5.0 / root);
    CHECK(std::abs(square - 1.0) < 5.0 * 1.42 / root);
    CHECK(std::abs(fourth - 3.0) < 5.0 * 9.8 / root);
    CHECK(std::abs(within_one / double{kCount} - 0.682689) < 5.0 * 0.466 / root);
    CHECK(std::abs(uniform - 4.0) < 5.0 * 0.578 / root);
    CHECK(std::abs(ones / double{kCount} - 0.5) < 5.0 * 0.5 / root);
    CHECK(std::abs(whole_twos / double{kCount} - 0.25) < 5.0 * 0.434 / root);
}

TEST_CASE("a normal draw stays in the range of its key") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Scene scene = read(R"({"shapes": [{"circle": {"radius": {"normal": [0.1, 1]}}}]})", seed);
        CHECK(std::get<CircleGeometry>(scene.bodies[0].shapes[0].geometry).radius > 0.0);
    }
}

TEST_CASE("a wrong declaration is an error at its place") {
    CHECK(message_of(R"({"angle": {"uniform": [2, 1]}})") ==
          "/bodies/0/angle/uniform: must be [lower, upper] with lower <= upper");
    CHECK(message_of(R"({"angle": {"uniform": [1]}})") == "/bodies/0/angle/uniform: must be an array of 2 numbers");
    CHECK(message_of(R"({"angle": {"choice": []}})") ==
          "/bodies/0/angle/choice: must be an array of 1 to 1000 numbers");
    CHECK(message_of(R"({"angle": {"choice": ["a"]}})") == "/bodies/0/angle/choice: must contain numbers only");
    CHECK(message_of(R"({"angle": {"normal": [0, -1]}})").starts_with("/bodies/0/angle/normal: must be [mean"));
    CHECK(message_of(R"({"angle": {"gauss": [0, 1]}})").starts_with("/bodies/0/angle: must be a number, or one of"));
    CHECK(message_of(R"({"linear_damping": {"uniform": [-1, 1]}})") ==
          "/bodies/0/linear_damping/uniform: leaves the range of this key");
    CHECK(message_of(R"({"linear_damping": {"normal": [-1000, 1]}})")
              .starts_with("/bodies/0/linear_damping/normal: hardly"));
    CHECK(message_of(R"({"repeat": {"grid": {"columns": {"uniform": [1, 2.5]}}}})") ==
          "/bodies/0/repeat/grid/columns/uniform: must contain whole numbers only");
    CHECK(message_of(R"({"repeat": {"grid": {"columns": {"normal": [3, 1]}}}})")
              .starts_with("/bodies/0/repeat/grid/columns/normal"));
}

TEST_CASE("declarations are written as they were read, also where the number is the default") {
    const std::string text = R"({"format": 1, "materials": {"m": {"friction": {"uniform": [0.1, 0.9]}}}, "bodies": [
        {"name": "a", "position": [{"choice": [0]}, 0], "angle": {"choice": [0]},
         "repeat": {"grid": {"columns": {"uniform": [2, 5]}}}, "shapes": [{"circle": {"radius": {"normal": [1, 0.1]}}}]}]})";
    Scene scene = parse_scene(text, "scene.json");
    const std::string written = to_json(scene);
    CHECK(scene::Json::parse(written) == scene::Json::parse(text));
    CHECK(to_json(parse_scene(written, "again.json")) == written);
    CHECK(scene_hash(parse_scene(written, "again.json")) == scene_hash(scene));
    // A number that a program has changed is written as it is.
    scene.bodies[0].angle = 5.0;
    CHECK(scene::Json::parse(to_json(scene))["bodies"][0]["angle"] == 5);
}

TEST_CASE("each place of an included file has numbers of its own, and the seed is that of the including file") {
    LoadOptions options;
    options.read_included = [](const std::filesystem::path&) {
        return R"({"format": 1, "world": {"seed": 99}, "bodies": [{"name": "a", "angle": {"uniform": [0, 1]}}]})";
    };
    const auto load = [&](const char* more) {
        return parse_scene(std::string(R"({"format": 1, )") + more + R"("include": [{"file": "p", "prefix": "1/"},
            {"file": "p", "prefix": "2/"}]})",
                           "scene.json", options);
    };
    const Scene scene = load("");
    REQUIRE(scene.bodies.size() == 2);
    CHECK(scene.bodies[0].angle != scene.bodies[1].angle);
    CHECK(load("").bodies[1].angle == scene.bodies[1].angle);
    CHECK(load(R"("world": {"seed": 5}, )").bodies[0].angle != scene.bodies[0].angle);
    options.keep_includes = true;
    CHECK(load("").draws.empty());
}
