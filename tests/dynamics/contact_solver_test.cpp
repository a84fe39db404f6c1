// The contact kernels, their blocks and colours, against closed forms and single contacts.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "dynamics/contacts/contact_block.hpp"
#include "dynamics/contacts/make_contact.hpp"
#include "support/near.hpp"
#include "support/solver_parts.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

Crew crew;  // this thread alone

constexpr float kH = 1.0f / 240.0f;

// What the contact solver works on.
struct SolverParts {
    BodyStore bodies;
    std::vector<Contact> contacts;
    ConstraintGraph graph;
    std::vector<ContactBlock> blocks;
    std::vector<ContactExtras> extras;
};

// Random bodies and random one-point contacts between them, some against a static body.
struct Tangle : SolverParts {
    Tangle(unsigned seed, int body_count, int contact_count) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> value(-1.0f, 1.0f);
        std::vector<BodyId> ids{add_body(bodies, BodyType::static_body, {}, 0.0f, 0.0f)};
        for (int i = 0; i < body_count; ++i) {
            const Vec2 heaviness{1.5f + value(random), 1.5f + value(random)};
            ids.push_back(add_body(bodies, BodyType::dynamic_body, {}, heaviness.x, heaviness.y));
        }
        for (std::size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
            bodies.solver_bodies[i].velocity = {value(random), value(random)};
            bodies.solver_bodies[i].angular_velocity = value(random);
        }
        for (int i = 0; i < contact_count; ++i) {
            const BodyId a = ids[random() % ids.size()], b = ids[random() % ids.size()];
            if (a == b) continue;
            const Rotation turn = make_rotation(3.0 * static_cast<double>(value(random)));
            const Vec2 arm_a{value(random), value(random)}, arm_b{value(random), value(random)};
            contacts.push_back(make_touching(a, b, {turn.c, turn.s}, arm_a, arm_b, 0.01f * value(random)));
            contacts.back().skipped_colors = static_cast<std::uint8_t>(i % 4);
        }
        graph.build(contacts, bodies, crew);
        prepare_contacts(contacts, bodies, graph, {}, {}, kH, BounceBy::solver, blocks, extras, crew);
    }
};

double normal_speed(const Tangle& tangle, const Contact& contact) {
    const auto velocity = [&](std::uint32_t body, Vec2 arm) {
        return velocity_at(tangle.bodies.solver_bodies[tangle.bodies.frames[body].solver_body], arm);
    };
    const ManifoldPoint& point = contact.manifold.points[0];
    const Vec2 relative = velocity(contact.body_b, point.anchor_b) - velocity(contact.body_a, point.anchor_a);
    return static_cast<double>(dot(relative, contact.manifold.normal));
}

// A ball of mass 2 above static ground, with the block of their contact.
SolverParts make_ball_on_ground(float separation, float speed = 0.0f, float impulse = 0.0f) {
    SolverParts made;
    const BodyId ground = add_body(made.bodies, BodyType::static_body, {}, 0.0f, 0.0f);
    const BodyId ball = add_body(made.bodies, BodyType::dynamic_body, {0.0, 0.5}, 2.0f, 0.25f);
    made.bodies.solver_bodies[1].velocity = {0.0f, speed};
    made.contacts.push_back(make_touching(ground, ball, {0.0f, 1.0f}, {}, {0.0f, -0.5f}, separation));
    made.contacts[0].impulses[0].normal = impulse;
    made.graph.build(made.contacts, made.bodies, crew);
    prepare_contacts(made.contacts, made.bodies, made.graph, {}, {}, kH, BounceBy::solver, made.blocks, made.extras,
                     crew);
    REQUIRE(made.blocks.size() == 1);
    return made;
}

}  // namespace

