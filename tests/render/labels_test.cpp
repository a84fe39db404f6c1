// Labels of frames: masks agree with distances, with filled outlines and with drawn frames; the counts with the masks.
#include "tumble/recording.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "render/hand_made_scene.hpp"
#include "render/pixels.hpp"
#include "render/style/palette.hpp"
#include "render/style/style.hpp"
#include "scene/shipped.hpp"
#include "tumble/distance.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

using namespace tumble;

namespace {

constexpr int kWidth = 640, kHeight = 360;
constexpr double kLineWidth = render::style::kSegment * 0.5;  // of shapes without area, at 360 rows

BodyLabel label_at(const Mask& mask, int column, int row) {
    return mask.labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(mask.width) +
                       static_cast<std::size_t>(column)];
}

// The world point at the centre of a pixel, by the transform that the command line documents.
DVec2 world_point(const Camera& camera, double column, double row) {
    const double pixels_per_metre = kHeight / camera.height;
    return {camera.center.x + (column + 0.5 - kWidth / 2.0) / pixels_per_metre,
            camera.center.y - (row + 0.5 - kHeight / 2.0) / pixels_per_metre};
}

// The signed distance of a point from a shape (pixels), a shape without area as wide as its line.
double distance_in_pixels(const Shape& shape, const Pose& pose, DVec2 point, const Camera& camera) {
    const Shape dot = make_circle(0.0f);
    const double found = distance(shape, pose, dot, {point, {}}).distance * kHeight / camera.height;
    const bool is_line = shape.vertex_count() == 2 && shape.radius() == 0.0f;
    return is_line ? found - 0.5 * kLineWidth : found;
}

// What contains a point, or whether an edge is within a pixel of it.
struct Around {
    bool has_edge = false;
    std::set<BodyLabel> fixed, moving;  // static bodies, and all others
};

Around look_around(const SceneWorld& built, DVec2 point, const Camera& camera) {
    Around around;
    for (std::size_t i = 0; i < built.bodies.size(); ++i) {
        const BodyId body = built.bodies[i].id;
        if (!built.world.is_valid(body)) continue;
        const Pose pose = built.world.state(body).pose;
        for (const ShapeId shape : built.world.shapes(body)) {
            if (built.world.is_sensor(shape)) continue;
            // Most shapes are far away: no distance is needed for them.
            const Aabb box = bounds(built.world.shape(shape), pose);
            const double margin = 3.0 * camera.height / kHeight;  // m: an edge and half a line are within 3 pixels
            if (point.x < double{box.lower.x} - margin || point.x > double{box.upper.x} + margin ||
                point.y < double{box.lower.y} - margin || point.y > double{box.upper.y} + margin)
                continue;
            const double away = distance_in_pixels(built.world.shape(shape), pose, point, camera);
            around.has_edge |= std::abs(away) < 1.0;
            const bool is_fixed = built.world.type(body) == BodyType::static_body;
            if (away < 0.0) (is_fixed ? around.fixed : around.moving).insert(static_cast<BodyLabel>(i + 1));
        }
    }
    return around;
}

// A point inside the polygon by the crossing number.
bool contains(const std::vector<DVec2>& polygon, DVec2 point) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const DVec2 a = polygon[i], b = polygon[j];
        if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

double distance_to_outline(const std::vector<DVec2>& polygon, DVec2 point) {
    double least = 1e9;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DVec2 from = polygon[i], along = polygon[(i + 1) % polygon.size()] - from;
        const double size = length_sq(along);
        const double at = size > 0.0 ? std::clamp(dot(point - from, along) / size, 0.0, 1.0) : 0.0;
        least = std::min(least, length(point - (from + at * along)));
    }
    return least;
}

// A scene after some steps.
struct Running {
    Scene scene;
    SceneRun run;
    Camera camera;

    explicit Running(const std::filesystem::path& file, int steps)
        : scene(load_scene(file)), run(scene), camera(make_camera(run.world(), double{kWidth} / kHeight)) {
        for (int i = 0; i < steps && !run.is_stopped(); ++i) run.step();
    }
};

