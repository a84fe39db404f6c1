// The fields of plain structs, found by the compiler, so that code that visits them cannot leave one out.
//
// The number of fields is the number of values in braces that initialize the struct. A C array would count as its
// elements, so structs that have one list their members themselves (visit_members.hpp). A wrong count does not compile.
#pragma once

#include <cstddef>
#include <optional>

namespace tumble {

namespace detail {

// A value of any type. Optionals need one of their own, because they also accept a value of the type they contain.
struct AnyValue {
    template <class T>
    operator T() const;
};
struct AnyOptional {
    template <class T>
    operator std::optional<T>() const;
};

template <class T, class... Found>
constexpr std::size_t count_fields() {
    if constexpr (requires { T{Found{}..., AnyValue{}}; })
        return count_fields<T, Found..., AnyValue>();
    else if constexpr (requires { T{Found{}..., AnyOptional{}}; })
        return count_fields<T, Found..., AnyOptional>();
    else
        return sizeof...(Found);
}

}  // namespace detail

// Calls visit(fields...) with all fields of an aggregate, in order. At most 15.
template <class T, class Visitor>
void visit_fields_of(T& value, Visitor&& visit) {
    constexpr std::size_t kCount = detail::count_fields<std::remove_const_t<T>>();
    static_assert(kCount >= 1 && kCount <= 15);
    // clang-format off
    if constexpr (kCount == 1) { auto& [a] = value; visit(a); }
    if constexpr (kCount == 2) { auto& [a, b] = value; visit(a, b); }
    if constexpr (kCount == 3) { auto& [a, b, c] = value; visit(a, b, c); }
    if constexpr (kCount == 4) { auto& [a, b, c, d] = value; visit(a, b, c, d); }
    if constexpr (kCount == 5) { auto& [a, b, c, d, e] = value; visit(a, b, c, d, e); }
    if constexpr (kCount == 6) { auto& [a, b, c, d, e, f] = value; visit(a, b, c, d, e, f); }
    if constexpr (kCount == 7) { auto& [a, b, c, d, e, f, g] = value; visit(a, b, c, d, e, f, g); }
    if constexpr (kCount == 8) { auto& [a, b, c, d, e, f, g, h] = value; visit(a, b, c, d, e, f, g, h); }
    if constexpr (kCount == 9) { auto& [a, b, c, d, e, f, g, h, i] = value; visit(a, b, c, d, e, f, g, h, i); }
    if constexpr (kCount == 10) { auto& [a, b, c, d, e, f, g, h, i, j] = value; visit(a, b, c, d, e, f, g, h, i, j); }
    if constexpr (kCount == 11) { auto& [a, b, c, d, e, f, g, h, i, j, k] = value; visit(a, b, c, d, e, f, g, h, i, j, k); }
    if constexpr (kCount == 12) { auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value; visit(a, b, c, d, e, f, g, h, i, j, k, l); }
    if constexpr (kCount == 13) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value; visit(a, b, c, d, e, f, g, h, i, j, k, l, m); }
    if constexpr (kCount == 14) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
    if constexpr (kCount == 15) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value; visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
    // clang-format on
}

}  // namespace tumble
