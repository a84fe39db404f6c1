#include "dynamics/direct/sparse_ldlt.hpp"

#include <algorithm>

#include "debug/check.hpp"

namespace tumble {

namespace {

// A pivot below this part of its diagonal is rounding: the arms and axes of rows are floats, with errors of 2^-24.
constexpr double kDependentPart = 1e-6;

constexpr std::uint32_t kNoParent = 0xffffffffu;

}  // namespace

// Row k of L has an entry in each column on the paths of the elimination tree from the entries of row k of the matrix
// up to k.
void SparseLdlt::analyze(const LowerPattern& pattern) {
    const std::uint32_t count = static_cast<std::uint32_t>(pattern.row_count());
    std::vector<std::uint32_t> parent(count, kNoParent), mark(count, kNoParent), sizes(count, 0);
    row_starts_.assign(1, 0);
    columns_.clear();
    TUMBLE_CHECK(pattern.row_starts.back() == pattern.columns.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        mark[k] = k;
        for (std::uint32_t p = pattern.row_starts[k]; p < pattern.row_starts[k + 1]; ++p)
            for (std::uint32_t i = pattern.columns[p]; mark[i] != k; i = parent[i]) {
                TUMBLE_CHECK(i < k);
                if (parent[i] == kNoParent) parent[i] = k;
                mark[i] = k;
                columns_.push_back(i);
                ++sizes[i];
            }
        std::sort(columns_.begin() + row_starts_[k], columns_.end());
        row_starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
    }
    column_starts_.assign(1, 0);
    for (const std::uint32_t size : sizes) column_starts_.push_back(column_starts_.back() + size);
    rows_.resize(columns_.size());
    std::vector<std::uint32_t> next(column_starts_.begin(), column_starts_.end() - 1);
    for (std::uint32_t k = 0; k < count; ++k)
        for (std::uint32_t p = row_starts_[k]; p < row_starts_[k + 1]; ++p) rows_[next[columns_[p]]++] = k;
    values_.resize(columns_.size());
    inverse_pivots_.resize(count);
    work_.assign(count, 0.0);
    filled_.resize(count);
}

// Row k of L solves L_k-1 D_k-1 l = a, with the rows above it and row k of the matrix.
void SparseLdlt::factorize(const LowerPattern& pattern, std::span<const double> entries,
                           std::span<const double> diagonal) {
    TUMBLE_CHECK(diagonal.size() == inverse_pivots_.size());
    TUMBLE_CHECK(entries.size() == pattern.columns.size());
    for (std::uint32_t k = 0; k < diagonal.size(); ++k) {
        filled_[k] = column_starts_[k];
        for (std::uint32_t p = pattern.row_starts[k]; p < pattern.row_starts[k + 1]; ++p)
            work_[pattern.columns[p]] = entries[p];
        double pivot = diagonal[k];
        for (std::uint32_t p = row_starts_[k]; p < row_starts_[k + 1]; ++p) {
            const std::uint32_t column = columns_[p];
            const double rest = work_[column];
            work_[column] = 0.0;
            std::uint32_t& end = filled_[column];
            for (std::uint32_t q = column_starts_[column]; q < end; ++q) work_[rows_[q]] -= values_[q] * rest;
            const double value = rest * inverse_pivots_[column];
            pivot -= value * rest;
            TUMBLE_CHECK(rows_[end] == k);
            values_[end++] = value;
        }
        inverse_pivots_[k] = pivot > kDependentPart * diagonal[k] ? 1.0 / pivot : 0.0;
    }
}

void SparseLdlt::solve(std::span<double> x) const {
    TUMBLE_CHECK(x.size() == inverse_pivots_.size());
    for (std::size_t k = 0; k < x.size(); ++k)
        for (std::uint32_t p = column_starts_[k]; p < column_starts_[k + 1]; ++p) x[rows_[p]] -= values_[p] * x[k];
    for (std::size_t k = x.size(); k-- > 0;) {
        double sum = x[k] * inverse_pivots_[k];
        for (std::uint32_t p = column_starts_[k]; p < column_starts_[k + 1]; ++p) sum -= values_[p] * x[rows_[p]];
        x[k] = sum;
    }
}

std::size_t SparseLdlt::bytes() const {
    return (column_starts_.capacity() + rows_.capacity() + row_starts_.capacity() + columns_.capacity() +
            filled_.capacity()) *
               sizeof(std::uint32_t) +
           (values_.capacity() + inverse_pivots_.capacity() + work_.capacity()) * sizeof(double);
}

}  // namespace tumble
