// Looks up the bodies, joints and properties that an expression names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/expressions/program.hpp"
#include "scene/expressions/token.hpp"

namespace tumble::scene {

// Adds what it finds to a program. All functions throw ExpressionError at the token that is wrong.
class NameLookup {
public:
    // Without `known`, every name is taken for that of a body.
    NameLookup(const KnownNames* known, Program& program) : known_(known), program_(program) {}

    bool is_unchecked() const { return known_ == nullptr; }

    // The index in Program::bodies, of a body that is an argument itself.
    std::size_t body(const Token& name) { return body(name, std::nullopt); }

    // The node of "body.property" or "joint.property", without its place in the text.
    Node property(const Token& name, const Token& word);

    // The index of a value that the program gave.
    std::optional<std::size_t> given_value(const Token& name) const;

    // To be called for a name without a property, which is no value of the world. `touched` is the name that follows in
    // the manner of "ball hits floor", or empty.
    [[noreturn]] void refuse_alone(const Token& name, const std::string& touched) const;

    // The copies of a body or joint: the index in Program::bodies or Program::joints, and the byte of the text at which
    // they are named first.
    struct Copies {
        std::size_t index = 0;
        bool are_joints = false;
        std::size_t begin = 0;
    };
    const std::string& name_of(const Copies& copies) const;

    // The arguments of a function about copies are between the two. The result is the copies that they name, if they
    // do.
    void enter(const Token& function);
    std::optional<Copies> leave();

private:
    // A function whose arguments are being read, and the copies that they name. min and max may be about copies or not.
    struct Around {
        bool is_about_copies = false;
        std::optional<Copies> copies{};
    };

    // A property as written.
    struct Property {
        std::string text;
        ValueKind kind = kNumber;
    };

    std::size_t body(const Token& name, const std::optional<Property>& property);
    Node joint_property(const Token& name, const NamedCopy& joint, const Token& word);
    std::optional<NamedCopy> find_joint(const std::string& name) const;
    bool is_known_body(const std::string& name) const;
    Around& around_copies();
    void go_through_copies(const Token& name, bool are_joints);
    BodyRef common(const std::string& name) const;
    [[noreturn]] void refuse_common(const Token& name, const Property& property) const;
    [[noreturn]] void refuse_unknown(const Token& name, const std::string& what) const;
    std::size_t add(BodyRef body);
    std::size_t add(JointRef joint);

    const KnownNames* known_;
    Program& program_;

    std::vector<Around> around_;
};

}  // namespace tumble::scene
