// Every number of the saved state is needed: changing one changes the snapshot, and forgetting one changes what a user
// can observe of the loaded world.
//
// The tests walk the same lists of members that a snapshot is written by. The second one simulates that a member is
// missing from its list: a list that does leave one out does not compile (visit_members.hpp), and this test shows that
// each member is needed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "support/world_of_all_kinds.hpp"
#include "support/world_parts.hpp"
#include "world/visit_members.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

template <class Visitor>
void visit_state(WorldParts& parts, Visitor& visitor) {
    SimulationState& state = parts.simulation;
    visit_value(visitor, state);
}

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
void forget(WorldParts& parts, const std::string& member, int value) {
    Walk walk([&]<class T>(T& number, const std::string& name) {
        if constexpr (is_free<T>)
            if (name == member) number = static_cast<T>(value);
    });
    visit_state(parts, walk);
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
        for (const ContactHit& hit : events.contact_hits)
            add(hit.point.x), add(hit.point.y), add(hit.normal.x), add(hit.normal.y), add(hit.approach_speed);
        for (const ContactEnd& end : events.contact_ends) add(end.shape_a), add(end.shape_b);
        for (const SensorEvent& begin : events.sensor_begins) add(begin.sensor), add(begin.visitor);
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
    void add(ShapeId id) { add(id.index + 0.001 * id.generation); }
    void add(double number) { numbers_.push_back(number == number ? number : 1e300); }

    std::vector<double> numbers_;
};

void run_on(World& world, int steps, Transcript& transcript) {
    for (int i = 0; i < steps; ++i) {
        world.step();
        transcript.add(world);
    }
}

// Pushes each sleeping body while all others sleep, so that its contacts share no block with those of others.
void push_sleepers(const std::vector<std::byte>& saved, Transcript& transcript) {
    World world = World::load(saved);
    const std::vector<BodyId> bodies(world.bodies().begin(), world.bodies().end());
    std::vector<BodyId> sleepers;
    std::ranges::copy_if(bodies, std::back_inserter(sleepers), [&](BodyId id) { return !world.is_awake(id); });
    for (const BodyId id : sleepers) {
        for (const BodyId other : bodies) world.set_awake(other, false);
        world.set_awake(id, true);
        world.set_velocity(id, {1.0f, 0.0f}, -1.0f);
        run_on(world, 2, transcript);
    }
}

// Continues for some steps. The edits between them need what no step reads: definitions, materials, sleeping contacts.
Transcript observe(const std::vector<std::byte>& saved) {
    World world = World::load(saved);
    Transcript transcript;
    transcript.add(world);
    push_sleepers(saved, transcript);
    run_on(world, 3, transcript);
    for (int i = 0; i < 6; ++i) {  // over and through the chain
        const BodyId ball = add_dynamic(world, {2.2 + 0.6 * i, i % 2 == 0 ? 1.7 : 0.6}, make_circle(0.25f));
        world.set_velocity(ball, {0.5f, i % 2 == 0 ? -3.0f : 4.0f}, 0.0f);
    }
    const std::vector<BodyId> bodies(world.bodies().begin(), world.bodies().end());
    for (const BodyId id : bodies) world.set_awake(id, true);
    run_on(world, 3, transcript);
    const std::vector<JointId> joints(world.joints().begin(), world.joints().end());
    for (const JointId id : joints)
        if (world.is_valid(id)) world.set_joint(id, world.joint(id));
    for (const BodyId id : bodies)
        for (const ShapeId shape : world.shapes(id)) world.set_material(shape, world.material(shape));
    run_on(world, 20, transcript);
    for (const BodyId id : bodies) {
        const bool was_enabled = world.is_enabled(id);
        world.set_enabled(id, !was_enabled);
        world.set_enabled(id, was_enabled);
    }
    run_on(world, 3, transcript);
    for (std::size_t i = 1; i < bodies.size(); i += 2) world.destroy_body(bodies[i]);
    run_on(world, 40, transcript);
    return transcript;
}

}  // namespace

#ifdef NDEBUG
constexpr bool kHasChecks = false;
#else
constexpr bool kHasChecks = true;
#endif

// With checks on, every 61st number, to save time; 61 divides the size of no struct.
constexpr std::size_t kStride = kHasChecks ? 61 : 1;

