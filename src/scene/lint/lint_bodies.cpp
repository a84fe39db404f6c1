// Lints of single bodies: slivers, sizes, weight, velocities and masses without effect, angles, images.
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "scene/json/json_text.hpp"
#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

constexpr double kSliver = 0.01;  // of its length

class BodyLinter {
public:
    BodyLinter(const Scene& scene, Diagnostics& diagnostics) : scene_(scene), diagnostics_(diagnostics) {}

    void lint_shapes(const SceneBody& body, const std::string& pointer) {
        if (body.type != BodyType::dynamic_body) return;
        for (std::size_t i = 0; i < body.shapes.size(); ++i) {
            double width = 0.0, size = 0.0;  // of the widest and of the longest part: others may be thin
            for (const Shape& part : make_shapes(body.shapes[i].geometry)) {
                width = std::max(width, width_of(part));
                size = std::max(size, double{extent(part).larger});
            }
            lint_size(pointer + "/shapes/" + std::to_string(i), width, size);
        }
    }

    // A body without shapes serves as the anchor of joints: no warning.
    void lint_weight(const SceneBody& body, const std::string& pointer) {
        const auto weighs = [](const SceneShape& shape) {
            return !shape.sensor && !std::holds_alternative<SegmentGeometry>(shape.geometry) &&
                   !std::holds_alternative<ChainGeometry>(shape.geometry);
        };
        if (body.type != BodyType::dynamic_body || body.mass || body.shapes.empty() ||
            std::ranges::any_of(body.shapes, weighs))
            return;
        diagnostics_.warning(
            codes::no_mass, pointer,
            "the body consists of segments, chains and sensors, which have no mass: it gets 1 kg and does not rotate",
            R"(give it a "mass", or a shape with an area)");
    }

    void lint_motion(const SceneBody& body, const std::string& pointer) {
        const bool has_velocity = body.velocity != DVec2{} || body.angular_velocity != 0.0;
        if (has_velocity && body.type == BodyType::static_body)
            diagnostics_.warning(codes::static_velocity, pointer,
                                 "the body is static and has a velocity: it does not move",
                                 R"(a body of "type": "kinematic" moves at the velocity it is given)");
    }

    void lint_mass(const SceneBody& body, const std::string& pointer) {
        if (body.mass && body.type != BodyType::dynamic_body)
            diagnostics_.warning(codes::unused_mass, pointer + "/mass",
                                 "the body is not dynamic: its mass has no effect",
                                 R"(leave "mass" out, or make the body dynamic)");
    }

    // Only the images of scenes that are read from files have paths. A file is named once.
    void lint_images(const SceneBody& body, const std::string& pointer) {
        for (std::size_t i = 0; i < body.images.size(); ++i) {
            const std::filesystem::path& path = body.images[i].path;
            if (path.empty() || !seen_images_.insert(path).second) continue;
            lint_image(path, pointer + "/images/" + std::to_string(i) + "/file");
        }
    }

private:
    void lint_image(const std::filesystem::path& path, const std::string& where) {
        const std::string name = quoted(path.string());
        const FoundFile found = find_file(path);
        if (!found.is_there)
            diagnostics_.warning(codes::missing_image, where,
                                 "there is no file " + name + ": frames show the outline of the image",
                                 "paths are relative to the folder of the scene's file");
        else if (!found.fault.empty())
            diagnostics_.warning(codes::missing_image, where, name + " " + found.fault + ": no frames can be drawn",
                                 "name a PNG, JPEG or BMP file that can be read");
    }

    void lint_size(const std::string& pointer, double width, double size) {
        if (width > 0.0 && width < kSliver * size)
            diagnostics_.warning(codes::sliver, pointer,
                                 "the shape is a sliver, " + brief(size) + " m long and " + brief(width) +
                                     " m thin: it has almost no inertia about its length, and its contacts jitter",
                                 "make it thicker, or use a capsule, whose ends are round");
        const double scale = scene_.world.scale;
        if (size < scale * kSmallestBody || size > scale * kLargestBody)
            diagnostics_.warning(codes::unusual_size, pointer,
                                 "the shape is " + brief(size) + " m large: dynamic bodies behave best between " +
                                     brief(scale * kSmallestBody) + " m and " + brief(scale * kLargestBody) + " m",
                                 R"(set the "scale" of the world to the size of a typical body)");
    }

    const Scene& scene_;
    Diagnostics& diagnostics_;
    std::set<std::filesystem::path> seen_images_;
};

}  // namespace

void add_body_lints(const Scene& scene, Diagnostics& diagnostics) {
    BodyLinter linter(scene, diagnostics);
    const auto lint = [&](const SceneBody& body, const std::string& pointer) {
        linter.lint_shapes(body, pointer);
        linter.lint_weight(body, pointer);
        linter.lint_motion(body, pointer);
        linter.lint_mass(body, pointer);
        linter.lint_images(body, pointer);
        lint_degrees(body.angle, pointer + "/angle", diagnostics);
    };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) lint(scene.bodies[i], "/bodies/" + std::to_string(i));
    for (std::size_t i = 0; i < scene.timeline.size(); ++i)
        if (scene.timeline[i].spawn) lint(*scene.timeline[i].spawn, "/timeline/" + std::to_string(i) + "/spawn");
}

}  // namespace tumble::scene
