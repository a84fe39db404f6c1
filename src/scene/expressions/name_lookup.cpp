#include "scene/expressions/name_lookup.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "tumble/suggest.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kLeastLikeness = 2;  // letters

// A name with signs in it, of which the word is the beginning: 'car1/wheel' for car1.
std::string hint_for_quotes(const std::string& word, const Scene& scene) {
    if (word.size() < kLeastLikeness) return {};
    const auto is_meant = [&](const std::string& name) { return name.starts_with(word) && !is_plain_name(name); };
    std::string meant;
    for (const SceneBody& body : scene.bodies)
        if (meant.empty() && is_meant(body.name)) meant = body.name;
    for (const SceneJoint& joint : scene.joints)
        if (meant.empty() && is_meant(joint.name)) meant = joint.name;
    return meant.empty() ? "" : "a name with other signs than letters, digits and _ is quoted: " + quoted_name(meant);
}

// Which properties a joint of a type has beside force, torque, gap and exists.
bool has_property(SceneJointType type, JointProperty property) {
    using enum SceneJointType;
    const bool turns = type == revolute || type == weld || type == motor;
    const bool slides = type == prismatic || type == wheel;
    const bool has_length = type == distance || type == mouse || type == pulley;
    switch (property) {
        case JointProperty::angle: return turns;
        case JointProperty::translation: return slides;
        case JointProperty::length: return has_length;
        case JointProperty::speed: return turns || slides || has_length;
        default: return true;
    }
}

// What other engines call a property of a body, also as a vector: velocity.x, position[0].
std::string own_property(std::string_view word, std::span<const std::string_view> words) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kForeign{
        {{"position", "x or y"},
         {"pos", "x or y"},
         {"velocity", "vx, vy or speed"},
         {"vel", "vx, vy or speed"},
         {"rotation", "angle, in degrees"},
         {"theta", "angle, in degrees"},
         {"angular_velocity", "spin, in degrees/s"},
         {"omega", "spin, in degrees/s"}}};
    for (const auto& [foreign, own] : kForeign)
        if (word.substr(0, word.find('[')) == foreign) return "this grammar has " + std::string(own);
    return suggestion(word, words);
}

}  // namespace

std::size_t NameLookup::add(BodyRef body) {
    program_.bodies.push_back(std::move(body));
    return program_.bodies.size() - 1;
}

std::size_t NameLookup::add(JointRef joint) {
    program_.joints.push_back(std::move(joint));
    return program_.joints.size() - 1;
}

// The joint of a name, or the first copy of a common name.
std::optional<NamedCopy> NameLookup::find_joint(const std::string& name) const {
    return known_->joints.find(known_->joints.is_shared(name) ? copy_name(name, 0) : name);
}

bool NameLookup::is_known_body(const std::string& name) const {
    return known_->bodies.find(name) || known_->bodies.is_spawned(name) || known_->bodies.is_shared(name);
}

void NameLookup::enter(const Token& function) {
    const bool may_be_other = function.text == "min" || function.text == "max";
    if (!may_be_other && std::ranges::any_of(around_, &Around::is_about_copies))
        throw ExpressionError(function.begin, "a function about copies cannot be inside another one");
    around_.push_back({.is_about_copies = !may_be_other});
}

std::optional<NameLookup::Copies> NameLookup::leave() {
    std::optional<Copies> copies = around_.back().copies;
    around_.pop_back();
    return copies;
}

const std::string& NameLookup::name_of(const Copies& copies) const {
    return copies.are_joints ? program_.joints[copies.index].name : program_.bodies[copies.index].name;
}

// The function whose copies a common name means: the one that is always about copies, or else the innermost.
NameLookup::Around& NameLookup::around_copies() {
    const auto found = std::ranges::find(around_, true, &Around::is_about_copies);
    return found == around_.end() ? around_.back() : *found;
}

// All copies of a body, also of one that the timeline spawns.
BodyRef NameLookup::common(const std::string& name) const {
    const std::string first = copy_name(name, 0);
    const std::optional<std::size_t> built = known_->bodies.find(first);
    const std::size_t count = built ? known_->bodies.copies_after(first).value() + 1 : 0;
    return {.name = name, .built = built, .count = count, .is_common = true};
}

// The function around a common name goes through its copies, and through no others.
void NameLookup::go_through_copies(const Token& name, bool are_joints) {
    std::optional<Copies>& copies = around_copies().copies;
    if (!copies && are_joints) {
        const NamedCopy first = *find_joint(name.text);
        copies =
            Copies{add(JointRef{.name = name.text, .built = known_->joints.built_index(first), .count = first.count}),
                   true, name.begin};
    } else if (!copies) {
        copies = Copies{add(common(name.text)), false, name.begin};
    }
    if (copies->are_joints != are_joints || name_of(*copies) != name.text)
        throw ExpressionError(name.begin, "a function about copies takes the copies of one body or joint: '" +
                                              name_of(*copies) + "' and '" + name.text + "' are two");
}

// Without a function around it, a common name has no property.
void NameLookup::refuse_common(const Token& name, const Property& property) const {
    const std::string one = in_expression(copy_name(name.text, 0)) + "." + property.text;
    const std::string value = in_expression(name.text) + "." + property.text;
    const bool is_number = property.kind == kNumber;
    const std::string condition = value + (is_number ? " > 0" : "");
    throw ExpressionError(name.begin, "'" + name.text + "' stands for several copies",
                          "name one, " + one + ", or all of them: all(" + condition + "), any(" + condition + "), " +
                              (is_number ? "max(" : "count(") + value + ")");
}

