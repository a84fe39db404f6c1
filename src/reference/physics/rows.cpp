#include "reference/physics/rows.hpp"

#include <algorithm>

#include "reference/physics/row_lists.hpp"

namespace tumble::reference {

const std::vector<PhysicsRow>& physics_rows() {
    static const std::vector<PhysicsRow> rows = [] {
        std::vector<PhysicsRow> all;
        for (const auto& list : {friction_rows(), impact_rows(), continuous_rows(), joint_rows(), ragdoll_rows(),
                                 pile_rows(), flight_rows()})
            all.insert(all.end(), list.begin(), list.end());
        std::ranges::stable_sort(all, {}, [](const PhysicsRow& row) { return row.name; });
        return all;
    }();
    return rows;
}

const PhysicsRow* find_physics_row(std::string_view name) {
    const auto found = std::ranges::find(physics_rows(), name, &PhysicsRow::name);
    return found == physics_rows().end() ? nullptr : &*found;
}

}  // namespace tumble::reference
