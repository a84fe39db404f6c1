// The description of one scene field, and the visitors that collect names: the vocabulary of fields.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/scene.hpp"

namespace tumble::scene {

template <class T>
struct Type {};

// The closed range of a number, or of each component of a vector; `above_min` excludes the lower end.
struct Range {
    double min = 0.0;
    double max = 0.0;
    bool above_min = false;
    bool zero_in_queries = false;  // 0 is allowed in distance queries, for points and bare segments
};

// The upper limits keep every product that a step forms, such as mass times length squared, in the range of float.
inline constexpr double kFarthest = 1e9;  // positions, m
inline constexpr double kLargest = 1e5;   // sizes and shape coordinates, m
inline constexpr double kFastest = 1e6;   // velocities, angles and other values without a natural limit
inline constexpr double kLongest = 1e6;   // durations, s
inline constexpr double kMost = 1e6;      // copies by one repeater

inline constexpr Range kPosition{-kFarthest, kFarthest};
inline constexpr Range kCoordinate{-kLargest, kLargest};
inline constexpr Range kAny{-kFastest, kFastest};
inline constexpr Range kLength{0.0, kLargest, true};
inline constexpr Range kRadius{0.0, kLargest, true, true};
inline constexpr Range kRounding{0.0, kLargest};
inline constexpr Range kNotNegative{0.0, kFastest};
inline constexpr Range kPositive{0.0, kFastest, true};
inline constexpr Range kStrength{0.0, 1e12};
inline constexpr Range kForce{-1e12, 1e12};
inline constexpr Range kTime{0.0, kLongest};
inline constexpr Range kInterval{0.0, kLongest, true};
inline constexpr Range kCount{1.0, kMost};
inline constexpr Range kBits{0.0, 4294967295.0};
inline constexpr Range kSeed{0.0, 0x1p64};

inline constexpr std::size_t kMaxNameBytes = 256;         // bytes
inline constexpr std::size_t kMaxExpressionBytes = 2000;  // bytes
inline constexpr std::size_t kMaxCaptionBytes = 2000;     // bytes

// What a text may contain. `hash` is 16 digits 0-9 and a-f, `png_file` a name that ends with .png.
enum class Text { any, name, color, expression, caption, hash, png_file };

struct Field {
    std::string_view name;
    std::string_view description;
    std::string_view unit = {};
    Range range = kAny;
    bool required = false;
    std::size_t min_items = 0;
    std::size_t max_items = 65535;
    Text text = Text::any;
};

// Enumerators and their names in files.
template <class Enum>
inline constexpr std::array<std::pair<Enum, std::string_view>, 0> kEnumNames{};

// Throws std::invalid_argument for a value that is not one of them.
template <class Enum>
std::string_view enum_name(Enum value) {
    for (const auto& [enumerator, name] : kEnumNames<Enum>)
        if (enumerator == value) return name;
    throw std::invalid_argument("an enumerator of a scene is out of range");
}

// A visitor that collects the keys of a struct.
struct FieldNames {
    void field(const Field& field, auto) { all.push_back(field.name); }
    void pair(const Field& field, auto, auto) { all.push_back(field.name); }
    void named(const Field& field, auto) { all.push_back(field.name); }
    void json(const Field& field, auto) { all.push_back(field.name); }
    void constant(const Field& field, int) { all.push_back(field.name); }
    void one_of(const Field&, auto) {}
    void exactly_one(std::initializer_list<std::string_view>) {}
    void at_most_one(std::string_view, std::string_view) {}

    std::vector<std::string_view> all;
};

// A visitor that collects the keys of a variant's alternatives, in the order of its types.
struct AlternativeNames {
    template <class Alternative>
    void alternative(std::string_view name, std::string_view) {
        all.push_back(name);
    }

    std::vector<std::string_view> all;
};

// The key of the alternative that a variant holds.
template <class Variant>
std::string_view alternative_name(const Variant& variant) {
    AlternativeNames names;
    visit_alternatives(names, Type<Variant>{});
    return names.all[variant.index()];
}

template <class T>
bool has_field(std::string_view name) {
    FieldNames names;
    visit_fields(names, Type<T>{});
    return std::find(names.all.begin(), names.all.end(), name) != names.all.end();
}

}  // namespace tumble::scene