std::size_t NameLookup::body(const Token& name, const std::optional<Property>& property) {
    program_.spans.push_back({name.begin, name.end, name.text});
    if (is_unchecked()) return add(BodyRef{.name = name.text});
    if (const std::optional<std::size_t> built = known_->bodies.find(name.text))
        return add(BodyRef{.name = name.text, .built = built});
    if (known_->bodies.is_shared(name.text)) {
        if (around_.empty() && !property) return add(common(name.text));
        if (around_.empty()) refuse_common(name, *property);
        go_through_copies(name, false);
        return add(BodyRef{.name = name.text, .is_current = true});
    }
    if (known_->bodies.is_spawned(name.text)) return add(BodyRef{.name = name.text});
    refuse_unknown(name, "body");
}

Node NameLookup::property(const Token& name, const Token& word) {
    const Word<BodyProperty>* of_body = find_word(body_words(), word.text);
    const Word<JointProperty>* of_joint = find_word(joint_words(), word.text);
    const std::optional<NamedCopy> joint = is_unchecked() ? std::nullopt : find_joint(name.text);
    const bool is_body = is_unchecked() || is_known_body(name.text);
    if (joint && of_joint && !(is_body && of_body)) return joint_property(name, *joint, word);
    if (!is_body && !joint) refuse_unknown(name, "body or joint");
    if (of_body == nullptr && !(is_unchecked() && of_joint)) {
        const bool has_joint_words = !is_body || is_unchecked();
        const std::vector<std::string_view> words = has_joint_words ? names_of(joint_words()) : names_of(body_words());
        throw ExpressionError(word.begin,
                              std::string("a ") + (is_body ? "body" : "joint") + " has no property '" + word.text + "'",
                              is_body ? own_property(word.text, words) : suggestion(word.text, words));
    }
    if (of_body == nullptr) {
        body(name, Property{word.text, of_joint->kind});
        return {.op = Op::joint_value, .kind = of_joint->kind};
    }
    return {.op = Op::body_value,
            .kind = of_body->kind,
            .code = static_cast<int>(of_body->code),
            .names = {body(name, Property{word.text, of_body->kind})}};
}

Node NameLookup::joint_property(const Token& name, const NamedCopy& joint, const Token& word) {
    const Word<JointProperty>& found = *find_word(joint_words(), word.text);
    const SceneJointType type = known_->scene.joints[joint.source].type;
    if (!has_property(type, found.code)) {
        std::vector<std::string_view> words;
        for (const Word<JointProperty>& one : joint_words())
            if (has_property(type, one.code)) words.push_back(one.name);
        throw ExpressionError(word.begin, "the joint '" + name.text + "' has no " + word.text,
                              "joints of its type have: " + join_words(words));
    }
    program_.spans.push_back({name.begin, name.end, name.text});
    const bool is_common = known_->joints.is_shared(name.text);
    if (is_common && around_.empty()) refuse_common(name, {word.text, found.kind});
    if (is_common) go_through_copies(name, true);
    return {
        .op = Op::joint_value,
        .kind = found.kind,
        .code = static_cast<int>(found.code),
        .names = {add(JointRef{
            .name = name.text, .built = known_->joints.built_index(joint), .type = type, .is_current = is_common})}};
}

std::optional<std::size_t> NameLookup::given_value(const Token& name) const {
    if (is_unchecked()) return std::nullopt;
    const auto found = std::ranges::find(known_->values, name.text);
    if (found == known_->values.end()) return std::nullopt;
    return static_cast<std::size_t>(found - known_->values.begin());
}

void NameLookup::refuse_alone(const Token& name, const std::string& touched) const {
    const bool is_body = is_unchecked() || is_known_body(name.text);
    if (is_body && !is_unchecked() && is_known_body(touched))
        throw ExpressionError(name.begin, "the body '" + name.text + "' alone is no value",
                              "write touching(" + in_expression(name.text) + ", " + in_expression(touched) + ")");
    if (is_body || find_joint(name.text)) {
        const bool is_common =
            !is_unchecked() && (is_body ? known_->bodies.is_shared(name.text) : known_->joints.is_shared(name.text));
        const bool names_one = is_common && around_.empty();
        throw ExpressionError(
            name.begin, std::string("the ") + (is_body ? "body" : "joint") + " '" + name.text + "' alone is no value",
            "ask for a property: " + in_expression(names_one ? copy_name(name.text, 0) : name.text) +
                (is_body ? ".x" : ".force"));
    }
    std::string hint = hint_for_quotes(name.text, known_->scene);
    std::vector<std::string_view> words = names_of(world_words());
    words.insert(words.end(), known_->values.begin(), known_->values.end());
    if (name.text == "t") hint = "did you mean 'time'?";
    if (hint.empty()) hint = suggestion(name.text, words);
    throw ExpressionError(name.begin, "unknown name '" + name.text + "'", hint);
}

void NameLookup::refuse_unknown(const Token& name, const std::string& what) const {
    std::string hint = hint_for_quotes(name.text, known_->scene);
    if (hint.empty()) hint = known_->bodies.hint(name.text);
    if (!hint.starts_with("did you mean") && what != "body")
        if (const std::string of_joint = known_->joints.hint(name.text);
            of_joint.starts_with("did you mean") || of_joint.starts_with("the copies are called"))
            hint = of_joint;
    throw ExpressionError(name.begin, "there is no " + what + " '" + name.text + "'", hint);
}

}  // namespace tumble::scene
