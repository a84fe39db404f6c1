#include "scene/build/validate.hpp"

#include "scene/build/element.hpp"
#include "scene/build/references.hpp"
#include "scene/build/resolve.hpp"
#include "scene/build/validate_body.hpp"
#include "scene/build/validate_camera.hpp"
#include "scene/build/validate_claim.hpp"
#include "scene/build/validate_timeline.hpp"

namespace tumble::scene {

std::optional<ResolvedScene> validate_scene(const Scene& scene, const SceneSizes& own, Diagnostics& diagnostics) {
    std::optional<ResolvedScene> resolved = resolve(scene, own, diagnostics);
    if (!resolved) return resolved;
    for (std::size_t i = 0; i < own.bodies; ++i) validate_body(scene.bodies[i], element("/bodies", i), diagnostics);
    const References references(scene, *resolved, diagnostics);
    validate_timeline(scene, own, references, diagnostics);
    for (std::size_t i = 0; i < own.expect; ++i)
        validate_claim(scene.expect[i], element("/expect", i), references, diagnostics);
    validate_camera(scene.camera, references, diagnostics);
    return resolved;
}

}  // namespace tumble::scene
