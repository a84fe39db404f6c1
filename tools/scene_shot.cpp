#include "scene_shot.hpp"

#include "console.hpp"
#include "output_path.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

SceneRun draw_scene_at(const Scene& scene, std::uint64_t step, FrameSize size, const std::filesystem::path& file,
                       const Overlay& overlay) {
    SceneRun run(scene);
    const double aspect_ratio = static_cast<double>(size.width) / size.height;
    const Camera camera = make_camera(scene, run.built(), aspect_ratio);
    Renderer renderer(size.width, size.height);
    Progress progress("step", step);
    while (run.world().step_count() < step) {
        run.step();
        progress.show(run.world().step_count());
    }
    Image image;
    renderer.draw(scene, run.built(), move_camera(camera, run.world()), run.time(), image, overlay);
    create_folder_of(file);
    write_png(image, file);
    return run;
}

}  // namespace tumble::tools
