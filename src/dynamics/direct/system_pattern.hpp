// Which rows of joints act on each other: the order of their elimination, the entries of A = J M^-1 J^T below its
// diagonal, and the components, sets of rows that share no body with others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/direct/sparse_ldlt.hpp"

namespace tumble {

// The solver bodies that an impulse along a row moves, by its ends; 0, the static body, where there is none.
using RowCoupling = std::array<std::uint32_t, 4>;

// The product of two ends at one body: a part of an entry of A, or of its diagonal if both are ends of one row.
struct EntryTerm {
    static constexpr std::uint32_t kDiagonal = 0xffffffffu;

    std::uint32_t row = 0, other = 0;  // positions, other <= row
    std::uint32_t end = 0, other_end = 0;
    std::uint32_t entry = kDiagonal;  // of `lower`
};

struct SystemPattern {
    std::vector<RowCoupling> couplings;        // by row as listed
    std::vector<std::uint32_t> positions;      // by row as listed: its position in the order of elimination
    std::vector<EntryTerm> terms;              // sorted by row and other
    LowerPattern lower;                        // by position
    std::vector<std::uint32_t> bodies;         // the solver bodies that the rows move, ascending
    std::vector<std::uint32_t> components;     // by index in `bodies`
    std::vector<std::uint32_t> row_component;  // by position; component_count for a row that moves no body
    std::size_t component_count = 0;

    // Derives everything from `couplings`. Allocates.
    void analyze();

    std::size_t bytes() const;
};

}  // namespace tumble
