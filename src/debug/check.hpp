// TUMBLE_CHECK(a <= b): an invariant that debug builds check. If it is false, the process prints the expression, its
// file and line and both values, and aborts. Release builds (NDEBUG) do not evaluate it.
//
// It is for defects of this library only. A wrong argument of a caller is an exception (world/require.hpp), an outcome
// such as an overlap is a status. An expression with && or || needs parentheses of its own.
#pragma once

#include <type_traits>
#include <utility>

namespace tumble::debug {

// A value of the expression, as the message prints it.
struct Shown {
    enum class Kind { number, integer, truth, other };

    Kind kind = Kind::other;
    double number = 0.0;
    long long integer = 0;
};

template <class T>
constexpr Shown show(const T& value) {
    using Plain = std::remove_cvref_t<T>;
    if constexpr (std::is_same_v<Plain, bool>)
        return {Shown::Kind::truth, 0.0, value};
    else if constexpr (std::is_floating_point_v<Plain>)
        return {Shown::Kind::number, static_cast<double>(value), 0};
    else if constexpr (std::is_integral_v<Plain> || std::is_enum_v<Plain>)
        return {Shown::Kind::integer, 0.0, static_cast<long long>(value)};
    else
        return {};
}

struct Outcome {
    bool holds = false;
    Shown left;
    Shown right;
    const char* comparison = "";  // empty if the expression is no comparison
};

// Prints to standard error and aborts.
[[noreturn]] void fail_check(const char* expression, const char* file, int line, const Outcome& outcome);

template <class T, class U>
inline constexpr bool kAreIntegers =
    std::is_integral_v<T>&& std::is_integral_v<U> && !std::is_same_v<T, bool> && !std::is_same_v<U, bool>;

// Comparisons of integers are by value, whatever their signs.
template <class T, class U>
constexpr bool is_equal(const T& left, const U& right) {
    if constexpr (kAreIntegers<T, U>)
        return std::cmp_equal(left, right);
    else
        return left == right;
}
template <class T, class U>
constexpr bool is_less(const T& left, const U& right) {
    if constexpr (kAreIntegers<T, U>)
        return std::cmp_less(left, right);
    else
        return left < right;
}
template <class T, class U>
constexpr bool is_at_most(const T& left, const U& right) {
    if constexpr (kAreIntegers<T, U>)
        return std::cmp_less_equal(left, right);
    else
        return left <= right;
}

// The left side of a comparison: `Start{} << a <= b` keeps both values.
template <class T>
struct Left {
    const T& value;

    template <class U>
    constexpr Outcome operator==(const U& right) const {
        return {is_equal(value, right), show(value), show(right), "=="};
    }
    template <class U>
    constexpr Outcome operator!=(const U& right) const {
        return {!is_equal(value, right), show(value), show(right), "!="};
    }
    template <class U>
    constexpr Outcome operator<(const U& right) const {
        return {is_less(value, right), show(value), show(right), "<"};
    }
    template <class U>
    constexpr Outcome operator<=(const U& right) const {
        return {is_at_most(value, right), show(value), show(right), "<="};
    }
    template <class U>
    constexpr Outcome operator>(const U& right) const {
        return {is_less(right, value), show(value), show(right), ">"};
    }
    template <class U>
    constexpr Outcome operator>=(const U& right) const {
        return {is_at_most(right, value), show(value), show(right), ">="};
    }
    constexpr operator Outcome() const { return {static_cast<bool>(value), show(static_cast<bool>(value)), {}, ""}; }
};

struct Start {
    template <class T>
    constexpr Left<T> operator<<(const T& value) const {
        return {value};
    }
};

constexpr void check(const Outcome& outcome, const char* expression, const char* file, int line) {
    if (!outcome.holds) [[unlikely]]
        fail_check(expression, file, line, outcome);
}

}  // namespace tumble::debug

#ifdef NDEBUG
#define TUMBLE_CHECK(condition) static_cast<void>(sizeof(condition))
#else
// NOLINTBEGIN(bugprone-macro-parentheses): parentheses around the condition would hide its two sides
#define TUMBLE_CHECK(condition) \
    ::tumble::debug::check(::tumble::debug::Start{} << condition, #condition, __FILE__, __LINE__)
// NOLINTEND(bugprone-macro-parentheses)
#endif
