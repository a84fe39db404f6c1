// Visits the numbers of a value of any type: one traversal for writing, reading and counting memory.
//
// A visitor has leaf(number), shape(Shape), list(vector), optional(optional) and variant(variant). Classes with private
// members, and structs with C arrays, list their members in a static visit_members(self, visit), in an order that stays
// the same: snapshots have it. A list that leaves a member out does not compile.
#pragma once

#include <array>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "tumble/manifold.hpp"
#include "tumble/math.hpp"
#include "tumble/shape.hpp"
#include "tumble/threads.hpp"
#include "world/aggregate.hpp"

namespace tumble {

class BroadPhase;
class JointStore;

namespace detail {

template <class T>
inline constexpr int kTemplate = 0;
template <class T>
inline constexpr int kTemplate<std::vector<T>> = 1;
template <class T>
inline constexpr int kTemplate<std::optional<T>> = 2;
template <class... T>
inline constexpr int kTemplate<std::variant<T...>> = 3;
template <class T, std::size_t n>
inline constexpr int kTemplate<std::array<T, n>> = 4;

// The number of values in braces that initialize a member: for an array, the number of its elements.
template <class T>
inline constexpr std::size_t kBracedCount = 1;
template <class T, std::size_t n>
inline constexpr std::size_t kBracedCount<T[n]> = n;

// The size of a class that has exactly these members, in this order.
template <class Owner, class... Members>
constexpr std::size_t size_with_members() {
    std::size_t end = 0;
    const auto add = [&end](std::size_t size, std::size_t alignment) {
        end = (end + alignment - 1) / alignment * alignment + size;
    };
    (add(sizeof(Members), alignof(Members)), ...);
    add(0, alignof(Owner));
    return end;
}

// Classes whose visit_members() leaves something out on purpose, or calls visit several times.
template <class T>
inline constexpr bool kListsInParts =
    std::is_same_v<T, BroadPhase> || std::is_same_v<T, ContactStore> || std::is_same_v<T, JointStore>;

// True if a list of members is complete. A member that fits into padding is noticed in an aggregate only.
template <class Owner, class... Members>
constexpr bool is_complete() {
    if constexpr (kListsInParts<Owner> || std::is_array_v<Owner>)
        return true;
    else if constexpr (std::is_aggregate_v<Owner>)
        return (std::size_t{0} + ... + kBracedCount<std::remove_cv_t<Members>>) == count_fields<Owner>();
    else
        return size_with_members<Owner, Members...>() == sizeof(Owner);
}

}  // namespace detail

template <class Visitor, class T>
void visit_value(Visitor& visitor, T& value) {
    using Plain = std::remove_const_t<T>;
    const auto visit_all = [&](auto&... members) {
        static_assert(detail::is_complete<Plain, std::remove_reference_t<decltype(members)>...>(),
                      "visit_members() leaves a member out");
        (visit_value(visitor, members), ...);
    };
    if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>)
        visitor.leaf(value);
    else if constexpr (std::is_same_v<Plain, Threads>)
        return;  // threads have no influence on the state
    else if constexpr (std::is_same_v<Plain, Shape>)
        visitor.shape(value);
    else if constexpr (detail::kTemplate<Plain> == 1)
        visitor.list(value);
    else if constexpr (detail::kTemplate<Plain> == 2)
        visitor.optional(value);
    else if constexpr (detail::kTemplate<Plain> == 3)
        visitor.variant(value);
    else if constexpr (detail::kTemplate<Plain> == 4 || std::is_array_v<Plain>)
        for (auto& element : value) visit_value(visitor, element);
    else if constexpr (requires { Plain::visit_members(value, visit_all); })
        Plain::visit_members(value, visit_all);
    else if constexpr (std::is_same_v<Plain, DVec2>)
        visit_all(value.x, value.y);
    else if constexpr (std::is_same_v<Plain, Manifold>)
        visit_all(value.normal, value.point_count, value.points);
    else
        visit_fields_of(value, visit_all);
}

}  // namespace tumble
