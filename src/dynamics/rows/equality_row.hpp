// A constraint row as the direct solver sees it: its ends at two to four bodies, its error, and where its impulse is
// stored. Every joint lists its equality constraints as such rows.
#pragma once

#include <array>
#include <span>

#include "dynamics/rows/coupled_row.hpp"
#include "dynamics/rows/joint_block.hpp"

namespace tumble {

struct EqualityRow {
    std::array<RowEnd, 4> ends;
    std::uint32_t end_count = 0;
    float error = 0.0f;          // m or rad; 0 where the constraint holds
    float* impulse = nullptr;    // of the joint, N s or N m s
    float dead_response = 0.0f;  // dead_response() of the row; 0 if no body is locked along an axis
};

inline EqualityRow make_equality(const JointBodies& joint, const JointRow& row, float error, float& impulse) {
    const std::array<RowEnd, 2> ends = row_ends(joint, row);
    return {{ends[0], ends[1]}, 2, error, &impulse, dead_response(joint, row)};
}

inline EqualityRow make_equality(const CoupledBodies& joint, const CoupledRow& row, float error, float& impulse) {
    const std::array<RowEnd, 2> first = row_ends(joint.first, row.first);
    const std::array<RowEnd, 2> second = row_ends(joint.second, joint.ratio * row.second);
    return {{first[0], first[1], second[0], second[1]}, 4, error, &impulse, dead_response(joint, row)};
}

// Calls visit(row) for each row of a block.
template <class Block, class Visitor>
void visit_block(const JointBodies& joint, const Block& block, Vec2 error, Vec2& impulse, Visitor&& visit) {
    visit(make_equality(joint, block.first_row(), error.x, impulse.x));
    visit(make_equality(joint, block.second_row(), error.y, impulse.y));
}

// Calls visit(row) for both rows of a point constraint at the given deltas of the bodies.
template <class Visitor>
void visit_point(const JointBodies& joint, std::span<const SolverBody> all, Vec2& impulse, Visitor&& visit) {
    const PointBlock block = PointBlock::make(joint, all);
    visit_block(joint, block, block.separation(joint, all), impulse, visit);
}

}  // namespace tumble
