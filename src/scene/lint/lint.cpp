#include "scene/lint/lint.hpp"

#include "scene/build/build.hpp"

namespace tumble::scene {

void add_lints(const Scene& scene, const ResolvedScene& resolved, Diagnostics& diagnostics) {
    SceneWorld started = build_world(scene, resolved, Start::at_rest, diagnostics);
    add_body_lints(scene, diagnostics);
    add_motion_lints(scene, started, diagnostics);
    add_joint_lints(scene, started, diagnostics);
    add_chain_lints(scene, started, diagnostics);
    add_run_lints(scene, diagnostics);
    // At rest, the first step finds every contact at the poses of the file.
    started.world.step();
    add_contact_lints(scene, started, diagnostics);
}

}  // namespace tumble::scene
