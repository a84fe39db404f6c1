// The words of expressions: properties of bodies and joints, values of the world, functions.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tumble/scene_run.hpp"

namespace tumble::scene {

using ValueKind = Expression::Kind;
inline constexpr ValueKind kNumber = ValueKind::number, kCondition = ValueKind::condition;

enum class BodyProperty { x, y, angle, vx, vy, speed, spin, mass, awake, exists };

enum class JointProperty { angle, translation, length, speed, force, torque, gap, exists };

enum class WorldValue {
    time,
    step,
    energy,
    kinetic,
    potential,
    work,
    momentum_x,
    momentum_y,
    contacts,
    bodies,
};

enum class Function {
    abs,
    sqrt,
    floor,
    ceil,
    sin,
    cos,
    tan,
    atan2,
    hypot,
    mod,
    exp,
    sign,
    clamp,
    choose,
    min,
    max,
    touching,
    distance,
    inside,
    all,
    any,
    count,
    sum,
};

template <class Code>
struct Word {
    std::string_view name;
    Code code;
    ValueKind kind;
};

// What a function takes: a letter for each argument, n a number, c a condition, b a body; + repeats the last. `form`
// shows a call.
struct FunctionWord {
    std::string_view name;
    Function code;
    ValueKind kind;
    std::string_view takes;
    std::string_view form;
};

std::span<const Word<BodyProperty>> body_words();
std::span<const Word<JointProperty>> joint_words();
std::span<const Word<WorldValue>> world_words();
std::span<const FunctionWord> function_words();

template <class Words>
auto find_word(const Words& words, std::string_view name) {
    for (const auto& word : words)
        if (word.name == name) return &word;
    return decltype(&*words.begin())(nullptr);
}

template <class Words>
std::vector<std::string_view> names_of(const Words& words) {
    std::vector<std::string_view> names;
    for (const auto& word : words) names.push_back(word.name);
    return names;
}

// all, any, count, sum, and min and max of one argument: about the copies of a common name.
constexpr bool is_about_copies(Function function, std::size_t arguments) {
    const bool can_be_both = function == Function::min || function == Function::max;
    return function >= Function::all || (can_be_both && arguments == 1);
}

}  // namespace tumble::scene
