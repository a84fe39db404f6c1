#include "python/bindings/definitions.hpp"

#include <array>
#include <set>
#include <type_traits>

#include "python/bindings/ids.hpp"
#include "tumble/suggest.hpp"

namespace tumble::python {

namespace {

// ---- One member ----

void read(const py::handle& value, bool& out) { out = value.cast<bool>(); }
void read(const py::handle& value, int& out) { out = value.cast<int>(); }
void read(const py::handle& value, std::uint64_t& out) { out = value.cast<std::uint64_t>(); }
void read(const py::handle& value, float& out) { out = static_cast<float>(value.cast<double>()); }
void read(const py::handle& value, Vec2& out) { out = to_vec2(value.cast<Pair>()); }
void read(const py::handle& value, DVec2& out) { out = to_dvec2(value.cast<Pair>()); }
void read(const py::handle& value, BodyId& out) { out = to_id<BodyId>(value.cast<std::uint64_t>()); }
void read(const py::handle& value, JointId& out) { out = to_id<JointId>(value.cast<std::uint64_t>()); }
void read(const py::handle& value, JointLimits& out) {
    const Pair pair = value.cast<Pair>();
    out = {static_cast<float>(pair.first), static_cast<float>(pair.second)};
}
void read(const py::handle& value, JointSpring& out) {
    const Pair pair = value.cast<Pair>();
    out = {static_cast<float>(pair.first), static_cast<float>(pair.second)};
}
template <class Motor>
requires std::is_same_v<Motor, AngularMotor> || std::is_same_v<Motor, LinearMotor>
void read(const py::handle& value, Motor& out) {
    const Pair pair = value.cast<Pair>();
    out = {static_cast<float>(pair.first), static_cast<float>(pair.second)};
}
void read(const py::handle& value, BodyMass& out) {
    const auto [mass, center, inertia] = value.cast<std::tuple<double, Pair, double>>();
    out = {static_cast<float>(mass), to_vec2(center), static_cast<float>(inertia)};
}
void read(const py::handle& value, BodyLocks& out) {
    const auto [x, y, rotation] = value.cast<std::tuple<bool, bool, bool>>();
    out = {x, y, rotation};
}
void read(const py::handle& value, Pose& out) {
    const auto [x, y, angle] = value.cast<std::tuple<double, double, double>>();
    out = to_pose({x, y}, angle);
}
void read(const py::handle& value, SurfaceMaterial& out) { out = to_material(value.cast<py::dict>()); }
void read(const py::handle& value, CollisionFilter& out) { out = to_filter(value.cast<py::dict>()); }
template <class Enum>
requires std::is_enum_v<Enum>
void read(const py::handle& value, Enum& out) { out = static_cast<Enum>(value.cast<int>()); }
template <class T>
void read(const py::handle& value, std::optional<T>& out) {
    out.reset();
    if (!value.is_none()) read(value, out.emplace());
}

py::object write(bool value) { return py::bool_(value); }
py::object write(int value) { return py::int_(value); }
py::object write(std::uint64_t value) { return py::int_(value); }
py::object write(float value) { return py::float_(double{value}); }
py::object write(Vec2 value) { return to_tuple(value); }
py::object write(DVec2 value) { return to_tuple(value); }
py::object write(BodyId value) { return py::int_(to_number(value)); }
py::object write(JointId value) { return py::int_(to_number(value)); }
py::object write(JointLimits value) { return py::make_tuple(value.lower, value.upper); }
py::object write(JointSpring value) { return py::make_tuple(value.hertz, value.damping_ratio); }
py::object write(AngularMotor value) { return py::make_tuple(value.speed, value.max_torque); }
py::object write(LinearMotor value) { return py::make_tuple(value.speed, value.max_force); }
py::object write(const BodyMass& value) { return py::make_tuple(value.mass, to_tuple(value.center), value.inertia); }
py::object write(BodyLocks value) { return py::make_tuple(value.x, value.y, value.rotation); }
py::object write(const Pose& value) {
    return py::make_tuple(value.position.x, value.position.y, angle(value.rotation));
}
template <class Enum>
requires std::is_enum_v<Enum> py::object write(Enum value) { return py::int_(static_cast<int>(value)); }
template <class T>
py::object write(const std::optional<T>& value) {
    return value ? write(*value) : py::none();
}

// ---- All members of a definition: visit(name, member) for each ----

template <class Visit>
void visit_members(auto& def, Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, WorldDef> {
    visit("gravity", def.gravity), visit("steps_per_second", def.steps_per_second), visit("substeps", def.substeps);
    visit("sleeping", def.sleeping), visit("continuous", def.continuous), visit("joints", def.joints);
    visit("impacts", def.impacts), visit("scale", def.scale);
}

template <class Visit>
void visit_members(auto& def, Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, BodyDef> {
    visit("type", def.type), visit("pose", def.pose), visit("velocity", def.velocity);
    visit("angular_velocity", def.angular_velocity), visit("linear_damping", def.linear_damping);
    visit("angular_damping", def.angular_damping), visit("gravity_scale", def.gravity_scale);
    visit("allow_fast_rotation", def.allow_fast_rotation), visit("bullet", def.bullet);
    visit("allow_sleep", def.allow_sleep), visit("awake", def.awake), visit("locks", def.locks);
    visit("enabled", def.enabled), visit("mass", def.mass), visit("user_data", def.user_data);
}

template <class Visit>
void visit_members(auto& def,
                   Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, SurfaceMaterial> {
    visit("density", def.density), visit("friction", def.friction), visit("restitution", def.restitution);
    visit("rolling_resistance", def.rolling_resistance), visit("tangent_speed", def.tangent_speed);
}

template <class Visit>
void visit_members(auto& def,
                   Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, CollisionFilter> {
    visit("category", def.category), visit("mask", def.mask), visit("group", def.group);
}

template <class Visit>
void visit_members(auto& def, Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, ShapeDef> {
    visit("material", def.material), visit("filter", def.filter), visit("sensor", def.sensor);
    visit("user_data", def.user_data);
}

template <class Visit>
void visit_members(auto& def, Visit&& visit) requires std::is_same_v<std::remove_cvref_t<decltype(def)>, QueryFilter> {
    visit("filter", def.shape), visit("exclude", def.except), visit("sensors", def.sensors);
}

// Any joint: the members that its kind has.
template <class Visit>
void visit_members(auto& def, Visit&& visit) requires requires {
    def.body_a;
}
{
    visit("body_a", def.body_a), visit("body_b", def.body_b);
    if constexpr (requires { def.joint_a; }) visit("joint_a", def.joint_a), visit("joint_b", def.joint_b);
    if constexpr (requires { def.anchor_a; }) visit("anchor_a", def.anchor_a), visit("anchor_b", def.anchor_b);
    if constexpr (requires { def.ground_anchor_a; })
        visit("ground_anchor_a", def.ground_anchor_a), visit("ground_anchor_b", def.ground_anchor_b);
    if constexpr (requires { def.axis_a; }) visit("axis", def.axis_a);
    if constexpr (requires { def.reference_angle; }) visit("reference_angle", def.reference_angle);
    if constexpr (requires { def.length; }) visit("length", def.length);
    if constexpr (requires { def.ratio; }) visit("ratio", def.ratio);
    if constexpr (requires { def.limits; }) visit("limits", def.limits);
    if constexpr (requires { def.motor; }) visit("motor", def.motor);
    if constexpr (requires { def.spring; }) visit("spring", def.spring);
    if constexpr (requires { def.linear_spring; }) visit("linear_spring", def.linear_spring);
    if constexpr (requires { def.angular_spring; }) visit("angular_spring", def.angular_spring);
    if constexpr (requires { def.velocity; }) visit("velocity", def.velocity);
    if constexpr (requires { def.angular_velocity; }) visit("angular_velocity", def.angular_velocity);
    if constexpr (requires { def.max_force; }) visit("max_force", def.max_force);
    if constexpr (requires { def.max_torque; }) visit("max_torque", def.max_torque);
    if constexpr (requires { def.break_force; })
        visit("break_force", def.break_force), visit("break_torque", def.break_torque);
    if constexpr (requires { def.collide_connected; }) visit("collide_connected", def.collide_connected);
    visit("user_data", def.user_data);
}

// Sets what the dictionary names. `also` are names that the package replaces by members, for suggestions.
void set_members(auto& def, const py::dict& members, const char* what, std::vector<std::string> also = {}) {
    std::size_t found = 0;
    std::vector<std::string> names = std::move(also);
    visit_members(def, [&](const char* name, auto& member) {
        names.emplace_back(name);
        if (!members.contains(name)) return;
        ++found;
        try {
            read(members[name], member);
        } catch (const py::cast_error&) {
            throw py::type_error(std::string(what) + " " + name + " cannot be " +
                                 py::repr(members[name]).cast<std::string>());
        }
    });
    if (found == members.size()) return;
    for (const auto& [key, value] : members) {
        const std::string name = py::str(key);
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        const std::string hint = suggestion(name, std::vector<std::string_view>(names.begin(), names.end()));
        throw py::type_error(std::string(what) + " has no '" + name + "'" + (hint.empty() ? "" : ": " + hint));
    }
}

py::dict dict_of(const auto& def) {
    py::dict members;
    visit_members(def, [&](const char* name, const auto& member) { members[name] = write(member); });
    return members;
}

constexpr std::array kKinds{"revolute", "distance", "prismatic", "weld",   "wheel",
                            "motor",    "mouse",    "filter",    "pulley", "gear"};
static_assert(kKinds.size() == std::variant_size_v<JointDef>);

void set_joint_members(JointDef& joint, const py::dict& members, const std::vector<std::string>& also) {
    const std::string what = kind_of(joint) + " joint";
    std::visit(
        [&](auto& def) {
            if constexpr (requires { def.anchor_a; })
                set_members(def, members, what.c_str(), also);
            else  // `anchor` stands for both anchors, which this kind does not have
                set_members(def, members, what.c_str());
        },
        joint);
}

template <std::size_t... index>
void emplace(JointDef& joint, std::size_t wanted, std::index_sequence<index...>) {
    (void)((index == wanted && (joint.emplace<index>(), true)) || ...);
}

}  // namespace

WorldDef to_world_def(const py::dict& members) {
    WorldDef def;
    set_members(def, members, "world");
    return def;
}

BodyDef to_body_def(const py::dict& members) {
    BodyDef def;
    set_members(def, members, "body");
    return def;
}

SurfaceMaterial to_material(const py::dict& members) {
    SurfaceMaterial material;
    set_members(material, members, "material");
    return material;
}

CollisionFilter to_filter(const py::dict& members) {
    CollisionFilter filter;
    set_members(filter, members, "filter");
    return filter;
}

ShapeDef to_shape_def(const Shape& shape, const py::dict& members) {
    ShapeDef def{.shape = shape};
    set_members(def, members, "shape");
    return def;
}

QueryFilter to_query_filter(const py::dict& members) {
    QueryFilter filter;
    set_members(filter, members, "query");
    return filter;
}

JointDef to_joint_def(const std::string& kind, const py::dict& members) {
    const auto found = std::find(kKinds.begin(), kKinds.end(), kind);
    if (found == kKinds.end()) throw std::invalid_argument("there is no joint '" + kind + "'");
    JointDef joint;
    emplace(joint, static_cast<std::size_t>(found - kKinds.begin()),
            std::make_index_sequence<std::variant_size_v<JointDef>>());
    set_joint_members(joint, members, {"anchor"});
    return joint;
}

void change_joint(JointDef& joint, const py::dict& members) { set_joint_members(joint, members, {}); }

std::string kind_of(const JointDef& joint) { return kKinds.at(joint.index()); }

py::dict to_dict(const WorldDef& def) { return dict_of(def); }
py::dict to_dict(const BodyDef& def) { return dict_of(def); }
py::dict to_dict(const SurfaceMaterial& material) { return dict_of(material); }
py::dict to_dict(const CollisionFilter& filter) { return dict_of(filter); }
py::dict to_dict(const JointDef& joint) {
    return std::visit([](const auto& def) { return dict_of(def); }, joint);
}

}  // namespace tumble::python
