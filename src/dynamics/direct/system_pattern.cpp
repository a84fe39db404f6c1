#include "dynamics/direct/system_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>

#include "debug/check.hpp"
#include "dynamics/bodies/solver_body.hpp"

namespace tumble {

namespace {

// A row at one of its bodies.
struct Use {
    std::uint32_t body = 0, row = 0, end = 0;

    friend constexpr auto operator<=>(Use, Use) = default;
};

std::vector<Use> sorted_uses(const std::vector<RowCoupling>& couplings, const std::vector<std::uint32_t>& number) {
    std::vector<Use> uses;
    for (std::size_t row = 0; row < couplings.size(); ++row)
        for (std::uint32_t end = 0; end < couplings[row].size(); ++end)
            if (couplings[row][end] != kStaticSolverBody) uses.push_back({couplings[row][end], number[row], end});
    std::sort(uses.begin(), uses.end());
    return uses;
}

// Calls visit(uses) with all uses of each body.
template <class Visitor>
void for_each_body(std::span<const Use> uses, Visitor&& visit) {
    for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
        while (last < uses.size() && uses[last].body == uses[first].body) ++last;
        visit(uses.subspan(first, last - first));
    }
}

// The position of each row in an order of minimum degree [Amestoy, Davis, Duff 1996, by Eigen].
std::vector<std::uint32_t> elimination_order(const std::vector<RowCoupling>& couplings) {
    std::vector<std::uint32_t> positions(couplings.size());
    std::iota(positions.begin(), positions.end(), 0u);
    const int count = static_cast<int>(couplings.size());
    std::vector<Eigen::Triplet<float, int>> entries;
    for (int row = 0; row < count; ++row) entries.emplace_back(row, row, 1.0f);
    for_each_body(sorted_uses(couplings, positions), [&](std::span<const Use> uses) {
        for (const Use& use : uses)
            for (const Use& other : uses)
                if (use.row != other.row)
                    entries.emplace_back(static_cast<int>(use.row), static_cast<int>(other.row), 1.0f);
    });
    Eigen::SparseMatrix<float, Eigen::ColMajor, int> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(matrix, order);
    TUMBLE_CHECK(order.size() == count);
    for (int position = 0; position < count; ++position)
        positions[static_cast<std::size_t>(order.indices()[position])] = static_cast<std::uint32_t>(position);
    return positions;
}

void list_terms(SystemPattern& pattern) {
    pattern.terms.clear();
    for_each_body(sorted_uses(pattern.couplings, pattern.positions), [&](std::span<const Use> uses) {
        for (std::size_t i = 0; i < uses.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                pattern.terms.push_back({uses[i].row, uses[j].row, uses[i].end, uses[j].end});
    });
    std::stable_sort(pattern.terms.begin(), pattern.terms.end(), [](const EntryTerm& a, const EntryTerm& b) {
        return a.row != b.row ? a.row < b.row : a.other < b.other;
    });
}

void list_entries(SystemPattern& pattern) {
    LowerPattern& lower = pattern.lower;
    lower.row_starts.assign(pattern.couplings.size() + 1, 0);
    lower.columns.clear();
    const EntryTerm* before = nullptr;
    for (EntryTerm& term : pattern.terms) {
        TUMBLE_CHECK(term.other <= term.row);
        if (term.other == term.row) continue;
        const bool is_new = before == nullptr || before->row != term.row || before->other != term.other;
        if (is_new) {
            lower.columns.push_back(term.other);
            ++lower.row_starts[term.row + 1];
        }
        term.entry = static_cast<std::uint32_t>(lower.columns.size() - 1);
        before = &term;
    }
    std::partial_sum(lower.row_starts.begin(), lower.row_starts.end(), lower.row_starts.begin());
}

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
}

std::uint32_t body_index(const SystemPattern& pattern, std::uint32_t body) {
    const auto found = std::lower_bound(pattern.bodies.begin(), pattern.bodies.end(), body);
    TUMBLE_CHECK(found != pattern.bodies.end());
    TUMBLE_CHECK(*found == body);
    return static_cast<std::uint32_t>(found - pattern.bodies.begin());
}

void find_components(SystemPattern& pattern) {
    std::vector<std::uint32_t> parent(pattern.bodies.size());
    std::iota(parent.begin(), parent.end(), 0u);
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> first_body(pattern.couplings.size(), kNone);
    for (std::size_t row = 0; row < pattern.couplings.size(); ++row) {
        const std::uint32_t* first = nullptr;
        for (const std::uint32_t& body : pattern.couplings[row]) {
            if (body == kStaticSolverBody) continue;
            if (first == nullptr) first = &body;
            parent[root(parent, body_index(pattern, body))] = root(parent, body_index(pattern, *first));
        }
        if (first != nullptr) first_body[row] = body_index(pattern, *first);
    }
    std::vector<std::uint32_t> number(parent.size(), 0);
    pattern.component_count = 0;
    for (std::uint32_t i = 0; i < parent.size(); ++i)
        if (parent[i] == i) number[i] = static_cast<std::uint32_t>(pattern.component_count++);
    pattern.components.resize(parent.size());
    for (std::uint32_t i = 0; i < parent.size(); ++i) pattern.components[i] = number[root(parent, i)];
    TUMBLE_CHECK(pattern.component_count <= pattern.bodies.size());
    pattern.row_component.assign(pattern.couplings.size(), static_cast<std::uint32_t>(pattern.component_count));
    for (std::size_t row = 0; row < first_body.size(); ++row)
        if (first_body[row] != kNone)
            pattern.row_component[pattern.positions[row]] = pattern.components[first_body[row]];
}

}  // namespace

void SystemPattern::analyze() {
    positions = elimination_order(couplings);
    list_terms(*this);
    list_entries(*this);
    bodies.clear();
    for_each_body(sorted_uses(couplings, positions),
                  [&](std::span<const Use> uses) { bodies.push_back(uses.front().body); });
    find_components(*this);
}

std::size_t SystemPattern::bytes() const {
    return couplings.capacity() * sizeof(RowCoupling) + terms.capacity() * sizeof(EntryTerm) +
           (positions.capacity() + lower.row_starts.capacity() + lower.columns.capacity() + bodies.capacity() +
            components.capacity() + row_component.capacity()) *
               sizeof(std::uint32_t);
}

}  // namespace tumble
