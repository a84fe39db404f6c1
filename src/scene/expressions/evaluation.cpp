#include "scene/expressions/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/expressions/contact_state.hpp"
#include "scene/expressions/exponential.hpp"
#include "scene/model/degrees.hpp"
#include "scene/model/frame.hpp"
#include "scene/model/joint_gap.hpp"

namespace tumble::scene {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// The product of equal factors, in an order that does not depend on the machine.
double power(double base, double exponent) {
    double product = 1.0;
    for (double left = std::abs(exponent); left > 0.0; --left) product *= base;
    return exponent < 0.0 ? 1.0 / product : product;
}

double velocity_value(const Pose& frame, const BodyState& state, BodyProperty property) {
    const DVec2 velocity = inverse_rotate(frame.rotation, DVec2(state.velocity));
    return property == BodyProperty::vx ? velocity.x : velocity.y;
}

// `low` if the bounds cross.
double clamped(double value, double low, double high) {
    if (std::isnan(value + low + high)) return kUnknown;
    return std::max(low, std::min(value, high));
}

double tangent(double degrees) {
    const SinCos at = sin_cos_degrees(degrees);
    return at.sin / at.cos;
}

}  // namespace

double Evaluation::value(std::size_t index) const {
    const Node& node = program_.nodes[index];
    switch (node.op) {
        case Op::constant: return node.number;
        case Op::body_value: return body_value(node);
        case Op::joint_value: return joint_value(node);
        case Op::world_value: return world_value(static_cast<WorldValue>(node.code));
        case Op::given_value: return given_value(node);
        case Op::call: return call(node);
        case Op::negate: return -operand(node, 0);
        case Op::power: return power(operand(node, 0), node.number);
        case Op::negation: return 1.0 - operand(node, 0);
        case Op::both:
        case Op::either: return join(node);
        case Op::add:
        case Op::subtract:
        case Op::multiply:
        case Op::divide: return calculate(node);
        default: return compare(node);
    }
}

double Evaluation::calculate(const Node& node) const {
    const double a = operand(node, 0), b = operand(node, 1);
    if (node.op == Op::add) return a + b;
    if (node.op == Op::subtract) return a - b;
    return node.op == Op::multiply ? a * b : a / b;
}

double Evaluation::compare(const Node& node) const {
    const double a = operand(node, 0), b = operand(node, 1);
    if (std::isnan(a) || std::isnan(b)) return kUnknown;
    switch (node.op) {
        case Op::less: return a < b;
        case Op::less_equal: return a <= b;
        case Op::greater: return a > b;
        case Op::greater_equal: return a >= b;
        case Op::equal: return a == b;
        default: return a != b;
    }
}

// "and" is false if one side is, "or" is true if one side is, whatever the other side is.
double Evaluation::join(const Node& node) const {
    const double decisive = node.op == Op::both ? 0.0 : 1.0;
    const double a = operand(node, 0);
    if (a == decisive) return a;
    const double b = operand(node, 1);
    return b == decisive ? b : a + b - (1.0 - decisive);
}

const SceneInstance* Evaluation::body(const BodyRef& ref) const {
    if (ref.is_current) return current_;
    if (ref.built) {
        const SceneInstance& instance = built_.bodies[*ref.built];
        return world_.is_valid(instance.id) ? &instance : nullptr;
    }
    for (std::size_t i = built_.bodies.size(); i > program_.first_spawned; --i) {
        const SceneInstance& instance = built_.bodies[i - 1];
        if (instance.name == ref.name && world_.is_valid(instance.id)) return &instance;
    }
    return nullptr;
}

std::vector<const SceneInstance*> Evaluation::copies(const BodyRef& ref) const {
    std::vector<const SceneInstance*> found;
    if (!ref.is_common) {
        if (const SceneInstance* one = body(ref)) found.push_back(one);
        return found;
    }
    const std::size_t begin = ref.built.value_or(program_.first_spawned);
    const std::size_t end = ref.built ? begin + ref.count : built_.bodies.size();
    for (std::size_t i = begin; i < end; ++i) {
        const SceneInstance& instance = built_.bodies[i];
        if ((ref.built || base_name(instance.name) == ref.name) && world_.is_valid(instance.id))
            found.push_back(&instance);
    }
    return found;
}

