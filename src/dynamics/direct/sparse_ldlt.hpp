// The factorization L D L^T of a sparse symmetric matrix, D diagonal [Davis 2005, "Algorithm 849: A concise sparse
// Cholesky factorization package"].
//
// analyze() finds where L has entries; it is called once for each pattern. factorize() and solve() do not allocate, and
// their order of operations is fixed: the same numbers give the same bits in every build. The caller orders the rows
// so that L has few entries. JOINT_SYSTEM.md says why this is not Eigen's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble {

// The lower triangle without the diagonal, by rows: the entries of row k have the columns
// columns[row_starts[k]] ... columns[row_starts[k + 1] - 1], each less than k, in any order.
struct LowerPattern {
    std::vector<std::uint32_t> row_starts{0};
    std::vector<std::uint32_t> columns;

    std::size_t row_count() const { return row_starts.size() - 1; }
};

class SparseLdlt {
public:
    void analyze(const LowerPattern& pattern);

    // `entries` are those of the pattern, `diagonal` one for each row. A row that depends on the rows before it, so
    // that its pivot is less than kDependentPart of its diagonal, is left out: its unknown is 0.
    void factorize(const LowerPattern& pattern, std::span<const double> entries, std::span<const double> diagonal);

    // Replaces the right side by the solution.
    void solve(std::span<double> x) const;

    std::size_t entry_count() const { return rows_.size(); }  // of L
    std::size_t bytes() const;

private:
    std::vector<std::uint32_t> column_starts_{0};  // into rows_ and values_
    std::vector<std::uint32_t> rows_;              // of the entries of L by columns, ascending
    std::vector<double> values_;
    std::vector<std::uint32_t> row_starts_{0};  // into columns_
    std::vector<std::uint32_t> columns_;        // of the entries of L by rows, ascending
    std::vector<double> inverse_pivots_;        // 0 for a row that is left out
    std::vector<double> work_;
    std::vector<std::uint32_t> filled_;  // by column: the end of the entries that are computed
};

}  // namespace tumble
