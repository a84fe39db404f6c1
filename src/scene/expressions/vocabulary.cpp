#include "scene/expressions/vocabulary.hpp"

namespace tumble::scene {

namespace {

constexpr Word<BodyProperty> kBodyWords[] = {
    {"x", BodyProperty::x, kNumber},
    {"y", BodyProperty::y, kNumber},
    {"angle", BodyProperty::angle, kNumber},
    {"vx", BodyProperty::vx, kNumber},
    {"vy", BodyProperty::vy, kNumber},
    {"speed", BodyProperty::speed, kNumber},
    {"spin", BodyProperty::spin, kNumber},
    {"mass", BodyProperty::mass, kNumber},
    {"awake", BodyProperty::awake, kCondition},
    {"exists", BodyProperty::exists, kCondition},
};

constexpr Word<JointProperty> kJointWords[] = {
    {"angle", JointProperty::angle, kNumber},   {"translation", JointProperty::translation, kNumber},
    {"length", JointProperty::length, kNumber}, {"speed", JointProperty::speed, kNumber},
    {"force", JointProperty::force, kNumber},   {"torque", JointProperty::torque, kNumber},
    {"gap", JointProperty::gap, kNumber},       {"exists", JointProperty::exists, kCondition},
};

constexpr Word<WorldValue> kWorldWords[] = {
    {"time", WorldValue::time, kNumber},
    {"step", WorldValue::step, kNumber},
    {"energy", WorldValue::energy, kNumber},
    {"kinetic", WorldValue::kinetic, kNumber},
    {"potential", WorldValue::potential, kNumber},
    {"work", WorldValue::work, kNumber},
    {"momentum_x", WorldValue::momentum_x, kNumber},
    {"momentum_y", WorldValue::momentum_y, kNumber},
    {"contacts", WorldValue::contacts, kNumber},
    {"bodies", WorldValue::bodies, kNumber},
};

constexpr FunctionWord kFunctionWords[] = {
    {"abs", Function::abs, kNumber, "n", "abs(a)"},
    {"sqrt", Function::sqrt, kNumber, "n", "sqrt(a)"},
    {"floor", Function::floor, kNumber, "n", "floor(a)"},
    {"ceil", Function::ceil, kNumber, "n", "ceil(a)"},
    {"sin", Function::sin, kNumber, "n", "sin(degrees)"},
    {"cos", Function::cos, kNumber, "n", "cos(degrees)"},
    {"tan", Function::tan, kNumber, "n", "tan(degrees)"},
    {"atan2", Function::atan2, kNumber, "nn", "atan2(y, x)"},
    {"hypot", Function::hypot, kNumber, "nn", "hypot(x, y)"},
    {"mod", Function::mod, kNumber, "nn", "mod(a, b)"},
    {"exp", Function::exp, kNumber, "n", "exp(a)"},
    {"sign", Function::sign, kNumber, "n", "sign(a)"},
    {"clamp", Function::clamp, kNumber, "nnn", "clamp(a, low, high)"},
    {"if", Function::choose, kNumber, "cnn", "if(condition, a, b)"},
    {"min", Function::min, kNumber, "n+", "min(a, b)"},
    {"max", Function::max, kNumber, "n+", "max(a, b)"},
    {"touching", Function::touching, kCondition, "bb", "touching(ball, floor)"},
    {"distance", Function::distance, kNumber, "bb", "distance(ball, floor)"},
    {"inside", Function::inside, kCondition, "bnnnn", "inside(ball, left, bottom, right, top)"},
    {"all", Function::all, kCondition, "c", "all(crate.y > 0)"},
    {"any", Function::any, kCondition, "c", "any(crate.y > 0)"},
    {"count", Function::count, kNumber, "c", "count(crate.y > 0)"},
    {"sum", Function::sum, kNumber, "n", "sum(crate.mass)"},
};

}  // namespace

std::span<const Word<BodyProperty>> body_words() { return kBodyWords; }
std::span<const Word<JointProperty>> joint_words() { return kJointWords; }
std::span<const Word<WorldValue>> world_words() { return kWorldWords; }
std::span<const FunctionWord> function_words() { return kFunctionWords; }

}  // namespace tumble::scene
