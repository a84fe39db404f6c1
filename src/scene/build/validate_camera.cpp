#include "scene/build/validate_camera.hpp"

#include "scene/build/element.hpp"

namespace tumble::scene {

namespace {

void validate_keys(const SceneCamera& camera, const References& references, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < camera.keys.size(); ++i) {
        const std::string pointer = element("/camera/keys", i);
        for (std::size_t k = 0; k < camera.keys[i].follow.size(); ++k)
            references.any_body(camera.keys[i].follow[k], pointer + "/follow", std::to_string(k));
        if (i > 0 && camera.keys[i].time <= camera.keys[i - 1].time)
            diagnostics.error(pointer + "/time", "must be after the time of the key frame before");
    }
}

void validate_notes(const SceneCamera& camera, const References& references, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < camera.notes.size(); ++i) {
        const SceneNote& note = camera.notes[i];
        const std::string pointer = element("/camera/notes", i);
        if (!note.above.empty()) references.any_body(note.above, pointer, "above");
        if (note.until && *note.until <= note.from) diagnostics.error(pointer + "/until", "must be after 'from'");
    }
}

}  // namespace

void validate_camera(const SceneCamera& camera, const References& references, Diagnostics& diagnostics) {
    if (!camera.follow.empty()) references.any_body(camera.follow, "/camera", "follow");
    validate_keys(camera, references, diagnostics);
    validate_notes(camera, references, diagnostics);
}

}  // namespace tumble::scene
