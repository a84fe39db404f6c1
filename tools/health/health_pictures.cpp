#include "tools/health/health_pictures.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

constexpr int kWidth = 640, kHeight = 360;  // px
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
constexpr double kAround = 5.0;  // the height of the view over that of the marked bodies

Aabb box_around(const World& world, const std::vector<BodyId>& bodies) {
    Aabb box;
    for (const BodyId id : bodies) {
        if (world.type(id) == BodyType::static_body) continue;
        for (const ShapeId shape : world.shapes(id)) box = merge(box, bounds(world.shape(shape), world.state(id).pose));
    }
    return box;
}

// A view of the bodies that are not static, not wider than the frame of the scene unless they are out of it.
Camera close_view(Camera camera, const World& world, const std::vector<BodyId>& bodies) {
    const Aabb box = box_around(world, bodies);
    const double width = double{box.upper.x} - double{box.lower.x}, height = double{box.upper.y} - double{box.lower.y};
    if (!(std::max(width, height) > 0.0)) return camera;
    camera.height = std::min(camera.height, kAround * std::max(height, width / kAspect));
    camera.center = 0.5 * (DVec2(box.lower) + DVec2(box.upper));
    return camera;
}

}  // namespace

void draw_findings(const Scene& scene, RenderBackend backend, bool (*is_stopped)(), HealthReport& report) {
    std::multimap<std::uint64_t, ReportedFinding*> moments;
    for (ReportedFinding& reported : report.findings) moments.emplace(reported.finding.step, &reported);
    if (moments.empty()) return;
    try {
        Renderer renderer(kWidth, kHeight, backend);
        SceneRun run(scene);
        const Camera camera = make_camera(scene, run.built(), kAspect);
        const Overlay overlay{.contacts = true, .joints = true, .title = false, .notes = false};
        for (auto& [step, reported] : moments) {
            while (run.world().step_count() < step && !is_stopped()) run.step();
            if (is_stopped()) throw RenderError("the run that draws them was interrupted");
            std::vector<BodyId> marked = reported->finding.bodies;
            std::erase_if(marked, [&](BodyId id) { return !run.world().is_valid(id); });
            const Marking marking{.bodies = marked};
            const Camera view = widen_camera(close_view(camera, run.world(), marked), run.world(), marking, kAspect);
            Image picture;
            renderer.draw(scene, run.built(), view, run.time(), picture, overlay, marking);
            reported->picture = std::move(picture);
        }
    } catch (const RenderError& error) {
        report.picture_error = error.what();
    } catch (const PictureError& error) {  // of a body
        report.picture_error = error.what();
    }
}

}  // namespace tumble::tools