TEST_CASE("every touching contact has one lane, and no block contains a dynamic body twice") {
    const Tangle tangle(1, 40, 200);
    std::multiset<std::uint32_t> seen;
    for (std::size_t i = 0; i < tangle.graph.block_count(); ++i) {
        std::set<std::uint32_t> written;
        for (const std::uint32_t index : tangle.graph.block(i)) {
            if (index == ConstraintGraph::kNoContact) continue;
            seen.insert(index);
            for (const std::uint32_t body : {tangle.contacts[index].body_a, tangle.contacts[index].body_b})
                if (tangle.bodies.is_dynamic(body)) CHECK(written.insert(body).second);
        }
    }
    CHECK(seen.size() == tangle.contacts.size());
    CHECK(std::set<std::uint32_t>(seen.begin(), seen.end()).size() == tangle.contacts.size());
    CHECK(tangle.graph.color_count() <= 24);
}

// Four bodies, and three contacts that share one of them: the greedy choice of the last is the third colour.
TEST_CASE("a contact skips free colours, but never the last one") {
    BodyStore bodies;
    std::vector<BodyId> ids;
    for (int i = 0; i < 4; ++i) ids.push_back(add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f));
    std::vector<Contact> contacts;
    for (std::size_t i = 1; i < 4; ++i) contacts.push_back(make_touching(ids[0], ids[i], {0.0f, 1.0f}, {}, {}, 0.0f));
    contacts[0].skipped_colors = 2;  // the third colour; the next two have the first and the second
    ConstraintGraph graph;
    graph.build(contacts, bodies, crew);
    REQUIRE(graph.block_count() == 3);
    CHECK(graph.block(0)[0] == 1);
    CHECK(graph.block(1)[0] == 2);
    CHECK(graph.block(2)[0] == 0);
    // A hub with as many contacts as there are colours: each skips three, and the last still gets a colour.
    contacts.clear();
    for (int i = 0; i < kDynamicColors; ++i) {
        const BodyId spoke = add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f);
        contacts.push_back(make_touching(ids[0], spoke, {0.0f, 1.0f}, {}, {}, 0.0f));
        contacts.back().skipped_colors = 3;
    }
    graph.build(contacts, bodies, crew);
    CHECK(graph.color_count() == kDynamicColors);
}

// A thread works on a part of each colour and of the solver bodies: it shall be the same part.
TEST_CASE("the contacts of a colour are in the order of parts of the solver bodies") {
    Tangle tangle(6, 320, 1000);
    std::ranges::reverse(tangle.contacts);
    tangle.graph.build(tangle.contacts, tangle.bodies, crew);
    std::set<std::size_t> parts;
    for (const ConstraintGraph::Color& color : tangle.graph.colors(tangle.graph.regions()[0])) {
        std::size_t last = 0;
        for (std::size_t block = color.begin; color.is_independent && block < color.end; ++block) {
            for (const std::uint32_t index : tangle.graph.block(block)) {
                if (index == ConstraintGraph::kNoContact) continue;
                const Contact& contact = tangle.contacts[index];
                const bool has_a = tangle.bodies.is_dynamic(contact.body_a);
                const std::uint32_t body = tangle.bodies.frames[has_a ? contact.body_a : contact.body_b].solver_body;
                const std::size_t part =
                    std::size_t{ConstraintGraph::kParts} * body / tangle.bodies.solver_bodies.size();
                CHECK(part >= last);
                last = part;
                parts.insert(part);
            }
        }
    }
    CHECK(parts.size() == ConstraintGraph::kParts);
}

// They depend on each other, so that their order decides the result.
TEST_CASE("contacts without a colour are solved in the order of contacts, whatever the order of the bodies") {
    BodyStore bodies;
    const BodyId hub = add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f);
    std::vector<BodyId> spokes;
    for (int i = 0; i < 40; ++i) spokes.push_back(add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f));
    std::shuffle(spokes.begin(), spokes.end(), std::mt19937(2));
    std::vector<Contact> contacts;
    for (const BodyId spoke : spokes) contacts.push_back(make_touching(spoke, hub, {0.0f, 1.0f}, {}, {}, 0.0f));
    ConstraintGraph graph;
    graph.build(contacts, bodies, crew);
    std::vector<std::uint32_t> without;
    for (const ConstraintGraph::Color& color : graph.colors(graph.regions()[0]))
        for (std::size_t block = color.begin; !color.is_independent && block < color.end; ++block)
            without.push_back(graph.block(block)[0]);
    CHECK(without.size() == spokes.size() - kDynamicColors);
    CHECK(std::ranges::is_sorted(without));
}

