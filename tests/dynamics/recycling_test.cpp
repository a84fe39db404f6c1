// Manifolds that move with their shapes instead of being computed again.
#include "dynamics/contacts/recycling.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "dynamics/contacts/contact.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// Recycles the manifold of a contact between the bodies 0 and 1 at two poses.
Recycling recycle_at(Contact& contact, const Pose& a, const Pose& b) {
    BodyStore bodies;
    bodies.frames.resize(2);
    bodies.frames[0].pose = a;
    bodies.frames[1].pose = b;
    contact.body_b = 1;
    Contact* const contacts[] = {&contact};
    return recycle(contacts, bodies);
}

}  // namespace

TEST_CASE("a recycled manifold moves with the bodies") {
    // Unit boxes, B on top of A, 1 mm apart; both anchors are in the middle of the gap.
    Contact contact;
    ManifoldReference& reference = contact.reference;
    reference.manifold.normal = {0.0f, 1.0f};
    reference.manifold.point_count = 1;
    reference.manifold.points[0] = {{0.5f, 0.5005f}, {0.5f, -0.5005f}, 0.001f, 7};
    reference.offset = {0.0, 1.001};
    reference.reach_a = reference.reach_b = 0.7072f;
    reference.tolerance = 0.01f;
    const Manifold& manifold = contact.manifold;
    const Pose a;

    Pose b{{0.0, 1.0012}, {}};
    CHECK(recycle_at(contact, a, b).recycled == 1);
    CHECK(manifold.point_count == 1);
    CHECK(near(manifold.points[0].separation, 0.0012, kFloat));
    CHECK(manifold.points[0].feature == 7);

    // B turns by 0.5 mrad about its centre: its anchor (0.5, -0.5005) rises by 0.5 sin + 0.5005 (1 - cos) of that. The
    // anchors are floats of half a metre.
    b = {{0.0, 1.001}, make_rotation(5e-4)};
    CHECK(recycle_at(contact, a, b).recycled == 1);
    CHECK(near(manifold.points[0].separation, 0.001 + 0.5 * std::sin(5e-4) + 0.5005 * (1.0 - std::cos(5e-4)),
               absolute(1e-7)));

    // Both turn and travel together, far: nothing has moved between them.
    const Pose turn{{1000.0, -50.0}, make_rotation(1.0)};
    const Pose moved_b{turn.position + rotate(turn.rotation, DVec2{0.0, 1.001}), turn.rotation};
    CHECK(recycle_at(contact, turn, moved_b).moved[0] < 1e-6f);
    CHECK(near(manifold.points[0].separation, 0.001, absolute(1e-7)));
    CHECK(near(manifold.normal.x, -std::sin(1.0), kFloat));

    // What the manifold held before is gone.
    reference.manifold.point_count = 0;
    reference.manifold.points[0] = {};
    CHECK(recycle_at(contact, turn, moved_b).recycled == 1);
    CHECK(manifold.point_count == 0);
    CHECK(manifold.points[0].feature == 0);
    reference.manifold.point_count = 2;
    reference.invalidate();
    CHECK(recycle_at(contact, turn, moved_b).recycled == 0);
    CHECK(manifold.point_count == 0);
}

TEST_CASE("the displacement since a reference bounds that of every point") {
    Contact contact;
    const auto displacement_to = [&](const Pose& b, float reach_a, float reach_b) {
        contact.reference.reach_a = reach_a;
        contact.reference.reach_b = reach_b;
        return recycle_at(contact, {}, b).moved[0];
    };
    CHECK(near(displacement_to({{0.0009, 0.0}, {}}, 1.0f, 1.0f), 0.0009, kFloat));
    // A point at the reach moves along a chord. Half a turn has no sine, and is a large motion all the same.
    for (const double turn : {0.001, 0.1, 1.0, 1.5}) {
        const double chord = 2.0 * std::sin(0.5 * turn);
        const double bound = displacement_to({{}, make_rotation(turn)}, 1.0f, 1.0f);
        CHECK(bound >= chord * (1.0 - 1e-6));
        CHECK(bound <= 1.05 * chord);
    }
    CHECK(std::isinf(displacement_to({{}, {-1.0f, 0.0f}}, 1.0f, 1.0f)));
    // The smaller of the two reaches bounds the displacement by a rotation.
    CHECK(near(displacement_to({{}, make_rotation(0.001)}, 1000.0f, 0.5f), 0.0005, relative(1e-5)));
    CHECK(near(displacement_to({{}, make_rotation(0.001)}, 0.5f, 1000.0f), 0.0005, relative(1e-5)));
}

TEST_CASE("contacts that are recycled together get the manifolds that each gets alone") {
    std::mt19937 random(7);
    const auto value = [&](double size) { return size * (static_cast<double>(random() % 2001) / 1000.0 - 1.0); };
    const auto vector = [&] { return Vec2{static_cast<float>(value(1.0)), static_cast<float>(value(1.0))}; };
    int recycled = 0, kept = 0;
    for (std::size_t count = 1; count <= kLaneCount; ++count) {
        BodyStore bodies;
        std::vector<Contact> together(count);
        std::vector<Contact*> pointers;
        for (Contact& contact : together) {
            contact.body_a = static_cast<std::uint32_t>(bodies.frames.size());
            contact.body_b = contact.body_a + 1;
            bodies.frames.resize(bodies.frames.size() + 2);
            for (std::uint32_t body = contact.body_a; body <= contact.body_b; ++body)
                bodies.frames[body].pose = {{1000.0 + value(1.0), value(1.0)}, make_rotation(value(0.01))};
            ManifoldReference& reference = contact.reference;
            reference.offset = {value(1.0), value(1.0)};
            reference.manifold.point_count = static_cast<int>(random() % 3);
            reference.manifold.normal = vector();
            for (ManifoldPoint& point : reference.manifold.points)
                point = {vector(), vector(), static_cast<float>(value(0.1)), static_cast<std::uint32_t>(random())};
            reference.rotation_b = make_rotation(value(0.1));
            reference.reach_a = random() % 2 == 0 ? 1.0f : 2.0f;
            reference.reach_b = 1.5f;
            reference.tolerance = random() % 2 == 0 ? 5.0f : 1.0f;
            contact.manifold.points[1].separation = 5.0f;
            pointers.push_back(&contact);
        }
        const std::vector<Contact> before = together;
        const Recycling all = recycle(pointers, bodies);
        CHECK(all.recycled < 1u << count);
        for (std::size_t i = 0; i < count; ++i) {
            Contact alone = before[i];
            const Pose a = bodies.frames[alone.body_a].pose, b = bodies.frames[alone.body_b].pose;
            alone.body_a = 0;
            const Recycling one = recycle_at(alone, a, b);
            CHECK(one.recycled == (all.recycled >> i & 1));
            CHECK(one.moved[0] == all.moved[i]);
            CHECK(std::memcmp(&alone.manifold, &together[i].manifold, sizeof(Manifold)) == 0);
            CHECK(together[i].speculative_distance == before[i].speculative_distance);
            (one.recycled ? recycled : kept) += 1;
        }
    }
    CHECK(recycled > 10);
    CHECK(kept > 5);
}
