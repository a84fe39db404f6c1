#include "reference/families/pair_families.hpp"

#include <algorithm>
#include <vector>

#include "reference/families/family_lists.hpp"

namespace tumble::reference {

std::span<const PairFamily> pair_families() {
    static const std::vector<PairFamily> table = [] {
        std::vector<PairFamily> rows;
        for (const std::span<const PairFamily> list :
             {random_families(), gap_families(), touching_families(), thin_families(), scale_families(),
              extreme_families(), symmetric_families(), radius_families(), search_families()})
            rows.insert(rows.end(), list.begin(), list.end());
        return rows;
    }();
    return table;
}

const PairFamily* find_pair_family(std::string_view name) {
    const std::span<const PairFamily> families = pair_families();
    const auto found = std::ranges::find(families, name, &PairFamily::name);
    return found == families.end() ? nullptr : &*found;
}

}  // namespace tumble::reference