// A graph keeps its colours while contacts and bodies stay the same: after each change it has those of a new one.
TEST_CASE("the colours follow each change of contacts and bodies") {
    Tangle tangle(5, 12, 40);
    std::vector<Contact>& contacts = tangle.contacts;
    BodyStore& bodies = tangle.bodies;
    const auto check_colors = [&] {
        ConstraintGraph fresh;
        fresh.build(contacts, bodies, crew);
        for (int repeat = 0; repeat < 2; ++repeat) {
            tangle.graph.build(contacts, bodies, crew);
            REQUIRE(tangle.graph.block_count() == fresh.block_count());
            CHECK(tangle.graph.color_count() == fresh.color_count());
            for (std::size_t i = 0; i < fresh.block_count(); ++i)
                CHECK(std::ranges::equal(tangle.graph.block(i), fresh.block(i)));
            for (std::uint32_t body = 1; body < bodies.solver_bodies.size(); ++body)
                CHECK(tangle.graph.has_contact(body) == fresh.has_contact(body));
        }
    };
    check_colors();
    contacts[3].is_bouncing = true;
    check_colors();
    contacts[3].is_bouncing = false;
    contacts[7].manifold.point_count = 0;
    check_colors();
    contacts[9].skipped_colors ^= 3;
    check_colors();
    std::swap(contacts[1], contacts[12]);
    check_colors();
    std::swap(contacts[2].body_b, contacts[5].body_b);
    check_colors();
    contacts.pop_back();
    check_colors();
    // A contact with a kinematic body has other colours. The last solver body stays the last one.
    const std::uint32_t last = bodies.moving.back().body;
    std::erase_if(contacts, [&](const Contact& of) {
        const std::uint32_t other = of.body_a == last ? of.body_b : of.body_a;
        return (of.body_a == last || of.body_b == last) && !bodies.is_dynamic(other);
    });
    REQUIRE(std::ranges::any_of(contacts, [&](const Contact& of) { return of.body_a == last || of.body_b == last; }));
    check_colors();
    bodies.set_type(last, BodyType::kinematic_body);
    REQUIRE(bodies.moving.back().body == last);
    check_colors();
    // The last solver body takes the place of one that leaves.
    const std::uint32_t leaving = bodies.moving[1].body;
    std::erase_if(contacts, [&](const Contact& of) { return of.body_a == leaving || of.body_b == leaving; });
    check_colors();
    bodies.put_to_sleep(leaving);
    check_colors();
    bodies.wake(leaving);
    check_colors();
    contacts.clear();
    check_colors();
}

// Each number is drawn by a quarter of the contacts: 2500 of 10 000, with a deviation of sqrt(10 000 * 3 / 16) = 43.
TEST_CASE("solid contacts between dynamic bodies draw each number of skipped colours equally often") {
    BodyStore bodies;
    std::vector<BodyId> ids;
    for (int i = 0; i < 11; ++i)
        ids.push_back(add_body(bodies, i == 10 ? BodyType::static_body : BodyType::dynamic_body, {}, 1.0f, 1.0f));
    std::array<int, 4> counts{};
    for (std::size_t i = 0; i < 10000; ++i) {
        Contact contact = make_touching(ids[i % 10], ids[(i + 1 + i / 10 % 9) % 10], {0.0f, 1.0f}, {}, {}, 0.0f);
        draw_colors(contact, bodies);
        REQUIRE(contact.skipped_colors < 4);
        ++counts[contact.skipped_colors];
    }
    for (const int count : counts) CHECK(std::abs(count - 2500) < 5 * 43);
    const std::uint32_t seed = bodies.records[ids[0].index].color_seed;
    Contact on_ground = make_touching(ids[0], ids[10], {0.0f, 1.0f}, {}, {}, 0.0f);
    Contact sensor = make_touching(ids[0], ids[1], {0.0f, 1.0f}, {}, {}, 0.0f);
    sensor.kind = ContactKind::sensor_a;
    for (Contact* const contact : {&on_ground, &sensor}) {
        draw_colors(*contact, bodies);
        CHECK(contact->skipped_colors == 0);
        CHECK(bodies.records[ids[0].index].color_seed == seed);
    }
}

