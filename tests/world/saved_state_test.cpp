// Every number of the saved state counts: changing one changes the snapshot, and forgetting one changes what a user can
// observe of the loaded world.
//
// The tests walk the same lists of members that a snapshot is written by. The second one simulates that a member is
// missing from its list: a list that does leave one out does not compile (visit_members.hpp), and this test shows that
// each member is needed.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "dynamics/bodies/divergence.hpp"
#include "support/worlds.hpp"
#include "tumble/chain.hpp"
#include "world/snapshot.hpp"
#include "world/visit_members.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr int kStepsBefore = 40;

void add_rolling_things(World& world) {
    const SurfaceMaterial rough{1.0f, 0.8f, 0.0f, 0.05f, 0.0f}, bouncy{2.0f, 0.3f, 0.7f, 0.0f, 0.5f};
    add_static(world, {0.0, -1.0}, make_box({200.0f, 2.0f}), rough);
    for (int i = 0; i < 3; ++i) {
        const BodyId ball = add_dynamic(world, {-20.0 + 2.0 * i, 0.5}, make_circle(0.5f), rough);
        world.set_velocity(ball, {1.0f + static_cast<float>(i), 0.0f}, -2.0f);
    }
    add_dynamic(world, {-12.0, 2.2}, make_box({0.8f, 0.6f}, 0.05f), bouncy, 0.3);
    std::vector<Vec2> points;
    for (int i = 0; i < 20; ++i) {
        const Rotation turn = make_rotation(0.1 * kPi * i);
        points.push_back({0.6f * turn.c, 0.4f * turn.s});
    }
    const BodyId large = add_dynamic(world, {-9.0, 0.6}, make_polygon(points), rough, 0.2);
    world.apply_impulse(large, {0.5f, 0.0f});
}

// Two stacks, of which one is put to sleep.
void add_stacks(World& world) {
    BodyId top{};
    for (int stack = 0; stack < 2; ++stack)
        for (int i = 0; i < 3; ++i) {
            top = add_dynamic(world, {-5.0 + 2.0 * stack, 0.5 + i}, make_box({1.0f, 1.0f}), {}, 0.0);
            world.set_damping(top, 0.1f, 0.2f);
        }
    run(world, 20);
    world.set_awake(top, false);
}

// One ball crosses the chain from below, one rests on it.
void add_chain(World& world) {
    BodyDef fixed;
    fixed.type = BodyType::static_body;
    fixed.pose.position = {4.0, 1.0};
    const BodyId ground = world.create_body(fixed);
    const std::vector<Vec2> points{{2.0f, 0.3f}, {1.0f, 0.0f}, {0.0f, 0.0f}, {-1.0f, 0.0f}, {-2.0f, 0.3f}};
    const std::vector<Shape> segments = make_chain(points, false);
    const std::vector<ChainLink> links = make_chain_links(points, false, true);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ShapeDef def;
        def.shape = segments[i];
        def.link = links[i];
        world.add_shape(ground, def);
    }
    add_dynamic(world, {3.2, 1.4}, make_circle(0.3f));
    const BodyId riser = add_dynamic(world, {4.6, 0.4}, make_circle(0.3f));
    world.set_gravity_scale(riser, -0.06f);
    world.set_velocity(riser, {0.1f, 0.9f}, 0.0f);
}

