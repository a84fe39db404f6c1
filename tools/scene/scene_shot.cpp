#include "tools/scene/scene_shot.hpp"

#include <utility>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

namespace {

using StepObserver = std::function<void(std::uint64_t step)>;

SceneShot paint(const Scene& scene, std::uint64_t step, const ShotSettings& settings, const Marker& mark,
                const StepObserver& observe, Image& image) {
    const FrameSize size = settings.size;
    SceneRun run(scene);
    Camera camera = make_camera(scene, run.built(), size.aspect_ratio());
    Renderer renderer(size.width, size.height, settings.renderer);
    std::vector<Trail> trails;
    record_trails(trails, scene, run.built());
    while (run.world().step_count() < step && !run.is_stopped()) {
        run.step();
        camera = move_camera(camera, scene, run.built());
        record_trails(trails, scene, run.built());
        observe(run.world().step_count());
    }
    Marking marking = mark ? mark(run.built()) : Marking{};
    marking.trails = std::move(trails);
    camera = apply_camera_keys(camera, scene, run.built(), size.aspect_ratio());
    camera = widen_camera(camera, run.world(), marking, size.aspect_ratio());
    renderer.draw(scene, run.built(), camera, run.time(), image, settings.overlay, marking);
    return {std::move(run), camera};
}

}  // namespace

SceneFrames::SceneFrames(const Scene& scene, const ShotSettings& settings)
    : scene_(scene),
      settings_(settings),
      run_(scene),
      camera_(make_camera(scene, run_.built(), settings.size.aspect_ratio())),
      renderer_(settings.size.width, settings.size.height, settings.renderer) {
    record_trails(marking_.trails, scene, run_.built());
}

const Image& SceneFrames::at(std::uint64_t step) {
    while (run_.world().step_count() < step && !run_.is_stopped() && !is_interrupted()) {
        run_.step();
        camera_ = move_camera(camera_, scene_, run_.built());
        record_trails(marking_.trails, scene_, run_.built());
    }
    const Camera shown = apply_camera_keys(camera_, scene_, run_.built(), settings_.size.aspect_ratio());
    renderer_.draw(scene_, run_.built(), shown, run_.time(), image_, settings_.overlay, marking_);
    return image_;
}

SceneShot paint_scene_at(const Scene& scene, std::uint64_t step, const ShotSettings& settings, const Marker& mark,
                         Image& image) {
    return paint(
        scene, step, settings, mark, [](std::uint64_t) {}, image);
}

SceneShot draw_scene_at(const Scene& scene, std::uint64_t step, const ShotSettings& settings,
                        const std::filesystem::path& file, const Marker& mark) {
    Progress progress("steps", step);
    Image image;
    SceneShot shot = paint(
        scene, step, settings, mark, [&](std::uint64_t done) { progress.show(done); }, image);
    create_folder_of(file);
    write_png(image, file);
    return shot;
}

}  // namespace tumble::tools
