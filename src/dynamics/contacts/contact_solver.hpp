// The contacts of a step while they are solved: coloured, packed into blocks of lanes, solved, and unpacked.
//
// The blocks are an incomplete type here, so that only the solver's own sources parse the lanes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dynamics/contacts/constraint_graph.hpp"
#include "tasks/crew.hpp"

namespace tumble {

struct ContactBlock;
struct ContactExtras;
enum class FrictionBound : std::uint8_t;
enum class BounceBy : std::uint8_t;

class ContactSolver {
public:
    ContactSolver();
    ~ContactSolver();
    ContactSolver(ContactSolver&&) noexcept;
    ContactSolver& operator=(ContactSolver&&) noexcept;

    // Once a step, with poses and velocities of its start. `h` is the length of a sub-step, s.
    void prepare(std::span<const Contact> contacts, const BodyStore& bodies, const Tuning& tuning, Vec2 gravity,
                 float h, BounceBy bounces, std::uint32_t least_region, Crew& crew);

    using Region = ConstraintGraph::Region;

    // Calls work(region, crew) for each region: at the same time, each with a crew of one thread, or if a region is too
    // large for that, one after the other, each with this crew.
    template <class Work>
    void for_each_region(Crew& crew, Work&& work) const {
        const std::span<const Region> regions = graph_.regions();
        if (!graph_.has_even_regions(crew.thread_count())) {
            for (const Region& region : regions) work(region, crew);
            return;
        }
        crew.for_each(regions.size(), 1, [&](std::size_t i) {
            Crew alone;
            work(regions[i], alone);
        });
    }

    // In each sub-step of a region, in this order: see contact_block.hpp.
    void warm_start(const Region& region, std::span<SolverBody> bodies, Crew& crew);
    void solve(const Region& region, std::span<SolverBody> bodies, float inv_h, float push_out_speed, Crew& crew);
    void relax(const Region& region, std::span<SolverBody> bodies, float inv_h, FrictionBound bound, Crew& crew);

    // After the last sub-step; with BounceBy::solver.
    void apply_restitution(std::span<SolverBody> bodies, float threshold, float h, Crew& crew);
    void store_impulses(std::span<Contact> contacts, std::span<SolverBody> bodies, Crew& crew) const;

    const ConstraintGraph& graph() const { return graph_; }
    std::size_t bytes() const;

    // Throws std::logic_error if the blocks are not those of the graph, or if a block moves a body twice
    // or one of another region.
    void audit() const;

private:
    // Calls solve_blocks(blocks), colour by colour of a region; the blocks of a colour are divided among the crew.
    template <class SolveBlocks>
    void for_each_color(const Region& region, Crew& crew, SolveBlocks&& solve_blocks);

    ConstraintGraph graph_;
    std::vector<ContactExtras> extras_;  // by block
    std::vector<ContactBlock> blocks_;   // in the order of the graph
    std::vector<float> returned_work_;   // scratch of restitution: by solver body, J
};

}  // namespace tumble
