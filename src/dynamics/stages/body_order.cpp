#include "dynamics/stages/body_order.hpp"

#include <algorithm>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/state/simulation.hpp"

namespace tumble {

namespace {

constexpr std::size_t kLeastOrdered = 512;

// True if most pairs of dynamic bodies that touch are in different sixteenths of the solver bodies. Along the curve it
// is a fifth of them, in a pile of boxes that was built layer by layer a third.
bool are_scattered(const Simulation& simulation) {
    const BodyStore& bodies = simulation.bodies;
    const std::size_t part_size = bodies.solver_bodies.size() / 16 + 1;
    const std::vector<Contact>& contacts = simulation.contacts.all();
    std::size_t pairs = 0, far = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        prefetch_after(contacts, i, 1);
        if (contacts[i].manifold.point_count == 0) continue;
        const std::uint32_t a = bodies.frames[contacts[i].body_a].solver_body;
        const std::uint32_t b = bodies.frames[contacts[i].body_b].solver_body;
        if (a == kStaticSolverBody || b == kStaticSolverBody) continue;
        ++pairs;
        far += a / part_size != b / part_size;
    }
    return 2 * far > pairs;
}

// The 32 bits of x in the even bits of the result.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 16) & 0x0000ffff0000ffffull;
    x = (x | x << 8) & 0x00ff00ff00ff00ffull;
    x = (x | x << 4) & 0x0f0f0f0f0f0f0f0full;
    x = (x | x << 2) & 0x3333333333333333ull;
    return (x | x << 1) & 0x5555555555555555ull;
}

// The number of a point's cell along the curve. What is farther than 8000 km from the origin is in the outermost cells.
std::uint64_t cell_on_curve(DVec2 point) {
    constexpr double kCellsPerMeter = 256.0;
    const auto cell = [](double x) {
        return static_cast<std::uint64_t>(std::clamp(x * kCellsPerMeter + 0x1p31, 0.0, 0x1p32 - 1.0));
    };
    return spread_bits(cell(point.x)) | spread_bits(cell(point.y)) << 1;
}

struct PlacedBody {
    std::uint64_t cell = 0;
    std::uint32_t solver_body = 0;

    friend auto operator<=>(const PlacedBody&, const PlacedBody&) = default;
};

}  // namespace

void order_bodies(Simulation& simulation) {
    BodyStore& bodies = simulation.bodies;
    if (bodies.solver_bodies.size() < kLeastOrdered || !are_scattered(simulation)) return;
    std::vector<PlacedBody> placed;
    placed.reserve(bodies.solver_bodies.size());
    for (std::uint32_t i = kStaticSolverBody + 1; i < bodies.solver_bodies.size(); ++i)
        placed.push_back({cell_on_curve(bodies.frames[bodies.moving[i].body].center), i});
    std::sort(placed.begin(), placed.end());
    std::vector<std::uint32_t> order{kStaticSolverBody};
    order.reserve(bodies.solver_bodies.size());
    for (const PlacedBody& body : placed) order.push_back(body.solver_body);
    bodies.reorder(order);
}

}  // namespace tumble
