// How far a condition is from holding, and the values that an expression is made of.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/expressions/evaluate.hpp"
#include "scene/expressions/evaluation.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostValues = 6;  // in a finding

// A value of a body, a joint or the world, or a function of bodies.
bool is_leaf(const Node& node) {
    if (node.op == Op::call) return static_cast<Function>(node.code) >= Function::touching || !node.names.empty();
    return node.op == Op::body_value || node.op == Op::joint_value || node.op == Op::world_value;
}

// Lists the values of the leaves below a node.
class Lister {
public:
    void list(const Evaluation& state, std::size_t index, const std::string& before) {
        const Node& node = state.program().nodes[index];
        if (is_leaf(node)) return add(state, index, before);
        for (const std::size_t operand : node.operands) list(state, operand, before);
    }

    std::string text() const { return text_.empty() ? "it is constant" : text_; }

private:
    void add(const Evaluation& state, std::size_t index, const std::string& before) {
        const Node& node = state.program().nodes[index];
        const std::string source = before + state.program().text.substr(node.begin, node.end - node.begin);
        if (seen_.size() == kMostValues || !seen_.insert(source).second) return;
        const double value = state.value(index);
        text_ += text_.empty() ? "" : ", ";
        const std::string absent = std::isnan(value) ? absent_name(state, node) : "";
        text_ += !absent.empty() ? "'" + absent + "' does not exist" : source + " is " + shown(node, value);
        if (node.op == Op::call && static_cast<Function>(node.code) == Function::all && value == 0.0)
            list_failing(state, node);
    }

    static std::string shown(const Node& node, double value) {
        if (std::isnan(value)) return "unknown";
        return node.kind == ValueKind::number ? brief(value) : value == 1.0 ? "true" : "false";
    }

    static std::string absent_name(const Evaluation& state, const Node& node) {
        const auto joint_name = [&] { return state.program().joints[node.names[0]].name; };
        if (node.op == Op::joint_value) return joint_name();
        if (node.is_about_joints) return state.at_copies(node).empty() ? joint_name() : std::string();
        if (node.op != Op::body_value && node.op != Op::call) return {};
        for (const std::size_t name : node.names) {
            const BodyRef& ref = state.program().bodies[name];
            if (!ref.is_current && state.copies(ref).empty()) return ref.name;
        }
        return {};
    }

    // The values of the first copy for which the condition of all() is false.
    void list_failing(const Evaluation& state, const Node& node) {
        for (const Evaluation& of_copy : state.at_copies(node))
            if (of_copy.value(node.operands[0]) == 0.0)
                return list(of_copy, node.operands[0], "of '" + of_copy.copy() + "' ");
    }

    std::set<std::string> seen_;
    std::string text_;
};

double known(double margin) { return std::isnan(margin) ? kInfinite : margin; }

}  // namespace

double Evaluation::margin(std::size_t index, bool wanted) const {
    const Node& node = program_.nodes[index];
    const auto of = [&](std::size_t i, bool truth) { return known(margin(node.operands[i], truth)); };
    switch (node.op) {
        case Op::negation: return of(0, !wanted);
        case Op::both:
        case Op::either:
            return (node.op == Op::both) == wanted ? std::max(of(0, wanted), of(1, wanted))
                                                   : std::min(of(0, wanted), of(1, wanted));
        case Op::less:
        case Op::less_equal: return (operand(node, 0) - operand(node, 1)) * (wanted ? 1.0 : -1.0);
        case Op::greater:
        case Op::greater_equal: return (operand(node, 1) - operand(node, 0)) * (wanted ? 1.0 : -1.0);
        case Op::equal: return std::abs(operand(node, 0) - operand(node, 1)) * (wanted ? 1.0 : -1.0);
        case Op::not_equal: return std::abs(operand(node, 0) - operand(node, 1)) * (wanted ? -1.0 : 1.0);
        default: break;
    }
    const double value = this->value(index);
    const auto function = static_cast<Function>(node.code);
    const bool is_all = function == Function::all, is_any = function == Function::any;
    if (std::isnan(value) || node.op != Op::call || node.names.empty() || !(is_all || is_any))
        return std::isnan(value) ? kInfinite : (value == 1.0) == wanted ? -1.0 : 1.0;
    const bool takes_worst = is_all == wanted;
    double result = takes_worst ? -kInfinite : kInfinite;
    for (const Evaluation& copy : at_copies(node)) {
        const double one = known(copy.margin(node.operands[0], wanted));
        result = takes_worst ? std::max(result, one) : std::min(result, one);
    }
    return result;
}

double value_of(const Program& program, const SceneWorld& built) {
    return Evaluation(program, built).value(program.root);
}

double value_of(const Program& program, const SceneWorld& built, const World& world, std::span<const double> values) {
    return Evaluation(program, built, world, values).value(program.root);
}

bool holds(const Program& program, const SceneWorld& built) {
    return program.kind() == ValueKind::condition && value_of(program, built) == 1.0;
}

double shortfall_of(const Program& program, const SceneWorld& built) {
    const Evaluation state(program, built);
    const double value = state.value(program.root);
    if (program.kind() == ValueKind::number || std::isnan(value)) return kInfinite;
    const double margin = known(state.margin(program.root, true));
    return value == 1.0 ? std::min(margin, 0.0) : std::max(margin, std::numeric_limits<double>::min());
}

std::string finding_of(const Program& program, const SceneWorld& built) {
    Lister lister;
    lister.list(Evaluation(program, built), program.root, "");
    return lister.text();
}

}  // namespace tumble::scene
