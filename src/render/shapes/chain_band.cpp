#include "render/shapes/chain_band.hpp"

#include <algorithm>

#include "render/shapes/mitre.hpp"
#include "render/style/style.hpp"

namespace tumble::render {

void add_chain_band(std::vector<MeshVertex>& mesh, const View& view, std::span<const DVec2> points, bool is_loop,
                    const Pose& pose, Color color) {
    std::vector<DVec2> line;
    line.reserve(points.size());
    for (const DVec2 point : points) line.push_back(view.to_pixels(transform_point(pose, point)));
    const std::vector<DVec2> mitre = mitres(line, is_loop);
    const double width = std::min(style::kBand * view.detail(), style::kBandMetres * view.scale);
    const Color solid = faded(color, style::kBandOpacity), clear = faded(color, 0.0);

    const auto vertex = [&](std::size_t i, bool is_far) {
        constexpr float kInside = -1e3f;  // so deep that the shader blends no edge: only the colours fade
        const DVec2 at = is_far ? line[i] - width * mitre[i] : line[i];
        return MeshVertex{static_cast<float>(at.x), static_cast<float>(at.y), kInside, flat(is_far ? clear : solid)};
    };
    for (std::size_t i = 0; i + (is_loop ? 0 : 1) < line.size(); ++i) {
        const std::size_t next = (i + 1) % line.size();
        const double reach = 0.5 * length(line[next] - line[i]) + 4.0 * width;
        if (!view.is_in_view(0.5 * (line[i] + line[next]), reach)) continue;
        const MeshVertex corners[4] = {vertex(i, false), vertex(next, false), vertex(i, true), vertex(next, true)};
        for (const int corner : {0, 1, 2, 2, 1, 3}) mesh.push_back(corners[corner]);
    }
}

}  // namespace tumble::render
