#include "dynamics/stages/body_order.hpp"

#include <algorithm>
#include <vector>

#include "dynamics/state/simulation.hpp"

namespace tumble {

namespace {

// Fewer bodies fit in the cache of a core, whatever their order.
constexpr std::size_t kLeastOrdered = 512;

// Pairs of dynamic bodies that touch. Two bodies are far apart if they are in different parts of the solver bodies, by
// which the constraint graph groups the contacts of a colour.
struct TouchingPairs {
    std::size_t all = 0;
    std::size_t far = 0;
};

// position(i) is where the solver body i is, or would be.
template <class Position>
TouchingPairs count_pairs(const Simulation& simulation, Position&& position) {
    const BodyStore& bodies = simulation.bodies;
    const std::size_t part_size = bodies.solver_bodies.size() / ConstraintGraph::kParts + 1;
    const std::vector<Contact>& contacts = simulation.contacts.all();
    TouchingPairs pairs;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prefetch_after(contacts, i, 1);
        if (contacts[i].manifold.point_count == 0) continue;
        const std::uint32_t a = bodies.frames[contacts[i].body_a].solver_body;
        const std::uint32_t b = bodies.frames[contacts[i].body_b].solver_body;
        if (!(bodies.solver_bodies[a].flags & bodies.solver_bodies[b].flags & kDynamicBody)) continue;
        ++pairs.all;
        pairs.far += position(a) / part_size != position(b) / part_size;
    }
    return pairs;
}

// The 32 bits of x in the even bits of the result.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 16) & 0x0000ffff0000ffffull;
    x = (x | x << 8) & 0x00ff00ff00ff00ffull;
    x = (x | x << 4) & 0x0f0f0f0f0f0f0f0full;
    x = (x | x << 2) & 0x3333333333333333ull;
    return (x | x << 1) & 0x5555555555555555ull;
}

// The number of a point's cell along the curve. The outermost cells contain what is farther away than 2^31 cells.
std::uint64_t cell_on_curve(DVec2 point, double cell_size) {
    const auto cell = [cell_size](double x) {
        return static_cast<std::uint64_t>(std::min(std::max(0.0, x / cell_size + 0x1p31), 0x1p32 - 1.0));
    };
    return spread_bits(cell(point.x)) | spread_bits(cell(point.y)) << 1;
}

struct CellOfBody {
    std::uint64_t cell = 0;
    std::uint32_t solver_body = 0;

    friend auto operator<=>(const CellOfBody&, const CellOfBody&) = default;
};

// The solver bodies along the curve, after the static one.
std::vector<std::uint32_t> order_on_curve(const Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    const auto cell_size = static_cast<double>(simulation.settings.tuning.max_speculative_distance);
    std::vector<CellOfBody> cells;
    cells.reserve(bodies.solver_bodies.size());
    for (std::uint32_t i = kStaticSolverBody + 1; i < bodies.solver_bodies.size(); ++i)
        cells.push_back({cell_on_curve(bodies.frames[bodies.moving[i].body].center, cell_size), i});
    std::sort(cells.begin(), cells.end());
    std::vector<std::uint32_t> order{kStaticSolverBody};
    order.reserve(bodies.solver_bodies.size());
    for (const CellOfBody& cell : cells) order.push_back(cell.solver_body);
    return order;
}

}  // namespace

void order_bodies(Simulation& simulation) {
    if (simulation.bodies.solver_bodies.size() < kLeastOrdered) return;
    const TouchingPairs now = count_pairs(simulation, [](std::uint32_t i) { return i; });
    if (2 * now.far <= now.all) return;
    const std::vector<std::uint32_t> order = order_on_curve(simulation);
    std::vector<std::uint32_t> position(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) position[order[i]] = i;
    const TouchingPairs sorted = count_pairs(simulation, [&](std::uint32_t i) { return position[i]; });
    if (2 * sorted.far <= now.far) simulation.bodies.reorder(order);
}

}  // namespace tumble
