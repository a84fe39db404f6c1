// The first claim of a scene after some steps of its run.
#pragma once

#include "tumble/scene.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::test {

inline ExpectationResult judge(const Scene& scene, int steps) {
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    for (int i = 0; i < steps; ++i) {
        run.step();
        watch.observe(run.built());
    }
    return watch.results().at(0);
}

}  // namespace tumble::test
