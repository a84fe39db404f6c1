// The camera of a scene. Its center and its height are those of the scene; what the scene does not state is fitted to
// the world. If most bodies drive away, it follows the largest of them.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "render/view/fit.hpp"
#include "render/view/named_body.hpp"
#include "tumble/render.hpp"

namespace tumble {
namespace {

constexpr double kShareBelow = 0.3;    // of the spare height, the share below the box where gravity points down
constexpr double kEmptyHeight = 10.0;  // m, of a frame of a world without extent
constexpr double kMostGrowth = 3.0;    // factor by which a frame may grow to show a marking

// The height of a frame about `center` that contains the box.
double height_about(DVec2 center, const render::Box& box, double aspect_ratio) {
    const DVec2 reach{std::max(box.upper.x - center.x, center.x - box.lower.x),
                      std::max(box.upper.y - center.y, center.y - box.lower.y)};
    return render::height_for(2.0 * reach, aspect_ratio);
}

double height_or(const Scene& scene, double fitted) {
    return scene.camera.height.value_or(fitted > 0.0 ? fitted : kEmptyHeight);
}

Camera camera_following(const Scene& scene, const World& world, BodyId body) {
    const DVec2 position = world.state(body).pose.position;
    Camera camera;
    camera.follows = body;
    camera.offset = scene.camera.center.value_or(position) - position;
    camera.center = position + camera.offset;  // the expression of move_camera(), for equal bits
    const render::Box box = render::box_of(world, body);
    camera.height = height_or(scene, box.is_empty() ? 0.0 : render::kHeightPerFollowed * box.larger_side());
    return camera;
}

// `motions` are those of a preview, for a scene.
Camera fixed_camera(const Scene& scene, const World& world, const std::vector<render::MotionBounds>& motions,
                    double aspect_ratio) {
    render::Box box;
    if (!scene.camera.center || !scene.camera.height) box = render::fitted_box(world, motions, aspect_ratio);
    Camera camera;
    camera.center = scene.camera.center.value_or(box.is_empty() ? DVec2{} : box.center());
    camera.height =
        height_or(scene, box.is_empty() ? 0.0 : render::kMargin * height_about(camera.center, box, aspect_ratio));
    const bool is_centered = !scene.camera.center && !box.is_empty();
    if (is_centered && world.def().gravity.y < 0.0f) {
        const double spare = std::max(0.0, camera.height - render::kMargin * box.size().y);
        camera.center.y += (0.5 - kShareBelow) * spare;
    }
    return camera;
}

}  // namespace

Camera make_camera(const Scene& scene, const SceneWorld& world, double aspect_ratio) {
    if (const SceneInstance* const body = render::find_body(world, scene.camera.follow))
        return camera_following(scene, world.world, body->id);
    if (scene.camera.center && scene.camera.height) return fixed_camera(scene, world.world, {}, aspect_ratio);
    const std::vector<render::MotionBounds> motions = render::preview_motion(scene);
    if (!scene.camera.center && scene.camera.follow.empty())
        if (const auto leader = render::leading_motion(world.world, motions, aspect_ratio);
            leader && leader->body < world.bodies.size())
            return camera_following(scene, world.world, world.bodies[leader->body].id);
    return fixed_camera(scene, world.world, motions, aspect_ratio);
}

Camera make_camera(const World& world, double aspect_ratio) { return fixed_camera(Scene{}, world, {}, aspect_ratio); }

Camera move_camera(Camera camera, const Scene& scene, const SceneWorld& world) {
    if (camera.follows == BodyId{})
        if (const SceneInstance* const body = render::find_body(world, scene.camera.follow))
            return camera_following(scene, world.world, body->id);
    if (world.world.is_valid(camera.follows))
        camera.center = world.world.state(camera.follows).pose.position + camera.offset;
    return camera;
}

Camera widen_camera(Camera camera, const World& world, const Marking& marking, double aspect_ratio) {
    const double highest = kMostGrowth * camera.height;
    const auto view = [&] {
        const DVec2 half = 0.5 * camera.height * DVec2{aspect_ratio, 1.0};
        return render::Box{camera.center - half, camera.center + half};
    };
    const auto show = [&](const render::Box& marked) {
        render::Box both = view();
        if (marked.is_empty() || both.contains(marked)) return;
        both.add(marked);
        const double height = render::kMargin * render::height_for(both.size(), aspect_ratio);
        if (height > highest) return;
        camera.center = both.center();
        camera.height = height;
    };
    for (const std::array<DVec2, 4>& region : marking.regions) show(render::box_around(region));
    for (const BodyId body : marking.bodies)
        if (world.is_valid(body) && !view().overlaps(render::box_of(world, body))) show(render::box_of(world, body));
    return camera;
}

}  // namespace tumble
