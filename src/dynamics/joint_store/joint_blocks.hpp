// Which joints of one kind are solved at the same time.
//
// The joints of a kind are divided into blocks of kJointsPerBlock, in their order. Blocks of one colour have no body in
// common, so that threads may share them; colours follow one another. Within a block the joints are solved in their
// order: along a chain that converges faster than colours of single joints, and a world with fewer joints is solved in
// the same way. All static bodies count as one, as they are one solver body, and solving a joint writes the velocities
// of both its bodies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/joint_store/joined_bodies.hpp"
#include "tasks/crew.hpp"

namespace tumble {

// About 20 us of work in each pass. Smaller: ragdolls and chains are divided too, which then converge in another way.
inline constexpr std::size_t kJointsPerBlock = 512;

class JointBlocks {
public:
    // Finds the blocks and colours of `count` joints anew. bodies_of(i) gives the bodies of the i-th.
    template <class BodiesOf>
    void find(std::size_t count, const BodyStore& bodies, BodiesOf&& bodies_of) {
        begin(count, bodies.frames.size());
        const auto colors_of = [&](std::uint32_t body) -> std::uint64_t& {
            const bool is_static = bodies.frames[body].type == BodyType::static_body;
            return is_static ? colors_of_.back() : colors_of_[body];
        };
        for (std::size_t block = 0; block < block_count() && block_count() > 1; ++block) {
            std::uint64_t taken = 0;
            for_each_body(block, bodies_of, [&](std::uint32_t body) { taken |= colors_of(body); });
            const std::uint64_t own = color_block(block, taken);
            for_each_body(block, bodies_of, [&](std::uint32_t body) { colors_of(body) |= own; });
        }
    }

    // False if a single block contains all joints.
    bool is_divided() const { return count_ > kJointsPerBlock; }

    // Calls solve(first, end) for the joints of each block. Threads share the blocks of a colour. Only for joints that
    // are divided.
    template <class Solve>
    void for_each(Crew& crew, Solve&& solve) const {
        for (const std::vector<std::uint32_t>& color : colors_)
            crew.for_each(color.size(), 1, [&](std::size_t i) { solve(first(color[i]), first(color[i] + 1)); });
    }

    // Calls visit(blocks) for each colour, also for the colour of a single block.
    template <class Visitor>
    void for_each_color(Visitor&& visit) const {
        static constexpr std::uint32_t kOnly = 0;
        if (count_ > 0 && !is_divided()) return visit(std::span(&kOnly, 1));
        for (const std::vector<std::uint32_t>& color : colors_) visit(std::span(color));
    }

    // The position in the list of the first joint of a block.
    std::size_t first(std::size_t block) const { return std::min(block * kJointsPerBlock, count_); }

    std::size_t bytes() const;  // allocated

private:
    std::size_t block_count() const { return (count_ + kJointsPerBlock - 1) / kJointsPerBlock; }
    void begin(std::size_t count, std::size_t body_count);

    // Gives a block the first colour that is not taken, and returns that as a bit. If all are taken, the block gets a
    // colour for itself alone.
    std::uint64_t color_block(std::size_t block, std::uint64_t taken);

    template <class BodiesOf, class Visitor>
    void for_each_body(std::size_t block, BodiesOf&& bodies_of, Visitor&& visit) const {
        for (std::size_t i = first(block); i < first(block + 1); ++i)
            for (const BodyId body : bodies_of(i)) visit(body.index);
    }

    std::size_t count_ = 0;
    std::vector<std::vector<std::uint32_t>> colors_;  // the blocks of each; of a single block none
    // By body index, of the blocks that it has joints in; the last one is that of all static bodies.
    std::vector<std::uint64_t> colors_of_;
};

}  // namespace tumble