std::vector<Evaluation> Evaluation::at_copies(const Node& function) const {
    std::vector<Evaluation> found;
    if (!function.is_about_joints) {
        for (const SceneInstance* copy : copies(program_.bodies[function.names.back()]))
            found.emplace_back(*this).current_ = copy;
        return found;
    }
    const JointRef& ref = program_.joints[function.names.back()];
    for (std::size_t i = ref.built; i < ref.built + ref.count; ++i)
        if (world_.is_valid(built_.joints[i].id)) found.emplace_back(*this).current_joint_ = &built_.joints[i];
    return found;
}

double Evaluation::body_value(const Node& node) const {
    const auto property = static_cast<BodyProperty>(node.code);
    const SceneInstance* found = body(program_.bodies[node.names[0]]);
    if (property == BodyProperty::exists) return found != nullptr;
    if (found == nullptr) return kUnknown;
    const World& world = world_;
    const BodyState state = world.state(found->id);
    switch (property) {
        case BodyProperty::x: return inverse_transform_point(program_.frame, state.pose.position).x;
        case BodyProperty::y: return inverse_transform_point(program_.frame, state.pose.position).y;
        case BodyProperty::angle: return angle(seen_from(program_.frame, state.pose).rotation) * kDegrees;
        case BodyProperty::speed: return length(DVec2(state.velocity));
        case BodyProperty::spin: return double{state.angular_velocity} * kDegrees;
        case BodyProperty::mass: return double{world.mass(found->id).mass};
        case BodyProperty::awake: return world.is_awake(found->id);
        default: return velocity_value(program_.frame, state, property);
    }
}

double Evaluation::joint_value(const Node& node) const {
    const auto property = static_cast<JointProperty>(node.code);
    const JointRef& ref = program_.joints[node.names[0]];
    const JointId id = ref.is_current ? current_joint_->id : built_.joints[ref.built].id;
    const World& world = world_;
    if (property == JointProperty::exists) return world.is_valid(id);
    if (!world.is_valid(id)) return kUnknown;
    const bool turns =
        ref.type == SceneJointType::revolute || ref.type == SceneJointType::weld || ref.type == SceneJointType::motor;
    const double unit = turns ? kDegrees : 1.0;
    switch (property) {
        case JointProperty::speed: return world.joint_motion(id).speed * unit;
        case JointProperty::force: return length(DVec2(world.reaction(id).force));
        case JointProperty::torque: return double{world.reaction(id).torque};
        case JointProperty::gap: return joint_gap(world, id);
        default: return world.joint_motion(id).position * unit;
    }
}

double Evaluation::world_value(WorldValue which) const {
    const World& world = world_;
    switch (which) {
        case WorldValue::time: return world.time();
        case WorldValue::step: return static_cast<double>(world.step_count());
        case WorldValue::energy: return world.energy().total();
        case WorldValue::kinetic: return world.energy().kinetic;
        case WorldValue::potential: return world.energy().potential;
        case WorldValue::work: return built_.work;
        case WorldValue::momentum_x: return world.momentum().x;
        case WorldValue::momentum_y: return world.momentum().y;
        case WorldValue::contacts: return static_cast<double>(world.contacts().size());
        case WorldValue::bodies: return static_cast<double>(world.bodies().size());
    }
    return kUnknown;
}

double Evaluation::given_value(const Node& node) const {
    const std::size_t index = static_cast<std::size_t>(node.code);
    return index < values_.size() ? values_[index] : kUnknown;
}

