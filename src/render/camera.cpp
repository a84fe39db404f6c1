// The camera of a scene: what the scene says, and what it leaves open fitted to the world.
#include <algorithm>
#include <string>

#include "render/fit.hpp"
#include "tumble/render.hpp"

namespace tumble {
namespace {

constexpr double kMargin = 1.14;       // of the fitted height
constexpr double kBelow = 0.3;         // share of the room to spare that is left below, where things fall down
constexpr double kEmptyHeight = 10.0;  // m, of a world in which nothing has a size

const SceneInstance* find_body(const SceneWorld& world, const std::string& name) {
    if (name.empty()) return nullptr;
    for (const SceneInstance& body : world.bodies)
        if (body.name == name) return &body;
    return nullptr;
}

// The height of a frame about `center` that holds the box.
double height_about(DVec2 center, const render::Box& box, double aspect_ratio) {
    const DVec2 reach{std::max(box.upper.x - center.x, center.x - box.lower.x),
                      std::max(box.upper.y - center.y, center.y - box.lower.y)};
    return render::height_for(2.0 * reach, aspect_ratio);
}

}  // namespace

Camera make_camera(const Scene& scene, const SceneWorld& world, double aspect_ratio) {
    const render::Box box = render::interesting_box(world.world, aspect_ratio);
    const SceneInstance* const followed = find_body(world, scene.camera.follow);

    Camera camera;
    if (followed) {
        camera.follows = followed->id;
        camera.center = world.world.state(followed->id).pose.position;
    } else if (!box.is_empty()) {
        camera.center = box.center();
    }
    if (scene.camera.center) camera.center = *scene.camera.center;
    if (followed) camera.offset = camera.center - world.world.state(followed->id).pose.position;

    const double fitted = box.is_empty() ? 0.0 : kMargin * height_about(camera.center, box, aspect_ratio);
    camera.height = scene.camera.height.value_or(fitted > 0.0 ? fitted : kEmptyHeight);
    const bool is_centered = !followed && !scene.camera.center && !box.is_empty();
    if (is_centered && world.world.def().gravity.y < 0.0f) {
        const double spare = std::max(0.0, camera.height - kMargin * box.size().y);
        camera.center.y += (0.5 - kBelow) * spare;
    }
    return camera;
}

Camera move_camera(Camera camera, const World& world) {
    if (world.is_valid(camera.follows)) camera.center = world.state(camera.follows).pose.position + camera.offset;
    return camera;
}

}  // namespace tumble
