// The links of a chain: for each segment the end points of its neighbours.
#include "debug/check.hpp"
#include "shape/arguments.hpp"
#include "tumble/chain.hpp"

namespace tumble {

std::vector<ChainLink> make_chain_links(std::span<const Vec2> points, bool loop, bool one_sided) {
    require_points(points, 2);
    const std::size_t count = points.size(), segments = loop ? count : count - 1;
    TUMBLE_CHECK(segments >= 1);
    std::vector<ChainLink> links(segments);
    for (std::size_t i = 0; i < segments; ++i) {
        links[i].has_before = loop || i > 0;
        links[i].has_after = loop || i + 2 < count;
        if (links[i].has_before) links[i].before = points[i > 0 ? i - 1 : count - 1];
        if (links[i].has_after) links[i].after = points[i + 2 < count ? i + 2 : i + 2 - count];
        links[i].one_sided = one_sided;
    }
    return links;
}

}  // namespace tumble
