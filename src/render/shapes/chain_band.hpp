// A band along the solid side of a chain, which fades with the distance from it.
#pragma once

#include <span>
#include <vector>

#include "render/canvas/primitives.hpp"
#include "render/view/view.hpp"

namespace tumble::render {

// Appends the band on the left of the chain's direction. Points in body coordinates (m).
void add_chain_band(std::vector<MeshVertex>& mesh, const View& view, std::span<const DVec2> points, bool is_loop,
                    const Pose& world_from_body, Color color);

}  // namespace tumble::render