TEST_CASE("each saved number changes the snapshot") {
    const std::vector<std::byte> saved = make_world_of_all_kinds().save();
    REQUIRE(WorldParts(saved).save() == saved);
    std::size_t count = 0;
    for (std::size_t target = 0; target <= count; target += kStride) {
        CAPTURE(target);
        WorldParts parts(saved);
        count = 0;
        Walk walk([&](auto& number, const std::string&) {
            if (count++ == target) change_slightly(number);
        });
        visit_state(parts, walk);
        if (target < count) CHECK(parts.save() != saved);
    }
    CHECK(count > 5000);
}

namespace {

// True if a user notices that a member has this value, or the snapshot is refused.
bool is_noticed(const std::vector<std::byte>& saved, const Transcript& whole, const std::string& member, int value) {
    WorldParts parts(saved);
    forget(parts, member, value);
    const std::vector<std::byte> forgetful = parts.save();
    if (forgetful == saved) return false;
    try {
        return observe(forgetful) != whole;
    } catch (const std::exception&) {
        return true;
    }
}

// Members that a user need not notice here: names, or the beginnings of names. The first number is the position among
// the lists of SimulationState, the others are positions within an element.
constexpr const char* kUnnoticed[] = {
    // Reach, smallest extent and allow_sleep of a body: no body that is swept turns much, and none falls asleep twice.
    ".4[].10", ".4[].11", ".6[].4", ".6[].5", ".6[].8",
    // The horizontal rest of a velocity: no body that flies has a horizontal acceleration.
    ".6[].11",
    // Points of a chain beside a segment: no shape touches its corner.
    ".11[].17?.0", ".11[].17?.1", ".11[].17?.2", ".11[].17?.3", ".11[].17?.4",
    // Definitions of joints: collide_connected where the shapes do not touch, and limits that are not reached.
    ".16[].0#",
    // Joints are unsorted: sorting them once more changes nothing.
    ".19",
    // Working data of the kinds of joints, which prepare() and update_rows() derive from definitions and poses.
    ".20[].", ".23[].", ".26[].", ".29[].", ".32[].", ".35[].", ".38[].", ".41[].", ".44[].",
    // Contacts, awake and asleep: anchors, is_new, is_bouncing, is_struck, is_touching, was_hit, the approach and the
    // distance of the surfaces are set before they are read. No shape that sleeps is round or bounces.
    ".67[].9", ".67[].10", ".67[].15", ".67[].16", ".67[].30", ".67[].31", ".67[].32", ".67[].33", ".67[].36",
    ".67[].37", ".67[].38", ".67[].39", ".67[].40", ".67[].41", ".67[].50", ".67[].56", ".67[].78", ".69[].1[].9",
    ".69[].1[].10", ".69[].1[].15", ".69[].1[].16", ".69[].1[].30", ".69[].1[].31", ".69[].1[].32", ".69[].1[].33",
    ".69[].1[].36", ".69[].1[].37", ".69[].1[].38", ".69[].1[].39", ".69[].1[].40", ".69[].1[].41", ".69[].1[].56",
    ".69[].1[].78", ".69[].1[].80", ".69[].1[].83",
    // Chain crossings before and in the step: they only skip a search that would find nothing.
    ".84", ".85"};

bool need_not_be_noticed(const std::string& member) {
    return std::ranges::any_of(kUnnoticed, [&](const std::string& name) {
        const bool is_beginning = name.back() == '.' || name.back() == '#';
        return is_beginning ? member.starts_with(name) : member == name;
    });
}

}  // namespace

// TUMBLE_CHECK aborts at some of the states that this makes.
TEST_CASE("a user notices each member that is missing from the saved state" * doctest::skip(kHasChecks)) {
    const std::vector<std::byte> saved = make_world_of_all_kinds().save();
    const Transcript whole = observe(saved);
    REQUIRE(observe(saved) == whole);
    std::set<std::string> members;
    WorldParts parts(saved);
    Walk walk([&]<class T>(T&, const std::string& name) {
        if constexpr (is_free<T>) members.insert(name);
    });
    visit_state(parts, walk);
    int noticed = 0;
    for (const std::string& member : members) {
        const bool is_needed = is_noticed(saved, whole, member, 0) || is_noticed(saved, whole, member, 1);
        noticed += is_needed;
        CAPTURE(member);
        CHECK((is_needed || need_not_be_noticed(member)));
    }
    CAPTURE(members.size());
    CHECK(noticed > 200);
}
