// Replays: how states are packed, and that a page contains nothing but them.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hand_made_scene.hpp"
#include "render/output/base64.hpp"
#include "render/replay/bytes.hpp"
#include "render/replay/contact_tracks.hpp"
#include "render/replay/pose_track.hpp"
#include "render/replay/replay_page.hpp"
#include "support/near.hpp"
#include "tumble/recording.hpp"

using namespace tumble;
using tumble::test::absolute;
using tumble::test::near;

namespace {

// Reads varints as the page does: sums of seven bits, not shifts.
struct Reader {
    const std::string& bytes;
    std::size_t at = 0;

    std::int64_t varint() {
        std::int64_t value = 0, weight = 1;
        for (;; weight *= 128) {
            const int byte = static_cast<unsigned char>(bytes.at(at++));
            value += (byte % 128) * weight;
            if (byte < 128) return value;
        }
    }
    std::int64_t integer() {
        const std::int64_t bits = varint();
        return bits % 2 == 0 ? bits / 2 : -(bits + 1) / 2;
    }
    std::vector<std::int64_t> predicted(std::size_t count) {
        std::vector<std::int64_t> values;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t last = i > 0 ? values[i - 1] : 0, before = i > 1 ? values[i - 2] : 0;
            values.push_back(integer() + 2 * last - before);
        }
        return values;
    }
};

// A body that flies, bounces and spins by up to 1/8 turn a step.
std::vector<Pose> wild_poses(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    std::vector<Pose> poses;
    DVec2 at{1234.5678, -7.0}, step;
    double turned = 3.0;
    for (std::size_t i = 0; i < count; ++i) {
        poses.push_back({at, make_rotation(turned)});
        if (i % 40 == 0) step = {share(random), share(random)};
        step.y -= 0.0028;
        at = at + step;
        turned += 0.7 * share(random);
    }
    return poses;
}

}  // namespace

TEST_CASE("varints have seven bits a byte, and signs alternate") {
    std::string bytes;
    for (const std::int64_t value : {0, -1, 1, 63, -64, 64, 1000000}) render::append_signed(bytes, value);
    // 64 is 128 = 0 + 1 x 128; 1 000 000 is 2 000 000 = 0 + 9 x 128 + 122 x 128^2.
    CHECK(bytes == std::string("\x00\x01\x02\x7e\x7f\x80\x01\x80\x89\x7a", 10));
    Reader reader{bytes};
    for (const std::int64_t value : {0, -1, 1, 63, -64, 64, 1000000}) CHECK(reader.integer() == value);
}

