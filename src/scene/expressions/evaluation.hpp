// One evaluation of an expression.
#pragma once

#include <string>
#include <vector>

#include "scene/expressions/program.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// Conditions are 1, 0 or, if unknown, NaN.
class Evaluation {
public:
    Evaluation(const Program& program, const SceneWorld& built, const SceneInstance* current = nullptr)
        : program_(program), built_(built), current_(current) {}

    double value(std::size_t node) const;

    // How far a condition is from being `wanted`, as Expression::shortfall() without its sign rules.
    double margin(std::size_t node, bool wanted) const;

    // The copies that exist, and the one of a body that exists; null if there is none.
    std::vector<const SceneInstance*> copies(const BodyRef& ref) const;
    const SceneInstance* body(const BodyRef& ref) const;

    const Program& program() const { return program_; }
    const SceneWorld& built() const { return built_; }

private:
    double operand(const Node& node, std::size_t index) const { return value(node.operands[index]); }
    double body_value(const Node& node) const;
    double joint_value(const Node& node) const;
    double world_value(WorldValue which) const;
    double call(const Node& node) const;
    double of_bodies(const Node& node) const;
    double of_copies(const Node& node) const;
    double compare(const Node& node) const;
    double join(const Node& node) const;
    double calculate(const Node& node) const;
    bool are_touching(const Node& node) const;
    double distance(const Node& node) const;
    double inside(const Node& node) const;

    const Program& program_;
    const SceneWorld& built_;
    const SceneInstance* current_;  // the copy that a function about copies is at
};

}  // namespace tumble::scene