TEST_CASE("contacts without a colour are solved in blocks of their own") {
    BodyStore bodies;
    const BodyId hub = add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f);
    std::vector<Contact> contacts;
    for (int i = 0; i < 30; ++i) {
        const BodyId spoke = add_body(bodies, BodyType::dynamic_body, {}, 1.0f, 1.0f);
        contacts.push_back(make_touching(hub, spoke, {0.0f, 1.0f}, {}, {}, 0.0f));
    }
    ConstraintGraph graph;
    graph.build(contacts, bodies, crew);
    CHECK(graph.color_count() == kDynamicColors);
    CHECK(graph.block_count() == 30);  // 16 blocks of one lane by colour, 14 without
    for (std::size_t i = 0; i < graph.block_count(); ++i)
        CHECK(std::ranges::count(graph.block(i), ConstraintGraph::kNoContact) == kLaneCount - 1);
}

TEST_CASE("the relax pass leaves the last contacts that it solves without approach") {
    Tangle tangle(2, 40, 30);
    relax_contacts(tangle.blocks, tangle.bodies.solver_bodies, 1.0f / kH, FrictionBound::rigid);
    // Nothing is solved after the last block: there s / h + v >= 0, up to rounding of sums of a few m/s.
    int carried = 0;
    for (const std::uint32_t index : tangle.graph.block(tangle.graph.block_count() - 1)) {
        if (index == ConstraintGraph::kNoContact) continue;
        const Contact& contact = tangle.contacts[index];
        const double gap_speed = static_cast<double>(std::max(0.0f, contact.manifold.points[0].separation) / kH);
        CHECK(normal_speed(tangle, contact) + gap_speed > -1e-5);
        ++carried;
    }
    CHECK(carried > 0);
}

TEST_CASE("a soft contact gets the impulse of the closed form") {
    // A ball of mass 2 on the ground, overlap 1 cm, falling at 0.5 m/s, no impulse before; static softness:
    // x = -m (mass_scale v + bias) with the bias max(mass_scale bias_rate s, -2.5).
    auto [bodies, contacts, graph, blocks, extras] = make_ball_on_ground(-0.01f, -0.5f);
    solve_contacts(blocks, bodies.solver_bodies, 1.0f / kH, kPushOutSpeed);
    const double omega = 2.0 * kPi * 85.2, h = 1.0 / 240.0;
    const double a1 = 2.0 * 8.0 + h * omega, a2 = h * omega * a1, mass_scale = a2 / (1.0 + a2);
    const double bias = std::max(mass_scale * (omega / a1) * -0.01, -2.5);
    const double impulse = -2.0 * (mass_scale * -0.5 + bias);
    CHECK(near(blocks[0].points[0].normal_impulse[0], impulse, kFloat));
    CHECK(near(bodies.solver_bodies[1].velocity.y, -0.5 + impulse / 2.0, kFloat));
}

