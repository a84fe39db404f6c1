#include "render/view/run_ahead.hpp"

#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::render {
namespace {

constexpr std::size_t kMostBodySteps = 50000;  // 0.06 s
constexpr std::size_t kMostBodies = 2500;      // of more, too few steps would be seen to be worth making their world
constexpr std::uint64_t kStride = 4;           // steps from one look to the next

// Adds what the bodies cover now. Bodies are looked at by their place in SceneWorld::bodies, which stays.
void look(const SceneWorld& built, std::vector<BodyWay>& ways) {
    ways.resize(built.bodies.size());
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const BodyId id = built.bodies[i].id;
        if (!built.world.is_valid(id) || built.world.type(id) == BodyType::static_body) continue;
        const Box now = box_of(built.world, id);
        if (ways[i].first.is_empty()) ways[i].first = now;
        ways[i].all.add(now);
    }
}

void run(const Scene& scene, std::vector<BodyWay>& ways) {
    SceneRun run(scene);
    look(run.built(), ways);
    const std::uint64_t steps = count_steps(scene);
    std::size_t left = kMostBodySteps;
    for (std::uint64_t step = 1; step <= steps && run.built().bodies.size() <= left; ++step) {
        left -= run.built().bodies.size();
        const std::size_t known = ways.size();
        run.step();
        if (step % kStride == 0 || step == steps || run.built().bodies.size() > known) look(run.built(), ways);
    }
}

}  // namespace

std::vector<BodyWay> run_ahead(const Scene& scene) {
    std::vector<BodyWay> ways;
    if (count_bodies(scene) > kMostBodies) return ways;
    try {
        run(scene, ways);
    } catch (const SceneError&) {          // of a body that the world refuses when it is made,
    } catch (const SimulationDiverged&) {  // or of a state: who runs the scene in earnest will say so
    }
    std::erase_if(ways, [](const BodyWay& way) { return way.first.is_empty(); });
    return ways;
}

}  // namespace tumble::render