HandMadeScene overlapping() {
    HandMadeScene s;
    s.add_static("ground", {0.0, -2.0}, make_box({40.0f, 2.0f}));
    s.add_dynamic("disc", {0.0, 0.0}, make_circle(1.0f));
    s.add_dynamic("box", {0.5, 0.0}, make_box({2.0f, 2.0f}));
    s.add_dynamic("hidden", {0.0, 0.0}, make_box({0.2f, 0.2f}));
    return s;
}

}  // namespace

TEST_CASE("masks of the shipped scenes agree with the distances of 1000 random pixels") {
    constexpr std::size_t kMostScenes = 30;  // all would take minutes with sanitizers
    std::size_t scenes = 0, compared = 0, shown = 0, covered = 0;
    for (const std::filesystem::path& file : test::shipped_scenes()) {
        Running now(file, 40);
        now.camera.height *= 0.5;  // fewer pixels of the background
        if (now.run.world().bodies().size() > 500) continue;
        if (scenes == kMostScenes) break;
        CAPTURE(file);
        Labeller labeller(kWidth, kHeight);
        const Mask& mask = labeller.label(now.scene, now.run.built(), now.camera).mask;
        std::mt19937_64 random(scenes++);
        for (int i = 0; i < 1000; ++i) {
            const int column = static_cast<int>(random() % kWidth), row = static_cast<int>(random() % kHeight);
            CAPTURE(column);
            CAPTURE(row);
            const Around around = look_around(now.run.built(), world_point(now.camera, column, row), now.camera);
            if (around.has_edge) continue;
            ++compared;
            const std::set<BodyLabel>& possible = around.moving.empty() ? around.fixed : around.moving;
            const BodyLabel label = label_at(mask, column, row);
            if (possible.empty()) {
                REQUIRE(label == 0);
                continue;
            }
            REQUIRE(possible.count(label) == 1);
            ++shown;
            covered += around.moving.size() + around.fixed.size() > 1 ? 1u : 0u;
        }
    }
    CHECK(scenes >= 20);
    CHECK(compared > 700 * scenes);
    CHECK(shown > compared / 10);
    CHECK(shown < compared * 9 / 10);
    CHECK(covered > 0);
}

