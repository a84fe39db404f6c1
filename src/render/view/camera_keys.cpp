// The key frames of a camera: the view of each key frame, and the interpolation between two of them.
//
// Let u be the fraction of the time between two key frames that has passed. Centre and height are those of the earlier
// key frame plus s = 3 u^2 - 2 u^3 times the difference. The velocity of the view is continuous, and 0 at each key
// frame.
#include <algorithm>
#include <iterator>
#include <span>

#include "render/view/fit.hpp"
#include "render/view/named_body.hpp"
#include "tumble/render.hpp"

namespace tumble {
namespace {

// A box around all bodies of these names, whatever their angles, and the largest side of one of them.
struct FollowedBox {
    render::Box all;
    double largest = 0.0;
};

FollowedBox box_around(const SceneWorld& world, std::span<const std::string> names) {
    FollowedBox box;
    for (const std::string& name : names) {
        const SceneInstance* const body = render::find_body(world, name);
        if (!body) continue;
        const render::Box own = render::swept_box(world.world, body->id, world.world.mass(body->id).center);
        box.all.add(own);
        if (!own.is_empty()) box.largest = std::max(box.largest, own.larger_side());
    }
    return box;
}

// The view of the last of some key frames, none of which may state all of it; `camera` has the rest.
Camera view_at(std::span<const SceneCameraKey> keys, const Camera& camera, const SceneWorld& world,
               double aspect_ratio) {
    const auto states_center = [](const SceneCameraKey& key) { return key.center || !key.follow.empty(); };
    const auto states_height = [](const SceneCameraKey& key) { return key.height || !key.follow.empty(); };
    const auto centered = std::find_if(keys.rbegin(), keys.rend(), states_center);
    const auto sized = std::find_if(keys.rbegin(), keys.rend(), states_height);
    Camera view{.center = camera.center, .height = camera.height};
    if (centered != keys.rend()) {
        const render::Box box = box_around(world, centered->follow).all;
        view.center = box.is_empty() ? centered->center.value_or(camera.center) : box.center();
    }
    if (sized == keys.rend()) return view;
    const FollowedBox box = box_around(world, sized->follow);
    const double fitted = box.all.is_empty()
                              ? camera.height
                              : std::max(render::kMargin * render::height_for(box.all.size(), aspect_ratio),
                                         render::kHeightPerFollowed * box.largest);
    view.height = sized->height.value_or(fitted > 0.0 ? fitted : camera.height);
    return view;
}

}  // namespace

Camera apply_camera_keys(const Camera& camera, const Scene& scene, const SceneWorld& world, double aspect_ratio) {
    const std::span<const SceneCameraKey> keys = scene.camera.keys;
    if (keys.empty()) return camera;
    const double time = world.world.time();
    const auto later = std::ranges::upper_bound(keys, time, {}, &SceneCameraKey::time);
    const auto next = static_cast<std::size_t>(later - keys.begin());
    const Camera from = view_at(keys.first(std::max<std::size_t>(next, 1)), camera, world, aspect_ratio);
    if (next == 0 || next == keys.size()) return from;
    const Camera to = view_at(keys.first(next + 1), camera, world, aspect_ratio);
    const double u = (time - keys[next - 1].time) / (keys[next].time - keys[next - 1].time);
    const double share = u * u * (3.0 - 2.0 * u);
    return {.center = from.center + share * (to.center - from.center),
            .height = from.height + share * (to.height - from.height)};
}

}  // namespace tumble
