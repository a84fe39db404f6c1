// Expressions over the bodies, joints and the world of a scene: "ball.x > 3 and not touching(ball, floor)". Claims and
// events of scene files are written in them; a program may use them for plots, filters and rewards.
//
// The page is src/scene/expressions/README.md. Lengths are m, times s, angles degrees and angular velocities degrees/s,
// as in scene files. The value of an expression has the same bits on every machine.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble {

// A text that is no expression, or one with a name that the scene does not have.
class ExpressionError : public std::invalid_argument {
public:
    ExpressionError(std::size_t at, const std::string& message, std::string advice = {})
        : std::invalid_argument(message), offset(at), hint(std::move(advice)) {}

    std::size_t offset;  // bytes from the start of the text
    std::string hint;    // may be empty
};

class Expression {
public:
    enum class Kind { number, condition };

    // The names are those of the scene, also of bodies that its timeline spawns later. Positions, angles and velocities
    // are measured in the frame. The text has at most 2000 bytes. Throws ExpressionError.
    Expression(std::string_view text, const Scene& scene, const SceneFrame& frame = {});
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    Kind kind() const noexcept;

    // The value in a state of the scene's world: of a condition 1 (holds) or 0; NaN if it is unknown, for example of a
    // body that does not exist.
    double value(const SceneWorld& built) const;

    // Whether a condition holds; false if it is unknown, and for numbers.
    bool holds(const SceneWorld& built) const;

    // How far a condition is from holding: positive if it does not hold, infinite if it is unknown. If it holds, at
    // most 0, the larger the nearer it is to failing. Of comparisons the difference of both sides; of bare conditions 1
    // or -1.
    double shortfall(const SceneWorld& built) const;

    // The values that an expression is made of: "a.x is 3, touching(a, b) is false".
    std::string finding(const SceneWorld& built) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
