// The notes of a scene, and its title card.
#pragma once

#include <optional>

#include "render/canvas/glyph_atlas.hpp"
#include "render/canvas/primitives.hpp"
#include "render/style/theme.hpp"
#include "render/view/view.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::render {

// Where a note is at a time: the world point below it. Nothing while it does not show, as before the body that it is
// above exists.
std::optional<DVec2> position_of(const SceneNote& note, const SceneWorld& world, double time);

// Adds the title card while it shows, and after it the notes that show and whose points are in view, moved into the
// frame where their texts reach out of it. Only if the frame has text.
void add_notes(DrawList& list, GlyphAtlas& atlas, const View& view, const SceneCamera& camera, const SceneWorld& world,
               double time, const Colors& colors);

}  // namespace tumble::render
