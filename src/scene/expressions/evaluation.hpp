// One evaluation of an expression.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/expressions/program.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

// Conditions are 1, 0 or, if unknown, NaN.
class Evaluation {
public:
    Evaluation(const Program& program, const SceneWorld& built) : Evaluation(program, built, built.world, {}) {}
    Evaluation(const Program& program, const SceneWorld& built, const World& world, std::span<const double> values)
        : program_(program), built_(built), world_(world), values_(values) {}

    double value(std::size_t node) const;

    // How far a condition is from being `wanted`, as Expression::shortfall() without its sign rules.
    double margin(std::size_t node, bool wanted) const;

    // The same state for each copy that exists of those that a function goes through.
    std::vector<Evaluation> at_copies(const Node& function) const;

    // The name of the copy that this is for.
    const std::string& copy() const { return current_ ? current_->name : current_joint_->name; }

    // The copies that exist, and the one of a body that exists; null if there is none.
    std::vector<const SceneInstance*> copies(const BodyRef& ref) const;
    const SceneInstance* body(const BodyRef& ref) const;

    const Program& program() const { return program_; }

private:
    double operand(const Node& node, std::size_t index) const { return value(node.operands[index]); }
    double body_value(const Node& node) const;
    double joint_value(const Node& node) const;
    double world_value(WorldValue which) const;
    double given_value(const Node& node) const;
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
    const World& world_;  // whose ids are those of built_
    std::span<const double> values_;
    const SceneInstance* current_ = nullptr;             // the copy that a function about copies is at
    const SceneJointInstance* current_joint_ = nullptr;  // the same of a joint
};

}  // namespace tumble::scene