TEST_CASE("base64 is that of RFC 4648") {
    CHECK(render::base64("") == "");
    CHECK(render::base64("f") == "Zg==");
    CHECK(render::base64("fo") == "Zm8=");
    CHECK(render::base64("foo") == "Zm9v");
    CHECK(render::base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("packed poses are within half a quantum, at the end as at the start") {
    const double quantum = render::position_quantum(1.0);
    CHECK(near(quantum, 1e-3, absolute(0.0)));
    const std::vector<Pose> poses = wild_poses(2000);
    render::PoseTrack track(poses.front(), quantum);
    for (const Pose& pose : poses) track.append(pose);
    REQUIRE(track.count() == poses.size());
    const auto [x_bytes, y_bytes, angle_bytes] = track.sequences();
    const std::string bytes = std::string(x_bytes) + std::string(y_bytes) + std::string(angle_bytes);
    Reader reader{bytes};
    const auto x = reader.predicted(poses.size()), y = reader.predicted(poses.size()),
               turned = reader.predicted(poses.size());
    CHECK(reader.at == bytes.size());
    const double rounding = 1e-9;  // m, of the division by the quantum
    for (std::size_t i = 0; i < poses.size(); ++i) {
        CAPTURE(i);
        const DVec2 at = track.base() + quantum * DVec2(static_cast<double>(x[i]), static_cast<double>(y[i]));
        CHECK(near(at.x, poses[i].position.x, absolute(0.5 * quantum + rounding)));
        CHECK(near(at.y, poses[i].position.y, absolute(0.5 * quantum + rounding)));
        const double turn = static_cast<double>(turned[i]) / render::kAnglesPerTurn;
        const double apart = std::remainder(turn - angle(poses[i].rotation) / (2.0 * kPi), 1.0);
        CHECK(near(apart, 0.0, absolute(0.5 / render::kAnglesPerTurn + 1e-7)));
        // Angles go on over a turn: two steps are never more than half a turn apart.
        if (i > 0) CHECK(std::abs(turned[i] - turned[i - 1]) <= render::kAnglesPerTurn / 2);
    }
}

TEST_CASE("marbles have finer quanta, boulders do not have coarser ones") {
    CHECK(near(render::position_quantum(0.02), 2e-5, absolute(1e-12)));
    CHECK(near(render::position_quantum(50.0), 1e-3, absolute(0.0)));
}

TEST_CASE("a body at rest costs a byte a step and coordinate before compression") {
    render::PoseTrack track({{3.0, 4.0}, make_rotation(1.0)}, 1e-3);
    for (int i = 0; i < 1000; ++i) track.append({{3.0, 4.0}, make_rotation(1.0)});
    for (const std::string_view bytes : track.sequences()) CHECK(bytes.size() <= 1000 + 4);
}

TEST_CASE("impulses have levels on a logarithmic scale") {
    CHECK(render::impulse_level(0.0) == 0.0);
    CHECK(render::impulse_level(-1.0) == 0.0);
    const double one = render::impulse_level(1.0);
    CHECK(near(one, 1.0 + 2.0 * 19.931569, absolute(1e-4)));  // log2(10^6)
    CHECK(near(render::impulse_level(2.0), one + 2.0, absolute(1e-9)));
}

TEST_CASE("a value keeps its integer until it is three quarters off") {
    CHECK(render::steady(4.7, 4) == 4);
    CHECK(render::steady(3.3, 4) == 4);
    CHECK(render::steady(4.8, 4) == 5);
    CHECK(render::steady(-7.6, 4) == -8);
    CHECK(render::steady(0.0, 1) == 0);  // no impulse is no impulse
    CHECK(render::steady(1e300, 0) == 1 << 30);
}

TEST_CASE("a contact is one track in the coordinates of its body A") {
    World world({.sleeping = false});
    const BodyId floor = world.create_body({.type = BodyType::static_body, .pose = {{0.0, -1.0}, {}}});
    world.add_shape(floor, {.shape = make_box({10.0f, 2.0f})});
    const BodyId ball = world.create_body({.pose = {{2.0, 0.5}, {}}});
    world.add_shape(ball, {.shape = make_circle(0.5f)});
    render::ContactTracks tracks(1e-3);
    const render::BodyNumbers numbers{{floor, 7}, {ball, 9}};
    const auto record = [&] { tracks.record(world, world.contacts(), numbers); };
    record();
    const int steps = 20;
    for (int i = 0; i < steps; ++i) {
        world.step();
        record();
    }
    const std::string bytes = tracks.bytes();
    Reader reader{bytes};
    CHECK(reader.varint() == 1);  // tracks
    CHECK(reader.varint() == 1);  // first step
    CHECK(reader.varint() == steps);
    CHECK(reader.varint() == 7);
    CHECK(reader.varint() == 9);
    CHECK(reader.integer() == 200);  // 2 m in parts of 10 mm
    for (int i = 1; i < steps; ++i) CHECK(reader.integer() == 0);
    CHECK(std::abs(reader.integer() - 100) <= 1);  // the floor is 1 m high above its middle
    for (int i = 1; i < steps; ++i) CHECK(std::abs(reader.integer()) <= 1);
    CHECK(reader.integer() == render::kNormalsPerTurn / 4);  // up
    for (int i = 1; i < steps; ++i) CHECK(reader.integer() == 0);
    std::int64_t impulse = 0;
    for (int i = 0; i < steps; ++i) impulse += reader.integer();
    CHECK(reader.at == bytes.size());
    // Weight times the duration of a step: pi / 4 kg x 10 m/s^2 / 60 Hz = 0.1309 N s, log2(130900) = 16.998.
    CHECK(std::abs(impulse - (1 + 34)) <= 1);
}

TEST_CASE("a page is the same for the same run, and no name of the scene is markup in it") {
    const std::string name = "</script><script>alert(1)</script>";
    const auto page = [&name] {
        HandMadeScene made;
        made.scene.name = name;
        made.add_dynamic(name, {0.0, 1.0}, make_circle(0.5f));
        made.add_dynamic("\xff is not UTF-8", {3.0, 1.0}, make_circle(0.5f));
        ReplayRecorder recorder(made.scene, {});
        recorder.record(made.built, {});
        made.built.world.step();
        recorder.record(made.built, {});
        CHECK(recorder.is_whole());
        const ReplayClaim claim{{.claim = name, .finding = name, .step = 1}};
        return recorder.page(std::vector{claim}, true);
    };
    const std::string text = page();
    CHECK(text == page());
    CHECK(text.starts_with("<!doctype html>"));
    CHECK(text.ends_with("</html>\n"));
    CHECK(text.find("alert") == std::string::npos);
    CHECK(text.find("http:") == std::string::npos);
    CHECK(text.find("https:") == std::string::npos);
}
