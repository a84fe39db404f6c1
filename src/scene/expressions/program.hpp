// A compiled expression: a tree of nodes that refer to bodies and joints of a scene.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/expressions/vocabulary.hpp"
#include "scene/format/field.hpp"
#include "scene/model/names.hpp"
#include "tumble/scene.hpp"

namespace tumble::scene {

inline constexpr int kMaxExpressionDepth = 50;  // brackets, signs and "not" within each other

enum class Op {
    constant,  // a number, or a condition that is true (1) or false (0)
    body_value,
    joint_value,
    world_value,
    given_value,  // of a name that the program gave
    call,
    negate,  // from here on, operators
    add,
    subtract,
    multiply,
    divide,
    power,  // of a whole exponent, the constant `number`
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    negation,  // not
    both,      // and
    either,    // or
};

// A body, or the copies of a common name.
struct BodyRef {
    std::string name;
    std::optional<std::size_t> built{};  // index in SceneWorld::bodies, of the first copy; none: the timeline spawns it
    std::size_t count = 1;               // of copies
    bool is_common = false;              // the name is that of all copies
    bool is_current = false;             // the copy that the function around it goes through
};

struct JointRef {
    std::string name;
    std::size_t built = 0;  // index in SceneWorld::joints, of the first copy
    std::size_t count = 1;  // of copies
    SceneJointType type = SceneJointType::revolute;
    bool is_current = false;  // the copy that the function around it goes through
};

struct Node {
    Op op = Op::constant;
    ValueKind kind = ValueKind::number;
    double number = 0.0;  // of a constant or an exponent
    int code = 0;         // BodyProperty, JointProperty, WorldValue or Function, or the index of a given value
    std::vector<std::size_t> operands{};  // nodes
    std::vector<std::size_t> names{};     // of bodies or of one joint; of a function about copies, the copies
    bool is_about_joints = false;         // a function about the copies of a joint
    std::size_t begin = 0, end = 0;       // in the text
};

// A name of a body or joint in the text, with its quotes.
struct NameSpan {
    std::size_t begin = 0, end = 0;
    std::string name;
};

struct Program {
    std::string text;
    std::vector<Node> nodes;
    std::size_t root = 0;
    std::vector<BodyRef> bodies;
    std::vector<JointRef> joints;
    std::vector<NameSpan> spans;
    Pose frame;
    std::size_t first_spawned = 0;  // index in SceneWorld::bodies of the first body that the timeline spawns

    ValueKind kind() const { return nodes[root].kind; }
};

// The names that an expression may refer to.
struct KnownNames {
    const Scene& scene;
    const BodyNames& bodies;
    const JointNames& joints;
    std::span<const std::string> values{};  // given by the program
};

// Without `known` the syntax and the kinds of values are checked, but not whether names exist. Throws ExpressionError.
Program compile(std::string_view text, const KnownNames* known, const SceneFrame& frame = {});

// The same, and the value must be a condition.
Program compile_condition(std::string_view text, const KnownNames* known, const SceneFrame& frame = {});

// Whether the expression refers to a body or a joint. It must compile.
bool refers_to_names(std::string_view text);

// The expression with a prefix before the names of all bodies and joints. It must compile.
std::string with_prefix(std::string_view text, std::string_view prefix);

}  // namespace tumble::scene