// A sensor with a box inside, a bullet, a kinematic lift, and a locked body.
void add_special_bodies(World& world) {
    const BodyId post = add_static(world, {10.0, 0.5}, make_box({0.1f, 0.1f}));
    ShapeDef sensor;
    sensor.shape = make_box({2.0f, 2.0f});
    sensor.sensor = true;
    world.add_shape(post, sensor);
    add_dynamic(world, {10.5, 1.0}, make_box({0.4f, 0.4f}));
    BodyDef bullet;
    bullet.bullet = true;
    bullet.allow_fast_rotation = true;
    bullet.pose.position = {12.0, 5.0};
    bullet.velocity = {3.0f, -2.0f};
    world.add_shape(world.create_body(bullet), {make_circle(0.1f)});
    const BodyId lift = add_body(world, BodyType::kinematic_body, {15.0, 1.0}, make_box({1.0f, 0.2f}));
    world.set_velocity(lift, {0.0f, 0.3f}, 0.1f);
    const BodyId rider = add_dynamic(world, {15.0, 1.4}, make_box({0.5f, 0.5f}));
    world.set_locks(rider, {true, false, true});
    BodyDef heavy;
    heavy.pose.position = {17.0, 3.0};
    heavy.mass = BodyMass{3.0f, {0.1f, 0.0f}, 0.5f};
    world.add_shape(world.create_body(heavy), {make_capsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f)});
}

template <class Def>
Def between(World& world, double x, Def def) {
    def.body_a = add_dynamic(world, {x, 6.0}, make_box({0.6f, 0.3f}));
    def.body_b = add_dynamic(world, {x + 0.7, 6.1}, make_box({0.6f, 0.3f}), {}, 0.1);
    if constexpr (requires { def.anchor_a; }) {
        def.anchor_a = {0.35f, 0.05f};
        def.anchor_b = {-0.35f, 0.0f};
    }
    return def;
}

void add_joints(World& world) {
    const JointSpring spring{3.0f, 0.3f};
    RevoluteJointDef hinge;
    hinge.limits = JointLimits{-0.1f, 0.2f};
    hinge.motor = AngularMotor{2.0f, 1.0f};
    hinge.spring = spring;
    hinge.break_force = 4000.0f;
    const JointId hinge_id = world.create_joint(between(world, 20.0, hinge));
    PrismaticJointDef slider;
    slider.limits = JointLimits{-0.1f, 0.1f};
    slider.motor = LinearMotor{1.0f, 5.0f};
    slider.spring = spring;
    slider.break_torque = 4000.0f;
    const JointId slider_id = world.create_joint(between(world, 23.0, slider));
    GearJointDef gear;
    gear.joint_a = hinge_id;
    gear.joint_b = slider_id;
    gear.ratio = 0.5f;
    world.create_joint(gear);
    world.create_joint(
        between(world, 26.0, DistanceJointDef{.length = 0.2f, .limits = JointLimits{0.05f, 0.3f}, .spring = spring}));
    world.create_joint(between(world, 29.0, WeldJointDef{.linear_spring = spring, .angular_spring = spring}));
    world.create_joint(between(world, 32.0, WeldJointDef{}));
    world.create_joint(between(
        world, 35.0,
        WheelJointDef{.limits = JointLimits{-0.05f, 0.05f}, .motor = AngularMotor{3.0f, 1.0f}, .spring = spring}));
    world.create_joint(between(
        world, 38.0,
        MotorJointDef{.velocity = {0.1f, 0.2f}, .angular_velocity = 0.3f, .max_force = 20.0f, .max_torque = 3.0f}));
    world.create_joint(between(world, 41.0, MouseJointDef{.max_force = 30.0f}));
    world.create_joint(between(world, 44.0, FilterJointDef{}));
    PulleyJointDef pulley = between(world, 47.0, PulleyJointDef{.length = 3.0f, .ratio = 1.5f});
    pulley.ground_anchor_a = {47.0, 8.0};
    pulley.ground_anchor_b = {48.0, 7.0};
    world.create_joint(pulley);
}

// All kinds of things, saved in motion.
std::vector<std::byte> save_world_of_all_kinds() {
    World world;
    add_rolling_things(world);
    add_stacks(world);
    add_chain(world);
    add_special_bodies(world);
    add_joints(world);
    run(world, kStepsBefore);
    return world.save();
}

// A world taken apart into what a snapshot contains.
struct Parts {
    WorldDef def;
    Simulation simulation;
    std::uint64_t step_count = 0;
    std::uint32_t diverged_body = kNoBody;