TEST_CASE("outlines filled in the order of drawing give the mask, but for pixels at their edges") {
    std::size_t equal = 0;
    for (const char* const name : {"see_saw", "mixed_rain", "wrecking_ball", "bridge", "newton_cradle"}) {
        CAPTURE(name);
        const Running now(std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes" / (std::string(name) + ".json"), 60);
        Labeller labeller(kWidth, kHeight);
        const FrameLabels& labels = labeller.label(now.scene, now.run.built(), now.camera);
        std::vector<std::vector<DVec2>> outlines;
        for (const LabelledShape& drawn : labels.order) {
            const World& world = now.run.world();
            const Pose pose = world.state(world.body(drawn.shape)).pose;
            outlines.push_back(frame_outline(world.shape(drawn.shape), pose, now.camera, kWidth, kHeight));
        }
        std::mt19937_64 random(7);
        for (int i = 0; i < 4000; ++i) {
            const int column = static_cast<int>(random() % kWidth), row = static_cast<int>(random() % kHeight);
            const DVec2 center{column + 0.5, row + 0.5};
            BodyLabel filled = 0;
            bool has_edge = false;
            for (std::size_t k = 0; k < outlines.size(); ++k) {
                if (contains(outlines[k], center)) filled = labels.order[k].label;
                has_edge |= distance_to_outline(outlines[k], center) < 1.0;
            }
            if (has_edge) continue;
            CAPTURE(column);
            CAPTURE(row);
            REQUIRE(label_at(labels.mask, column, row) == filled);
            ++equal;
        }
    }
    CHECK(equal > 10000);
}

TEST_CASE("masks agree with the colours of frames") {
    // Inside a body a frame shows its fill, or its orientation mark, which is a blend of fill and outline. Joints are
    // drawn over bodies, and are left out here.
    std::size_t bodies = 0, marks = 0;
    Renderer renderer(kWidth, kHeight);
    for (const char* const name : {"see_saw", "mixed_rain", "wrecking_ball", "card_house", "gears"}) {
        CAPTURE(name);
        const auto file = std::filesystem::path(TUMBLE_SOURCE_DIR) / "scenes" / (std::string(name) + ".json");
        if (!std::filesystem::exists(file)) continue;
        Running now(file, 60);
        Labeller labeller(kWidth, kHeight);
        const FrameLabels& labels = labeller.label(now.scene, now.run.built(), now.camera);
        Image image;
        Overlay bare;
        for (const OverlayPart& part : kFrameParts) bare.*part.member = false;
        for (const JointId joint : std::vector(now.run.world().joints().begin(), now.run.world().joints().end()))
            if (now.run.world().is_valid(joint)) now.run.world().destroy_joint(joint);
        renderer.draw(now.scene, now.run.built(), now.camera, 0.0, image, bare);
        const render::Palette palette(now.scene);
        std::map<BodyLabel, std::vector<render::Paint>> paints;
        std::size_t ordinal = 0;
        const std::vector<SceneInstance>& built = now.run.built().bodies;
        for (std::size_t i = 0; i < built.size(); ++i) {
            ordinal = i > 0 && built[i - 1].source == built[i].source ? ordinal + 1 : 0;
            if (!now.run.world().is_valid(built[i].id)) continue;
            std::vector<render::Paint>& own = paints[static_cast<BodyLabel>(i + 1)];
            own.resize(now.run.world().shapes(built[i].id).size());
            palette.paint_body(built[i].source, ordinal, own);
        }
        for (int row = 0; row < kHeight; row += 3)
            for (int column = 0; column < kWidth; column += 3) {
                const BodyLabel label = label_at(labels.mask, column, row);
                const Around around = look_around(now.run.built(), world_point(now.camera, column, row), now.camera);
                if (around.has_edge || label == 0) continue;
                CAPTURE(column);
                CAPTURE(row);
                const Color seen = render::pixel(image, column, row);
                const bool is_of_body = std::ranges::any_of(paints.at(label), [&](const render::Paint& paint) {
                    for (int share = 0; share <= 40; ++share) {
                        const Color color = render::mix(paint.fill, paint.outline, share / 40.0);
                        if (std::abs(color.r - seen.r) <= 3 && std::abs(color.g - seen.g) <= 3 &&
                            std::abs(color.b - seen.b) <= 3) {
                            marks += share > 0 ? 1u : 0u;
                            return true;
                        }
                    }
                    return false;
                });
                REQUIRE(is_of_body);
                ++bodies;
            }
    }
    CHECK(bodies > 5000);
    CHECK(marks < bodies / 3);
}

TEST_CASE("a later body covers an earlier one of its kind, circles cover boxes, and all others cover static bodies") {
    const HandMadeScene s = overlapping();
    Labeller labeller(kWidth, kHeight);
    const FrameLabels& labels = labeller.label(s.scene, s.built, {{0.0, 0.0}, 9.0});  // 40 pixels a metre
    const Mask& mask = labels.mask;
    CHECK(label_at(mask, 320, 180) == 2);       // the disc, over both boxes
    CHECK(label_at(mask, 320 + 50, 180) == 3);  // the box, 1.25 m to the right
    CHECK(label_at(mask, 320, 180 + 50) == 1);  // the ground, whose top is 1 m below
    CHECK(label_at(mask, 320, 180 - 50) == 0);
    REQUIRE(labels.bodies.size() == 4);
    CHECK(labels.bodies[3].visible == 0);
    CHECK(labels.bodies[3].pixels == 8 * 8);
    CHECK(labels.bodies[3].last_column < labels.bodies[3].first_column);
    CHECK(labels.bodies[2].pixels == 80 * 80);
    CHECK(labels.bodies[0].body == s.built.bodies[0].id);
    std::vector<BodyLabel> order;
    for (const LabelledShape& drawn : labels.order) order.push_back(drawn.label);
    CHECK(order == std::vector<BodyLabel>{1, 3, 4, 2});
}

TEST_CASE("the counts of bodies are those of the mask") {
    const HandMadeScene s = overlapping();
    Labeller labeller(kWidth, kHeight);
    const FrameLabels& labels = labeller.label(s.scene, s.built, {{0.1, 0.3}, 7.0});
    for (const LabelledBody& body : labels.bodies) {
        CAPTURE(body.label);
        std::size_t visible = 0, hidden = 0;
        int first_column = kWidth, last_column = -1, first_row = kHeight, last_row = -1;
        for (int row = 0; row < kHeight; ++row)
            for (int column = 0; column < kWidth; ++column) {
                if (label_at(labels.mask, column, row) != body.label) continue;
                ++visible;
                first_column = std::min(first_column, column);
                last_column = std::max(last_column, column);
                first_row = std::min(first_row, row);
                last_row = std::max(last_row, row);
            }
        for (const CoveredPixels& pair : labels.covered)
            if (pair.below == body.label) hidden += pair.pixels;
        CHECK(body.visible == visible);
        CHECK(body.pixels == visible + hidden);
        if (visible == 0) continue;
        CHECK(body.first_column == first_column);
        CHECK(body.last_column == last_column);
        CHECK(body.first_row == first_row);
        CHECK(body.last_row == last_row);
    }
}

TEST_CASE("a body that the program adds has a label after those of the scene, and a sensor none") {
    HandMadeScene s = overlapping();
    const BodyId added = s.built.world.create_body({.pose = {{5.0, 0.0}, {}}});
    s.built.world.add_shape(added, {.shape = make_circle(0.5f)});
    s.built.world.add_shape(added, {.shape = make_circle(2.0f), .sensor = true});
    Labeller labeller(kWidth, kHeight);
    const Camera camera{{0.0, 0.0}, 9.0};
    const FrameLabels& labels = labeller.label(s.scene, s.built, camera);
    CHECK(label_at(labels.mask, 320 + 200, 180) == 5);
    CHECK(label_at(labels.mask, 320 + 200, 180 - 40) == 0);
    const Mask of_scene = labels.mask;
    CHECK(labeller.mask(s.built.world, camera).labels == of_scene.labels);  // ids follow the order of creation here
    CHECK(labeller.label(s.built.world, camera).mask.labels == of_scene.labels);
}

TEST_CASE("shapes far larger than the frame, and far away from it, are labelled") {
    HandMadeScene s;
    s.add_static("plane", {0.0, -5e6}, make_box({1e7f, 1e7f}));
    s.add_dynamic("away", {1e6, 0.0}, make_circle(1.0f));
    Labeller labeller(kWidth, kHeight);
    const FrameLabels& labels = labeller.label(s.scene, s.built, {{0.0, 0.0}, 9.0});
    CHECK(labels.bodies.size() == 1);
    CHECK(labels.bodies[0].pixels == std::size_t{kWidth} * kHeight / 2);
    CHECK(label_at(labels.mask, 0, kHeight - 1) == 1);
    CHECK(label_at(labels.mask, kWidth - 1, kHeight / 2 - 1) == 0);
}

TEST_CASE("a labeller refuses what a renderer refuses") {
    CHECK_THROWS_AS(Labeller(15, 100), std::invalid_argument);
    CHECK_THROWS_AS(Labeller(100, 8193), std::invalid_argument);
    Labeller labeller(64, 64);
    const World world;
    CHECK_THROWS_AS(static_cast<void>(labeller.mask(world, {{0.0, 0.0}, 0.0})), std::invalid_argument);
    CHECK(labeller.mask(world, {{0.0, 0.0}, 1.0}).labels == std::vector<BodyLabel>(4096, 0));
}
