// The sparse factorization against the definition: A x = b, with A built from its entries.
#include "dynamics/direct/sparse_ldlt.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Sparse {
    LowerPattern pattern;
    std::vector<double> entries, diagonal;

    std::vector<double> times(const std::vector<double>& x) const {
        std::vector<double> product(x.size());
        for (std::uint32_t row = 0; row < x.size(); ++row) {
            product[row] += diagonal[row] * x[row];
            for (std::uint32_t p = pattern.row_starts[row]; p < pattern.row_starts[row + 1]; ++p) {
                product[row] += entries[p] * x[pattern.columns[p]];
                product[pattern.columns[p]] += entries[p] * x[row];
            }
        }
        return product;
    }
};

// A matrix that is positive definite, as each diagonal is larger than the sum of its row.
Sparse random_matrix(std::mt19937& random, std::uint32_t count, std::size_t per_thousand) {
    Sparse matrix;
    matrix.diagonal.assign(count, 1.0);
    for (std::uint32_t row = 0; row < count; ++row) {
        for (std::uint32_t column = 0; column < row; ++column) {
            if (random() % 1000 >= per_thousand) continue;
            const double value = static_cast<double>(random() % 2001) / 1000.0 - 1.0;
            matrix.pattern.columns.push_back(column);
            matrix.entries.push_back(value);
            matrix.diagonal[row] += std::abs(value);
            matrix.diagonal[column] += std::abs(value);
        }
        matrix.pattern.row_starts.push_back(static_cast<std::uint32_t>(matrix.pattern.columns.size()));
    }
    return matrix;
}

}  // namespace

TEST_CASE("a factorization solves random sparse systems") {
    std::mt19937 random(7);
    std::size_t filled = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Sparse matrix = random_matrix(random, 1 + static_cast<std::uint32_t>(random() % 40), random() % 300);
        SparseLdlt factor;
        factor.analyze(matrix.pattern);
        factor.factorize(matrix.pattern, matrix.entries, matrix.diagonal);
        std::vector<double> solution(matrix.diagonal.size());
        for (double& value : solution) value = static_cast<double>(random() % 1000);
        const std::vector<double> side = matrix.times(solution);
        std::vector<double> found = side;
        factor.solve(found);
        // The diagonal exceeds the rest of its row by 1, so the inverse has a norm of at most 1: the error is that of
        // the residual, some 40 roundings of entries up to 40 times 1000.
        for (std::size_t i = 0; i < found.size(); ++i)
            CHECK(near(found[i], solution[i], absolute(40 * 40e3 * 0x1p-53)));
        filled += factor.entry_count() > matrix.entries.size();
    }
    CHECK(filled > 60);  // many have entries that the matrix has not
    CHECK(filled < 190);
}

TEST_CASE("a row that depends on the rows before it is left out") {
    // The third row is the sum of the first two: (2, 0, 2), (0, 3, 3), (2, 3, 5).
    LowerPattern pattern;
    pattern.row_starts = {0, 0, 0, 2};
    pattern.columns = {0, 1};
    SparseLdlt factor;
    factor.analyze(pattern);
    factor.factorize(pattern, std::vector<double>{2.0, 3.0}, std::vector<double>{2.0, 3.0, 5.0});
    std::vector<double> x{4.0, 9.0, 13.0};
    factor.solve(x);
    CHECK(x == std::vector<double>{2.0, 3.0, 0.0});
}
