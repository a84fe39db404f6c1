// Which revolute joints are solved eight at a time (revolute_block.hpp), and in which order all of them are solved.
//
// The order gives the result of solving one joint after the other: joints of a body follow each other as in the list. A
// joint's level is one more than the highest level of the joints before it that move one of its bodies, so that joints
// of a level share no body that they move. A level is divided into lanes; joints that are left over, and those that no
// lanes can solve, are solved alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/joint_store/joint_blocks.hpp"
#include "dynamics/joints/revolute_joint.hpp"
#include "tasks/crew.hpp"

namespace tumble {

struct RevoluteBlock;

class RevoluteLanes {
public:
    // Not inline: whoever includes this header does not need RevoluteBlock.
    RevoluteLanes();
    ~RevoluteLanes();
    RevoluteLanes(const RevoluteLanes&);
    RevoluteLanes(RevoluteLanes&&) noexcept;
    RevoluteLanes& operator=(const RevoluteLanes&);
    RevoluteLanes& operator=(RevoluteLanes&&) noexcept;

    // A joint of the list.
    struct Entry {
        std::uint32_t slot = 0;  // in the array of joints
        bool fits_lanes = false;
    };

    // Finds the order anew. `order` has the blocks of the list, whose joints `entries` describes.
    void find(const JointBlocks& order, std::span<const Entry> entries, std::span<const RevoluteJoint> joints,
              const BodyStore& bodies);

    // False if no joint is solved in lanes: the order is that of the list.
    bool is_used() const { return !lanes_.empty(); }

    // Whether the joint at a position in the list is in a lane.
    bool is_in_lanes(std::size_t position) const { return is_in_lanes_[position]; }

    // Copies prepared joints into their lanes, and their impulses back. `h` is the sub-step, s.
    void load(std::span<const RevoluteJoint> joints, const BodyStore& bodies, float h, Crew& crew);
    void store(std::span<RevoluteJoint> joints, Crew& crew) const;

    // Calls solve_block(RevoluteBlock&) and solve_one(i), with the position in the list, in the order. Threads share
    // the work.
    template <class Self, class SolveBlock, class SolveOne>
    static void for_each(Self& self, Crew& crew, SolveBlock&& solve_block, SolveOne&& solve_one) {
        for (const Range& color : self.colors_)
            crew.for_each(color.end - color.begin, 1, [&](std::size_t i) {
                const Range& bundle = self.bundles_[color.begin + i];
                for (std::uint32_t k = bundle.begin; k < bundle.end; ++k) {
                    const Item item = self.items_[k];
                    if (item.is_block)
                        solve_block(self.blocks_[item.index]);
                    else
                        solve_one(item.index);
                }
            });
    }

    std::size_t bytes() const;  // allocated

private:
    struct Range {
        std::uint32_t begin = 0, end = 0;
    };
    struct Item {
        std::uint32_t index = 0;  // of a block, or in the list
        bool is_block = false;
    };
    // A joint of a bundle, in the order of solving.
    struct Placed {
        std::uint32_t level = 0;
        std::uint32_t kind = 0;      // joints with equal ones may be lanes of a block
        std::uint32_t position = 0;  // in the list

        friend constexpr auto operator<=>(const Placed&, const Placed&) = default;
    };

    // Copies eight prepared joints into a block, which has the parts of their drives.
    static void write_lanes(RevoluteBlock& block, const RevoluteJoint* const joints[], float h);
    static void write_lane(RevoluteBlock& block, int lane, const RevoluteJoint& joint, float h);

    void add_bundle(const JointBlocks& order, std::span<const std::uint32_t> of, std::span<const Entry> entries,
                    std::span<const RevoluteJoint> joints, const BodyStore& bodies);
    void add_alike(std::span<const Placed> alike, std::span<const Entry> entries);

    std::vector<Range> colors_;   // of bundles
    std::vector<Range> bundles_;  // of items: those of a colour have no body in common
    std::vector<Item> items_;
    std::vector<RevoluteBlock> blocks_;
    std::vector<bool> is_in_lanes_;      // by position in the list
    std::vector<std::uint32_t> lanes_;   // the slots of the joints of each block, kLaneCount each
    std::vector<std::uint32_t> levels_;  // by body index: the lowest free one; 0 between calls
    std::vector<Placed> placed_;         // scratch of add_bundle()
};

}  // namespace tumble