    explicit Parts(const std::vector<std::byte>& bytes) {
        read_snapshot(bytes, snapshot());
        simulation.settings = {def.gravity,    1.0f / def.steps_per_second, def.substeps, def.sleeping,
                               def.continuous, make_tuning(def.scale)};
    }

    SnapshotParts snapshot() { return {def, simulation, step_count, diverged_body}; }
    std::vector<std::byte> save() { return write_snapshot(snapshot()); }

    template <class Visitor>
    void visit(Visitor& visitor) {
        SimulationState& state = simulation;
        visit_value(visitor, state);
    }
};

// Calls change(value, member) for each number. A member's name is made of its positions in the lists of members; all
// elements of a vector have the same.
template <class Change>
class Walk {
public:
    explicit Walk(Change change) : change_(std::move(change)) {}

    template <class T>
    void leaf(T& value) {
        change_(value, name());
    }
    template <class T>
    void list(std::vector<T>& values) {
        nested("[]", [&] {
            for (T& value : values) {
                positions_.back() = 0;
                visit_value(*this, value);
            }
        });
    }
    template <class T>
    void optional(std::optional<T>& value) {
        nested("?", [&] {
            if (value) visit_value(*this, *value);
        });
    }
    template <class... T>
    void variant(std::variant<T...>& value) {
        nested("#" + std::to_string(value.index()),
               [&] { std::visit([&](auto& alternative) { visit_value(*this, alternative); }, value); });
    }
    void shape(Shape& shape) {
        std::vector<Vec2> vertices;
        for (int i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
        float radius = shape.radius();
        nested("shape", [&] {
            leaf(radius);
            list(vertices);
        });
        shape = Shape::from_raw(vertices, radius);
    }

private:
    // The name of the member at the present position, which moves on.
    std::string name() { return prefix_ + "." + std::to_string(positions_.back()++); }

    template <class Body>
    void nested(const std::string& kind, Body&& body) {
        const std::string outer = prefix_;
        prefix_ = name() + kind;
        positions_.push_back(0);
        body();
        positions_.pop_back();
        prefix_ = outer;
    }

    Change change_;
    std::string prefix_;
    std::vector<int> positions_{0};
};

template <class T>
void change_slightly(T& value) {
    if constexpr (std::is_same_v<T, bool>)
        value = !value;
    else if constexpr (std::is_floating_point_v<T>)
        value = std::isfinite(value) && value != T(0) ? value * T(1.25) : T(1);
    else
        value = static_cast<T>(static_cast<std::uint64_t>(value) ^ 1u);
}

// True for what may take any value: indices and counts are the audit's subject.
template <class T>
constexpr bool is_free = std::is_floating_point_v<T> || std::is_same_v<T, bool>;

// Sets a member to a value in all of its owners.
template <class Parts>
void forget(Parts& parts, const std::string& member, int value) {
    Walk walk([&]<class T>(T& number, const std::string& name) {
        if constexpr (is_free<T>)
            if (name == member) number = static_cast<T>(value);
    });
    parts.visit(walk);
}

// What a user observes of a world, as numbers.
class Transcript {
public:
    void add(const World& world) {
        add(static_cast<double>(world.state_hash() >> 11));
        for (const ContactPoint& point : world.contacts()) {
            add(point.point.x), add(point.point.y), add(point.normal.x), add(point.normal.y);
            add(point.separation), add(point.normal_impulse), add(point.tangent_impulse);
        }
        const StepEvents& events = world.events();
        for (const ContactBegin& begin : events.contact_begins)
            add(begin.point.x), add(begin.point.y), add(begin.normal.x), add(begin.normal.y), add(begin.approach_speed);
        for (const ContactHit& hit : events.contact_hits) add(hit.point.x), add(hit.approach_speed);
        add(static_cast<double>(events.contact_ends.size() + 100 * events.sensor_begins.size()));
        for (const JointId id : world.joints()) {
            const JointReaction reaction = world.reaction(id);
            add(reaction.force.x), add(reaction.force.y), add(reaction.torque), add(world.joint_position(id));
        }
        for (const BodyId id : world.bodies()) {
            add(world.mass(id).mass), add(world.mass(id).inertia), add(world.mass(id).center.x);
            add(world.mass(id).center.y);
        }
    }

