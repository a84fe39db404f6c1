#include "render/view/motion_preview.hpp"

#include "debug/check.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::render {
namespace {

constexpr std::size_t kBodyStepBudget = 50000;  // 0.06 s
constexpr std::size_t kMostBodies = 2500;       // more would leave less than 20 steps in the budget
constexpr std::uint64_t kStride = 4;            // steps between two records

// Adds the present bounds of the bodies. The index into SceneWorld::bodies identifies a body: entries are only
// appended.
void record(const SceneWorld& built, std::vector<MotionBounds>& motions) {
    TUMBLE_CHECK(motions.size() <= built.bodies.size());
    motions.resize(built.bodies.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const BodyId id = built.bodies[i].id;
        if (!built.world.is_valid(id) || built.world.type(id) == BodyType::static_body) continue;
        const Box now = box_of(built.world, id);
        if (motions[i].start.is_empty()) motions[i].start = now;
        motions[i].body = i;
        motions[i].whole.add(now);
    }
}

void run(const Scene& scene, std::vector<MotionBounds>& motions) {
    SceneRun run(scene);
    record(run.built(), motions);
    const std::uint64_t steps = count_steps(scene);
    std::size_t left = kBodyStepBudget;
    for (std::uint64_t step = 1; step <= steps && !run.is_stopped() && run.built().bodies.size() <= left; ++step) {
        left -= run.built().bodies.size();
        const std::size_t bodies_before = motions.size();
        run.step();
        if (step % kStride == 0 || step == steps || run.built().bodies.size() > bodies_before)
            record(run.built(), motions);
    }
}

}  // namespace

std::vector<MotionBounds> preview_motion(const Scene& scene) {
    std::vector<MotionBounds> motions;
    if (count_bodies(scene) > kMostBodies) return motions;
    // A preview that fails keeps what it has recorded. The actual run reports the error.
    try {
        run(scene, motions);
    } catch (const SceneError&) {          // the world refuses a body of the timeline
    } catch (const SimulationDiverged&) {  // a state is not finite
    }
    std::erase_if(motions, [](const MotionBounds& motion) { return motion.start.is_empty(); });
    return motions;
}

}  // namespace tumble::render
