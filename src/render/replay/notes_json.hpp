// The notes of a scene, which the page shows over the bodies.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "tumble/scene.hpp"

namespace tumble::render {

// Of each note its `text`, `from` and `until` in s (null: the end of the run), and either `position`, [x, y] in m, or
// `above`, the name of a body.
nlohmann::ordered_json notes_json(std::span<const SceneNote> notes);

}  // namespace tumble::render
