#include "dynamics/contacts/contact_solver.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "debug/check.hpp"
#include "dynamics/contacts/contact_block.hpp"

namespace tumble {

namespace {

// The solver bodies that a block moves, sorted.
std::vector<std::uint32_t> moved_bodies(const ContactBlock& block) {
    std::vector<std::uint32_t> moved;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        if (block.moved_a >> lane & 1) moved.push_back(block.body_a[lane].index());
        if (block.moved_b >> lane & 1) moved.push_back(block.body_b[lane].index());
    }
    std::sort(moved.begin(), moved.end());
    return moved;
}

}  // namespace

ContactSolver::ContactSolver() = default;
ContactSolver::~ContactSolver() = default;
ContactSolver::ContactSolver(ContactSolver&&) noexcept = default;
ContactSolver& ContactSolver::operator=(ContactSolver&&) noexcept = default;

template <class SolveBlocks>
void ContactSolver::for_each_color(const Region& region, Crew& crew, SolveBlocks&& solve_blocks) {
    constexpr std::size_t kLeastSolved = 48;  // in a chunk: about 3 us of work
    const std::span<ContactBlock> blocks = blocks_;
    for (const ConstraintGraph::Color& color : graph_.colors(region)) {
        const std::span<ContactBlock> own = blocks.subspan(color.begin, color.end - color.begin);
        if (!color.is_independent) {
            solve_blocks(own);
            continue;
        }
        crew.for_each_chunk(own.size(), kLeastSolved, [&](const Chunk& chunk) {
            solve_blocks(own.subspan(chunk.begin, chunk.end - chunk.begin));
        });
    }
}

void ContactSolver::prepare(std::span<const Contact> contacts, const BodyStore& bodies, const Tuning& tuning,
                            Vec2 gravity, float h, BounceBy bounces, std::uint32_t least_region, Crew& crew) {
    graph_.build(contacts, bodies, crew, least_region);
    prepare_contacts(contacts, bodies, graph_, tuning, gravity, h, bounces, blocks_, extras_, crew);
    TUMBLE_CHECK(blocks_.size() == graph_.block_count());
}

void ContactSolver::warm_start(const Region& region, std::span<SolverBody> bodies, Crew& crew) {
    for_each_color(region, crew, [&](std::span<ContactBlock> blocks) { warm_start_contacts(blocks, bodies); });
}

void ContactSolver::solve(const Region& region, std::span<SolverBody> bodies, float inv_h, float push_out_speed,
                          Crew& crew) {
    for_each_color(region, crew,
                   [&](std::span<ContactBlock> blocks) { solve_contacts(blocks, bodies, inv_h, push_out_speed); });
}

void ContactSolver::relax(const Region& region, std::span<SolverBody> bodies, float inv_h, FrictionBound bound,
                          Crew& crew) {
    for_each_color(region, crew, [&](std::span<ContactBlock> blocks) { relax_contacts(blocks, bodies, inv_h, bound); });
}

void ContactSolver::apply_restitution(std::span<SolverBody> bodies, float threshold, float h, Crew& crew) {
    TUMBLE_CHECK(threshold >= 0.0f);
    if (std::none_of(blocks_.begin(), blocks_.end(), [](const ContactBlock& block) { return block.has_restitution; }))
        return;
    returned_work_.resize(bodies.size());
    find_returned_work(blocks_, returned_work_);
    for_each_region(crew, [&](const Region& region, Crew& own_crew) {
        for_each_color(region, own_crew, [&](std::span<ContactBlock> blocks) {
            tumble::apply_restitution(blocks, bodies, threshold, h, returned_work_);
        });
    });
}

void ContactSolver::store_impulses(std::span<Contact> contacts, std::span<SolverBody> bodies, Crew& crew) const {
    TUMBLE_CHECK(blocks_.size() == graph_.block_count());
    for_each_region(crew, [&](const Region& region, Crew& own_crew) {
        tumble::store_impulses(blocks_, graph_, region, contacts, bodies, own_crew);
    });
}

std::size_t ContactSolver::bytes() const {
    return graph_.bytes() + blocks_.capacity() * sizeof(ContactBlock) + extras_.capacity() * sizeof(ContactExtras) +
           returned_work_.capacity() * sizeof(float);
}

void ContactSolver::audit() const {
    graph_.audit();
    if (blocks_.size() != graph_.block_count())
        throw std::logic_error("contact solver: " + std::to_string(blocks_.size()) + " blocks, but the graph has " +
                               std::to_string(graph_.block_count()));
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const std::vector<std::uint32_t> moved = moved_bodies(blocks_[i]);
        if (std::adjacent_find(moved.begin(), moved.end()) != moved.end())
            throw std::logic_error("contact solver: block " + std::to_string(i) + " moves a body twice");
    }
    for (const Region& region : graph_.regions()) {
        for (const ConstraintGraph::Color& color : graph_.colors(region))
            for (std::size_t i = color.begin; i < color.end; ++i)
                for (const std::uint32_t body : moved_bodies(blocks_[i]))
                    if (body < region.bodies.begin || body >= region.bodies.end)
                        throw std::logic_error("contact solver: block " + std::to_string(i) +
                                               " moves a body of another region");
    }
}

}  // namespace tumble