double Evaluation::call(const Node& node) const {
    const auto function = static_cast<Function>(node.code);
    if (is_about_copies(function, node.operands.size()) && !node.names.empty()) return of_copies(node);
    if (function >= Function::touching) return of_bodies(node);
    const double a = operand(node, 0);
    switch (function) {
        case Function::abs: return std::abs(a);
        case Function::sqrt: return std::sqrt(a);
        case Function::floor: return std::floor(a);
        case Function::ceil: return std::ceil(a);
        case Function::sin: return sin_cos_degrees(a).sin;
        case Function::cos: return sin_cos_degrees(a).cos;
        case Function::tan: return tangent(a);
        case Function::atan2: return arc_tangent(a, operand(node, 1)) * kDegrees;
        case Function::hypot: return length(DVec2{a, operand(node, 1)});
        case Function::exp: return exponential(a);
        case Function::sign: return std::isnan(a) ? kUnknown : static_cast<double>((a > 0.0) - (a < 0.0));
        case Function::clamp: return clamped(a, operand(node, 1), operand(node, 2));
        case Function::mod: return std::fmod(a, operand(node, 1));
        case Function::choose: return std::isnan(a) ? kUnknown : operand(node, a == 1.0 ? 1 : 2);
        default: break;
    }
    double best = a;
    for (std::size_t i = 1; i < node.operands.size(); ++i) {
        const double other = operand(node, i);
        if (std::isnan(best) || std::isnan(other)) return kUnknown;
        best = function == Function::min ? std::min(best, other) : std::max(best, other);
    }
    return best;
}

double Evaluation::of_bodies(const Node& node) const {
    switch (static_cast<Function>(node.code)) {
        case Function::touching: return are_touching(node);
        case Function::distance: return distance(node);
        case Function::inside: return inside(node);
        default: return kUnknown;  // a function about copies that was compiled without names
    }
}

bool Evaluation::are_touching(const Node& node) const {
    for (const SceneInstance* a : copies(program_.bodies[node.names[0]]))
        for (const SceneInstance* b : copies(program_.bodies[node.names[1]]))
            if (a->id != b->id && scene::are_touching(world_, a->id, b->id)) return true;
    return false;
}

double Evaluation::distance(const Node& node) const {
    double least = kUnknown;
    for (const SceneInstance* a : copies(program_.bodies[node.names[0]]))
        for (const SceneInstance* b : copies(program_.bodies[node.names[1]]))
            if (a->id != b->id) least = std::fmin(least, gap_between(world_, a->id, b->id));
    return least;
}

double Evaluation::inside(const Node& node) const {
    const double left = operand(node, 0), bottom = operand(node, 1), right = operand(node, 2), top = operand(node, 3);
    const auto is_in = [&](const SceneInstance* body) {
        const DVec2 p = inverse_transform_point(program_.frame, world_.state(body->id).pose.position);
        return p.x >= left && p.x <= right && p.y >= bottom && p.y <= top;
    };
    if (std::isnan(left + bottom + right + top)) return kUnknown;
    return std::ranges::any_of(copies(program_.bodies[node.names[0]]), is_in);
}

double Evaluation::of_copies(const Node& node) const {
    const auto function = static_cast<Function>(node.code);
    std::vector<double> values;
    for (const Evaluation& copy : at_copies(node)) values.push_back(copy.value(node.operands[0]));
    const auto is = [&](double wanted) { return std::ranges::count(values, wanted); };
    const bool has_unknown = std::ranges::any_of(values, [](double value) { return std::isnan(value); });
    double sum = 0.0;
    for (const double value : values) sum += value;
    switch (function) {
        case Function::all: return is(0.0) > 0 ? 0.0 : has_unknown || values.empty() ? kUnknown : 1.0;
        case Function::any: return is(1.0) > 0 ? 1.0 : has_unknown ? kUnknown : 0.0;
        case Function::count: return static_cast<double>(is(1.0));
        case Function::sum: return sum;
        default: break;
    }
    if (values.empty() || has_unknown) return kUnknown;
    return function == Function::min ? std::ranges::min(values) : std::ranges::max(values);
}

}  // namespace tumble::scene
