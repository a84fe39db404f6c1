#include "python/bindings/env_images.hpp"

#include <algorithm>
#include <utility>

#include "python/bindings/renderers.hpp"
#include "tumble/recording.hpp"

namespace tumble::python {

namespace {

// A world in place of that of a scene, and back at the end.
class Lent {
public:
    Lent(World& world, const SceneWorld& start)
        : lender_(world), built_{std::move(world), start.bodies, start.joints, start.work} {}
    ~Lent() { lender_ = std::move(built_.world); }
    Lent(const Lent&) = delete;
    Lent& operator=(const Lent&) = delete;

    const SceneWorld& built() const { return built_; }

private:
    World& lender_;
    SceneWorld built_;
};

// Frames for learning have bodies and joints, and nothing else.
Overlay bare_frame() {
    Overlay overlay;
    for (const OverlayPart& part : kFrameParts) overlay.*part.member = false;
    return overlay;
}

// Red, green and blue, without alpha.
void copy_colors(const Image& image, std::span<std::uint8_t> out) {
    for (std::size_t from = 0, to = 0; from < image.rgba.size(); from += 4, to += 3)
        std::copy_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(from), 3,
                    out.begin() + static_cast<std::ptrdiff_t>(to));
}

}  // namespace

EnvImages::EnvImages(const Scene& scene, const SceneWorld& start, const std::vector<ImagePlan>& plans) {
    for (const ImagePlan& plan : plans) {
        View view{plan, scene, {}};
        if (plan.center) view.scene.camera.center = plan.center;
        if (plan.height) view.scene.camera.height = plan.height;
        if (!plan.follow.empty()) view.scene.camera.follow = plan.follow;
        if (plan.center || plan.height || !plan.follow.empty()) view.scene.camera.keys.clear();
        view.camera = make_camera(view.scene, start, double(plan.columns) / plan.rows);
        images_.push_back(std::move(view));
    }
}

std::size_t EnvImages::size(std::size_t image) const {
    const ImagePlan& plan = images_[image].plan;
    const auto pixels = static_cast<std::size_t>(plan.columns) * static_cast<std::size_t>(plan.rows);
    return plan.is_mask ? pixels : 3 * pixels;
}

void EnvImages::clear(std::span<const ImageArray> arrays, std::size_t index) const {
    for (std::size_t i = 0; i < images_.size(); ++i) {
        if (is_mask(i))
            std::ranges::fill(arrays[i].labels.subspan(index * size(i), size(i)), std::uint16_t{0});
        else
            std::ranges::fill(arrays[i].pixels.subspan(index * size(i), size(i)), std::uint8_t{0});
    }
}

void EnvImages::draw(World& world, const SceneWorld& start, std::span<const ImageArray> arrays,
                     std::size_t index) const {
    const Lent lent(world, start);
    const SceneWorld& built = lent.built();
    for (std::size_t i = 0; i < images_.size(); ++i) {
        const auto& [plan, scene, first] = images_[i];
        const Camera camera =
            apply_camera_keys(move_camera(first, scene, built), scene, built, double(plan.columns) / plan.rows);
        if (plan.is_mask) {
            const Mask& mask = tool_of_size<Labeller>(plan.columns, plan.rows).mask(built.world, camera);
            std::ranges::copy(mask.labels, arrays[i].labels.subspan(index * size(i), size(i)).begin());
            continue;
        }
        static thread_local Image image;
        static const Overlay bare = bare_frame();
        tool_of_size<Renderer>(plan.columns, plan.rows).draw(scene, built, camera, built.world.time(), image, bare);
        copy_colors(image, arrays[i].pixels.subspan(index * size(i), size(i)));
    }
}

}  // namespace tumble::python
