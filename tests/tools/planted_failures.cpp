#include "planted_failures.hpp"

#include <random>

namespace tumble::test {

namespace {

using nlohmann::json;

// Bodies without gravity, so that removing others leaves them where they are.
std::string floating(const std::string& name, const std::string& place, const std::string& more = "",
                     const std::string& shape = R"({"circle": {"radius": 0.5}})") {
    return R"({"name": ")" + name + R"(", "gravity_scale": 0, "position": )" + place + more + R"(, "shapes": [)" +
           shape + "]}";
}
std::string fixed(const std::string& name, const std::string& place, const std::string& more = "",
                  const std::string& shape = R"({"box": {"size": [4, 0.5]}})") {
    return R"({"name": ")" + name + R"(", "type": "static", "position": )" + place + more + R"(, "shapes": [)" + shape +
           "]}";
}
std::string hammer(const std::string& place, const std::string& velocity) {
    return R"({"name": "hammer", "type": "kinematic", "position": )" + place + R"(, "velocity": )" + velocity +
           R"(, "shapes": [{"circle": {"radius": 0.5}}]})";
}
std::string falling(const std::string& name, const std::string& place) {
    return R"({"name": ")" + name + R"(", "position": )" + place + R"(, "shapes": [{"circle": {"radius": 0.5}}]})";
}

std::vector<PlantedFailure> failures_of_claims() {
    const std::string hit = hammer("[-3.217, 0.1234]", "[9.871, 0]");
    const std::string kick = R"({"at": 0.2171, "body": "a", "impulse": [7.53, 0]})";
    return {
        {"inside",
         {falling("ball", "[0.0123, 5]"), fixed("ramp", "[0, 2]", R"(, "angle": -41.7)")},
         {},
         {},
         R"({"body": "ball", "inside": [[-0.5, -100], [0.5, 10]]})"},
        {"outside",
         {falling("ball", "[0, 3.1417]"), fixed("shelf", "[0, 0.1]")},
         {},
         {},
         R"({"body": "ball", "outside": [[-1, 0], [1, 2]]})"},
        {"touches",
         {falling("ball", "[0, 4.3]"), fixed("shelf", "[0, 2.117]"), fixed("target", "[0, 0]")},
         {},
         {},
         R"({"body": "ball", "touches": "target"})",
         "check",
         false,
         3},
        {"never_touches",
         {floating("a", "[0.017, 0]"), floating("b", "[3.2171, 0]")},
         {},
         {kick},
         R"({"body": "a", "never_touches": "b"})"},
        {"broken joint",
         {fixed("hook", "[0, 3]"), falling("weight", "[0, 0.7171]")},
         {R"({"type": "distance", "name": "rope", "bodies": ["hook", "weight"], "anchors": [[0, 0], [0, 0]], "break_force": 1.234})"},
         {},
         R"({"body": "weight", "event": "joint_broke", "event_count": [0, 0]})"},
        {"overlap",
         {floating("p", "[0.1717, 0]"), floating("q", "[0.6123, 0.1]")},
         {},
         {},
         R"({"max_penetration": 0.1})"},
        {"joint error",
         {fixed("frame", "[0, 0]"), falling("door", "[2.717, 0]")},
         {R"({"type": "revolute", "name": "hinge", "bodies": ["frame", "door"], "anchors": [[0, 0], [0.123, 0]]})"},
         {},
         R"({"joint": "hinge", "max_joint_error": 0.5})"},
        {"height",
         {falling("rider", "[0, 1.0171]"), hammer("[0.0171, -0.2]", "[0, 6.171]")},
         {},
         {},
         R"({"body": "rider", "height": [-100, 3], "when": "always"})"},
        {"speed", {floating("ball", "[0, 0]"), hit}, {}, {}, R"({"body": "ball", "speed": [0, 5], "when": "always"})"},
        {"angle",
         {floating("plank", "[0, 0.7]", "", R"({"box": {"size": [0.5, 2.123]}})"), hit},
         {},
         {},
         R"({"body": "plank", "angle": [-5, 5], "when": "always"})"},
        {"count",
         {floating("ball", "[0, 0]"), hit},
         {},
         {},
         R"({"body": "ball", "count": [0, 0], "region": [[2, -9], [99, 9]], "when": "always"})"},
        {"rest",
         {floating("spinner", "[0.717, 0]", R"(, "angular_velocity": 3333.3)")},
         {},
         {},
         R"({"at_rest_by": 1})"},
        {"expression",
         {floating("a", "[0, 0]"), floating("b", "[4.171, 3]"), hit},
         {},
         {},
         R"({"that": "a.x < b.x", "when": "always"})",
         "check",
         false,
         3},
        {"order",
         {floating("a", "[0, 0]"), floating("b", "[0, 2.0171]"), hit},
         {},
         {R"({"at": 0.7171, "body": "b", "velocity": [5, 0]})"},
         R"({"that": "b.x > 1", "before": "a.x > 1"})",
         "check",
         false,
         3},
        {"sensor",
         {falling("ball", "[0.01, 4.171]"),
          fixed("probe", "[0, 0]", "", R"({"box": {"size": [1, 1]}, "sensor": true})")},
         {},
         {},
         R"({"body": "probe", "event": "sensor_begin", "event_count": [0, 0]})"},
        {"spawned body",
         {fixed("plate", "[0, 0]")},
         {},
         {R"({"at": 0.3171, "spawn": )" + falling("drop", "[0.171, 2.3]") + "}"},
         R"({"body": "drop", "never_touches": "plate"})",
         "check",
         false,
         1},
    };
}

std::vector<PlantedFailure> failures_of_runs() {
    const std::string mote = floating("mote", "[0, 0]", R"(, "mass": {"mass": 1e-30, "inertia": 0})");
    const auto both = [](const std::string& a, const std::string& b, const std::string& then,
                         const std::string& else_ = ":") {
        return "if grep -q '\"" + a + "\"' {} && grep -q '\"" + b + "\"' {}; then " + then + "; else " + else_ + "; fi";
    };
    return {
        {"divergence",
         {mote, hammer("[-3.171, 0]", "[10.171, 0]")},
         {},
         {R"_({"when": "touching(mote, hammer)", "body": "mote", "impulse": [1e12, 0]})_"},
         ""},
        // Without one of the two it fails differently, which must not count.
        {"exit code",
         {falling("red", "[0, 1.7171]"), falling("blue", "[3.171, 1]")},
         {},
         {},
         "",
         both("red", "blue", "exit 3", "exit 4")},
        {"signal",
         {falling("red", "[0, 1.7171]"), fixed("nail", "[0, 4]")},
         {R"({"type": "revolute", "name": "pin", "bodies": ["red", "nail"], "anchor": [0, 4.1]})"},
         {},
         "",
         both("pin", "format", "kill -SEGV $$")},
        {"first line of standard error",
         {falling("red", "[0, 1.7171]")},
         {},
         {R"({"at": 0.1, "body": "red", "impulse": [1.717, 0]})"},
         "",
         both("red", "impulse", "echo assertion of {} >&2; exit 1", "echo another >&2; exit 1"),
         true,
         1},
    };
}

std::vector<PlantedFailure> all() {
    std::vector<PlantedFailure> failures = failures_of_claims();
    for (PlantedFailure& failure : failures_of_runs()) failures.push_back(std::move(failure));
    return failures;
}

// A pile of boxes and circles on a floor, in the region x > 30, of which some hang on others.
json clutter(int count) {
    std::mt19937 random(5);
    const auto fraction = [&] { return static_cast<double>(random() % 10000) / 10000.0; };
    json scene = {{"format", 1}, {"name", "planted"}, {"world", {{"duration", 1.5}}}};
    scene["materials"] = {{"wood", {{"density", 0.7}, {"color", "#c98d4b"}}}, {"ice", {{"friction", 0.02}}}};
    scene["bodies"] = json::array({{{"name", "floor"},
                                    {"type", "static"},
                                    {"position", {80, -1}},
                                    {"shapes", json::array({{{"box", {{"size", {90, 1}}}}}})}}});
    scene["joints"] = json::array();
    for (int i = 1; i < count; ++i) {
        const json box = {{"box", {{"size", {1.0 + fraction(), 1.0 + fraction()}}}}, {"material", "wood"}};
        const json circle = {{"circle", {{"radius", 0.4 + 0.2 * fraction()}}}, {"material", "ice"}};
        scene["bodies"].push_back({{"name", "n" + std::to_string(i)},
                                   {"position", {40 + 3 * (i % 24) + fraction(), 0.6 + 2.5 * (i / 24)}},
                                   {"shapes", json::array({i % 2 == 0 ? box : circle})}});
        if (i % 24 > 1 && i % 3 == 0)
            scene["joints"].push_back({{"type", "distance"},
                                       {"bodies", {"n" + std::to_string(i), "n" + std::to_string(i - 1)}},
                                       {"anchors", {{0, 0}, {0, 0}}}});
    }
    scene["timeline"] = json::array({{{"at", 0.3}, {"body", "n5"}, {"impulse", {1, 2}}},
                                     {{"every", 0.5}, {"body", "n12"}, {"angular_impulse", 0.3}},
                                     {{"at", 0.4}, {"despawn", "n7"}}});
    scene["expect"] =
        json::array({{{"body", "n5"}, {"inside", {{0, -50}, {500, 50}}}}, {{"body", "n9"}, {"never_touches", "n22"}}});
    return scene;
}

// Inserts each element at a place that depends on its text.
void plant(json& list, const std::vector<std::string>& elements) {
    for (const std::string& element : elements) {
        std::uint32_t place = 17;
        for (const char c : element) place = place * 31 + static_cast<unsigned char>(c);
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(place % (list.size() + 1)), json::parse(element));
    }
}

}  // namespace

const std::vector<PlantedFailure>& planted_failures() {
    static const std::vector<PlantedFailure> failures = all();
    return failures;
}

json planted_scene(const PlantedFailure& failure, int other_bodies) {
    json scene = clutter(other_bodies);
    plant(scene["bodies"], failure.bodies);
    plant(scene["joints"], failure.joints);
    plant(scene["timeline"], failure.events);
    if (!failure.claim.empty()) plant(scene["expect"], {failure.claim});
    return scene;
}

}  // namespace tumble::test
