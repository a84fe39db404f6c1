#include "scene/lint.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/build.hpp"
#include "scene/display.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

namespace {

constexpr double kSliver = 0.01;                       // of its length
constexpr double kSmallestBody = 0.005, kLargestBody = 100.0;  // m, in a world of scale 1: where the solver's constants are tried

// The least distance of two parallel lines that the shape fits between (m).
double width_of(const Shape& shape) {
    const int count = shape.vertex_count();
    double least = count < 3 ? 0.0 : HUGE_VAL;
    for (int i = 0; i < count && count >= 3; ++i) {
        const DVec2 from(shape.vertex(i)), edge = DVec2(shape.vertex(i + 1 == count ? 0 : i + 1)) - from;
        double height = 0.0;
        for (int k = 0; k < count; ++k) height = std::max(height, cross(edge, DVec2(shape.vertex(k)) - from));
        least = std::min(least, height / length(edge));
    }
    return least + 2.0 * double{shape.radius()};
}

double size_of(const Shape& shape) { return double{extent(shape).larger}; }

std::string at_body(std::size_t source) { return "/bodies/" + std::to_string(source); }

class BodyLinter {
public:
    BodyLinter(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics)
        : scene_(scene), built_(built), diagnostics_(diagnostics) {}

    void check_shapes(std::size_t source) {
        const SceneBody& body = scene_.bodies[source];
        if (body.type != BodyType::dynamic_body) return;
        double thickness = HUGE_VAL;
        for (std::size_t i = 0; i < body.shapes.size(); ++i) {
            const std::string pointer = at_body(source) + "/shapes/" + std::to_string(i);
            double width = HUGE_VAL, size = 0.0;
            for (const Shape& part : make_shapes(body.shapes[i].geometry)) {
                width = std::min(width, width_of(part));
                size = std::max(size, size_of(part));
            }
            thickness = std::min(thickness, width);
            check_size(pointer, width, size);
        }
        check_speed(source, thickness);
    }

    void check_joint(const SceneJointInstance& joint) {
        const World& world = built_.world;
        const auto [a, b] = std::visit([](const auto& def) { return std::pair(def.body_a, def.body_b); },
                                       world.joint(joint.id));
        if (scene_.joints[joint.source].type == SceneJointType::filter) return;
        if (world.type(a) != BodyType::dynamic_body || world.type(b) != BodyType::dynamic_body) return;
        const double ratio = mass_ratio(world, a, b);
        if (ratio <= kLargeMassRatio) return;
        diagnostics_.warning("/joints/" + std::to_string(joint.source),
                             "ties bodies of " + brief(world.mass(a).mass) + " kg and " + brief(world.mass(b).mass) +
                                 " kg: joints stretch under what is over 100 times heavier",
                             "bring the densities nearer to each other, or give the world more substeps");
    }

private:
    void check_size(const std::string& pointer, double width, double size) {
        if (width > 0.0 && width < kSliver * size)
            diagnostics_.warning(pointer, "is a sliver, " + brief(size) + " m long and " + brief(width) +
                                              " m thin: it has next to no inertia about its length, and its contacts rattle",
                                 "make it thicker, or a capsule, whose ends are round");
        const double scale = scene_.world.scale;
        if (size < scale * kSmallestBody || size > scale * kLargestBody)
            diagnostics_.warning(pointer,
                                 "is " + brief(size) + " m large: moving bodies behave best between " + brief(scale * kSmallestBody) +
                                     " m and " + brief(scale * kLargestBody) + " m",
                                 R"(give the world a "scale", the size of a typical body)");
    }

    void check_speed(std::size_t source, double thickness) {
        const SceneBody& body = scene_.bodies[source];
        const double way = length(body.velocity) / scene_.world.steps_per_second;
        const bool meets_others = built_.bodies.size() > 1 && !body.bullet;
        if (!(way > thickness) || !(meets_others || !scene_.world.continuous)) return;
        const std::string what = scene_.world.continuous ? "moving bodies" : "whatever is in its way, as the world is not continuous";
        diagnostics_.warning(at_body(source) + "/velocity",
                             "is " + brief(way) + " m in a step, of a body " + brief(thickness) + " m thick: it may pass through " + what,
                             R"("bullet": true, or more steps_per_second)");
    }

    const Scene& scene_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
};

}  // namespace

double mass_ratio(const World& world, BodyId a, BodyId b) {
    const auto [lighter, heavier] = std::minmax({double{world.mass(a).mass}, double{world.mass(b).mass}});
    return heavier / lighter;
}

void add_body_lints(const Scene& scene, const SceneWorld& built, Diagnostics& diagnostics) {
    BodyLinter linter(scene, built, diagnostics);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) linter.check_shapes(i);
    for (const SceneJointInstance& joint : built.joints) linter.check_joint(joint);
}

void add_lints(const Scene& scene, Diagnostics& diagnostics) {
    // At rest, the first step finds every contact where the file has put the bodies.
    SceneWorld started = build_world(scene, Start::at_rest);
    started.world.step();
    add_body_lints(scene, started, diagnostics);
    add_contact_lints(scene, started, diagnostics);
}

}  // namespace tumble::scene
