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
        if (block.inv_mass_ax[lane] + block.inv_mass_ay[lane] + block.inv_inertia_a[lane] > 0.0f)
            moved.push_back(block.body_a[lane]);
        if (block.inv_mass_bx[lane] + block.inv_mass_by[lane] + block.inv_inertia_b[lane] > 0.0f)
            moved.push_back(block.body_b[lane]);
    }
    std::sort(moved.begin(), moved.end());
    return moved;
}

}  // namespace

ContactSolver::ContactSolver() = default;
ContactSolver::~ContactSolver() = default;
ContactSolver::ContactSolver(ContactSolver&&) noexcept = default;
ContactSolver& ContactSolver::operator=(ContactSolver&&) noexcept = default;

void ContactSolver::prepare(std::span<const Contact> contacts, const BodyStore& bodies, const Tuning& tuning,
                            Vec2 gravity, float h) {
    graph_.build(contacts, bodies);
    prepare_contacts(contacts, bodies, graph_, tuning, gravity, h, blocks_);
    TUMBLE_CHECK(blocks_.size() == graph_.block_count());
}

void ContactSolver::warm_start(std::span<SolverBody> bodies) { warm_start_contacts(blocks_, bodies); }

void ContactSolver::solve(std::span<SolverBody> bodies, float inv_h, float push_out_speed) {
    solve_contacts(blocks_, bodies, inv_h, push_out_speed);
}

void ContactSolver::relax(std::span<SolverBody> bodies, float inv_h, FrictionBound bound) {
    relax_contacts(blocks_, bodies, inv_h, bound);
}

void ContactSolver::apply_restitution(std::span<SolverBody> bodies, float threshold, float h) {
    TUMBLE_CHECK(threshold >= 0.0f);
    tumble::apply_restitution(blocks_, bodies, threshold, h, returned_work_);
}

void ContactSolver::store_impulses(std::span<Contact> contacts, std::span<SolverBody> bodies) const {
    TUMBLE_CHECK(blocks_.size() == graph_.block_count());
    tumble::store_impulses(blocks_, graph_, contacts, bodies);
}

std::size_t ContactSolver::bytes() const {
    return graph_.bytes() + blocks_.capacity() * sizeof(ContactBlock) + returned_work_.capacity() * sizeof(float);
}

void ContactSolver::audit() const {
    if (blocks_.size() != graph_.block_count())
        throw std::logic_error("contact solver: " + std::to_string(blocks_.size()) + " blocks, but the graph has " +
                               std::to_string(graph_.block_count()));
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const std::vector<std::uint32_t> moved = moved_bodies(blocks_[i]);
        if (std::adjacent_find(moved.begin(), moved.end()) != moved.end())
            throw std::logic_error("contact solver: block " + std::to_string(i) + " moves a body twice");
    }
}

}  // namespace tumble