    bool operator==(const Transcript&) const = default;

private:
    void add(double number) { numbers_.push_back(number == number ? number : 1e300); }

    std::vector<double> numbers_;
};

void run_on(World& world, int steps, Transcript& transcript) {
    for (int i = 0; i < steps; ++i) {
        world.step();
        transcript.add(world);
    }
}

// Goes on for some steps, between them with edits that need what no step reads: definitions, materials, sleeping
// contacts.
Transcript observe(const std::vector<std::byte>& saved) {
    World world = World::load(saved);
    Transcript transcript;
    transcript.add(world);
    run_on(world, 3, transcript);
    const std::vector<BodyId> bodies(world.bodies().begin(), world.bodies().end());
    for (const BodyId id : bodies) world.set_awake(id, true);
    run_on(world, 3, transcript);
    const std::vector<JointId> joints(world.joints().begin(), world.joints().end());
    for (const JointId id : joints)
        if (world.is_valid(id)) world.set_joint(id, world.joint(id));
    for (const BodyId id : bodies)
        for (const ShapeId shape : world.shapes(id)) world.set_material(shape, world.material(shape));
    run_on(world, 3, transcript);
    for (const BodyId id : bodies) {
        const bool was_enabled = world.is_enabled(id);
        world.set_enabled(id, !was_enabled);
        world.set_enabled(id, was_enabled);
    }
    run_on(world, 3, transcript);
    return transcript;
}

// True if a user notices that a member has this value, or the snapshot is refused.
bool is_noticed(const std::vector<std::byte>& saved, const Transcript& whole, const std::string& member, int value) {
    Parts parts(saved);
    forget(parts, member, value);
    const std::vector<std::byte> forgetful = parts.save();
    if (forgetful == saved) return false;
    try {
        return observe(forgetful) != whole;
    } catch (const std::exception&) {
        return true;
    }
}

}  // namespace

// Every 61st number: writing the state for each would take minutes, and 61 divides the size of no struct.
TEST_CASE("each saved number changes the snapshot") {
    const std::vector<std::byte> saved = save_world_of_all_kinds();
    REQUIRE(Parts(saved).save() == saved);
    constexpr std::size_t kStride = 61;
    std::size_t count = 0;
    for (std::size_t target = 0; target <= count; target += kStride) {
        CAPTURE(target);
        Parts parts(saved);
        count = 0;
        Walk walk([&](auto& number, const std::string&) {
            if (count++ == target) change_slightly(number);
        });
        parts.visit(walk);
        if (target < count) CHECK(parts.save() != saved);
    }
    CHECK(count > 5000);
}

// A debug build aborts at some of the states that this makes.
#ifdef NDEBUG
TEST_CASE("a user notices each member that is missing from the saved state") {
    const std::vector<std::byte> saved = save_world_of_all_kinds();
    const Transcript whole = observe(saved);
    REQUIRE(observe(saved) == whole);
    std::set<std::string> members;
    Parts parts(saved);
    Walk walk([&]<class T>(T&, const std::string& name) {
        if constexpr (is_free<T>) members.insert(name);
    });
    parts.visit(walk);
    std::string unnoticed;
    int count = 0;
    for (const std::string& member : members)
        if (!is_noticed(saved, whole, member, 0) && !is_noticed(saved, whole, member, 1))
            unnoticed += member + "\n", ++count;
    INFO(unnoticed);
    CHECK(members.size() > 100);
    CHECK(count == 0);
}
#endif