TEST_CASE("a soft contact without overlap and velocity takes back the part a3 of its impulse") {
    auto [bodies, contacts, graph, blocks, extras] = make_ball_on_ground(0.0f, 0.0f, 3.0f);
    solve_contacts(blocks, bodies.solver_bodies, 1.0f / kH, kPushOutSpeed);
    const double omega = 2.0 * kPi * 85.2, h = 1.0 / 240.0;
    const double a2 = h * omega * (2.0 * 8.0 + h * omega), a3 = 1.0 / (1.0 + a2);
    CHECK(near(blocks[0].points[0].normal_impulse[0], 3.0 * (1.0 - a3), kFloat));
}

// Otherwise the closed form of free flight would replace its motion.
TEST_CASE("a body that friction alone has pushed counts as pushed") {
    for (const float tangent : {0.0f, -0.5f}) {
        CAPTURE(tangent);
        auto [bodies, contacts, graph, blocks, extras] = make_ball_on_ground(0.01f);
        blocks[0].points[0].applied_tangent[0] = tangent;
        store_impulses(blocks, graph, graph.regions()[0], contacts, bodies.solver_bodies, crew);
        CHECK(contacts[0].applied[0].tangent == tangent);
        CHECK(((bodies.solver_bodies[1].flags & kPushedBody) != 0) == (tangent != 0.0f));
    }
}

TEST_CASE("unused lanes and absent points stay neutral through every pass") {
    Tangle tangle(3, 6, 5);
    for (int pass = 0; pass < 4; ++pass) {
        warm_start_contacts(tangle.blocks, tangle.bodies.solver_bodies);
        solve_contacts(tangle.blocks, tangle.bodies.solver_bodies, 1.0f / kH, kPushOutSpeed);
        relax_contacts(tangle.blocks, tangle.bodies.solver_bodies, 1.0f / kH, FrictionBound::rigid);
    }
    for (std::size_t i = 0; i < tangle.blocks.size(); ++i)
        for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
            const auto at = static_cast<Eigen::Index>(lane);
            CHECK(tangle.blocks[i].points[1].normal_impulse[at] == 0.0f);
            if (tangle.graph.block(i)[lane] != ConstraintGraph::kNoContact) continue;
            CHECK(tangle.blocks[i].points[0].normal_impulse[at] == 0.0f);
            CHECK(tangle.blocks[i].points[0].tangent_impulse[at] == 0.0f);
        }
    CHECK(tangle.bodies.solver_bodies[kStaticSolverBody].velocity == Vec2{});
}

TEST_CASE("two points share a centred push equally, and do not tip the box") {
    BodyStore bodies;
    const BodyId ground = add_body(bodies, BodyType::static_body, {}, 0.0f, 0.0f);
    const BodyId box = add_body(bodies, BodyType::dynamic_body, {0.0, 0.5}, 1.0f, 1.0f / 6.0f);
    bodies.solver_bodies[1].velocity = {0.0f, -1.0f};
    Contact contact = make_touching(ground, box, {0.0f, 1.0f}, {-0.5f, 0.0f}, {-0.5f, -0.5f}, 0.0f);
    contact.manifold.point_count = 2;
    contact.manifold.points[1] = {{0.5f, 0.0f}, {0.5f, -0.5f}, 0.0f, 1};
    const std::vector<Contact> contacts{contact};
    ConstraintGraph graph;
    graph.build(contacts, bodies, crew);
    std::vector<ContactBlock> blocks;
    std::vector<ContactExtras> extras;
    prepare_contacts(contacts, bodies, graph, {}, {}, kH, BounceBy::solver, blocks, extras, crew);
    REQUIRE(blocks.size() == 1);
    relax_contacts(blocks, bodies.solver_bodies, 1.0f / kH, FrictionBound::rigid);
    CHECK(near(blocks[0].points[0].normal_impulse[0], 0.5, kFloat));
    CHECK(blocks[0].points[1].normal_impulse[0] == blocks[0].points[0].normal_impulse[0]);
    CHECK(bodies.solver_bodies[1].angular_velocity == 0.0f);
    CHECK(std::abs(bodies.solver_bodies[1].velocity.y) < 1e-6f);
}
