// Newton's cradle: balls that touch, on rods. As many swing out as swing in.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

constexpr int kBalls = 5;
constexpr double kRod = 4.0, kHigh = 6.0;  // m: the length of a rod, the height of its upper end
constexpr double kLift = 0.5;              // rad: the angle from which balls swing in
constexpr double kStepsPerSecond = 240.0;

// Balls of 1 m diameter, the first `lifted` of them turned about the upper ends of their rods.
Scene cradle(int lifted) {
    std::string bodies = R"({"name": "beam", "type": "static", "position": [0, 6]})", joints;
    for (int i = 0; i < kBalls; ++i) {
        const double x = i - 2.0, angle = i < lifted ? kLift : 0.0;
        bodies += R"(, {"name": "ball)" + std::to_string(i) + R"(", "position": [)" +
                  std::to_string(x - kRod * std::sin(angle)) + ", " + std::to_string(kHigh - kRod * std::cos(angle)) +
                  R"(], "shapes": [{"circle": {"radius": 0.5}, "material": "steel"}]})";
        joints += std::string(i == 0 ? "" : ", ") + R"({"type": "distance", "bodies": ["beam", "ball)" +
                  std::to_string(i) + R"("], "anchors": [[)" + std::to_string(x) + R"(, 0], [0, 0]], "length": 4})";
    }
    return parse_scene(R"({"format": 1, "world": {"steps_per_second": 240, "duration": 3},
        "materials": {"steel": {"density": 7.8, "friction": 0, "restitution": 1}},
        "bodies": [)" + bodies +
                           R"(], "joints": [)" + joints + "]}",
                       "cradle.json");
}

// How high each ball has risen above its lowest position, at the highest in the quarter of a swing after the hit.
std::vector<double> rises(const Scene& scene) {
    // The period of a pendulum of this length and amplitude a is 2 pi sqrt(l / g) (1 + a^2 / 16 + ...).
    const double period = 2.0 * 3.14159265358979 * std::sqrt(kRod / 10.0) * (1.0 + kLift * kLift / 16.0);
    SceneRun run(scene);
    const auto step_at = [](double time) { return static_cast<std::uint64_t>(time * kStepsPerSecond); };
    std::vector<double> highest(kBalls);
    while (run.world().step_count() < step_at(0.55 * period)) {
        run.step();
        if (run.world().step_count() < step_at(0.3 * period)) continue;
        for (std::size_t i = 0; i < kBalls; ++i)
            highest[i] = std::max(highest[i], run.world().state(run.built().bodies[1 + i].id).pose.position.y - 2.0);
    }
    return highest;
}

}  // namespace

TEST_CASE("as many balls of a cradle swing out as swing in, and the others stay") {
    const double lift = kRod * (1.0 - std::cos(kLift));
    for (int lifted = 1; lifted <= 3; ++lifted) {
        CAPTURE(lifted);
        const std::vector<double> rise = rises(cradle(lifted));
        for (int i = 0; i < kBalls; ++i) {
            CAPTURE(i);
            // Those that swing out take the energy over: they reach the height of those that swung in.
            const bool is_out = i >= kBalls - lifted;
            CHECK(rise[static_cast<std::size_t>(i)] >= (is_out ? 0.97 * lift : 0.0));
            CHECK(rise[static_cast<std::size_t>(i)] <= (is_out ? 1.01 * lift : 0.01 * lift));
        }
    }
}
