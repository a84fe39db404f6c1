#include "tools/scene/scene_shot.hpp"

#include <utility>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

SceneShot draw_scene_at(const Scene& scene, std::uint64_t step, const ShotSettings& settings,
                        const std::filesystem::path& file, const Marker& mark) {
    const FrameSize size = settings.size;
    SceneRun run(scene);
    Camera camera = make_camera(scene, run.built(), size.aspect_ratio());
    Renderer renderer(size.width, size.height, settings.renderer);
    std::vector<Trail> trails;
    record_trails(trails, scene, run.built());
    Progress progress("step", step);
    while (run.world().step_count() < step) {
        run.step();
        camera = move_camera(camera, scene, run.built());
        record_trails(trails, scene, run.built());
        progress.show(run.world().step_count());
    }
    Image image;
    Marking marking = mark ? mark(run.built()) : Marking{};
    marking.trails = std::move(trails);
    camera = widen_camera(camera, run.world(), marking, size.aspect_ratio());
    renderer.draw(scene, run.built(), camera, run.time(), image, settings.overlay, marking);
    create_folder_of(file);
    write_png(image, file);
    return {std::move(run), camera};
}

}  // namespace tumble::tools
