// Manifolds that move with their shapes instead of being computed again.
#include "dynamics/contacts/recycling.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "dynamics/contacts/contact.hpp"
#include "support/near.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

// From -size to size.
double value(std::mt19937& random, double size) { return size * (static_cast<double>(random() % 2001) / 1000.0 - 1.0); }

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
    // B turns about its origin, 10 m from A. If A reaches farther, the frame is A's, and B's origin stays. If B reaches
    // farther, the frame is B's, and A's origin moves by 10 m x 0.001.
    contact.reference.offset = {10.0, 0.0};
    const auto turned = [&](float reach_a, float reach_b) {
        return displacement_to({{10.0, 0.0}, make_rotation(0.001)}, reach_a, reach_b);
    };
    CHECK(near(turned(1000.0f, 0.5f), 0.0005, relative(1e-5)));
    CHECK(near(turned(0.5f, 1000.0f), 0.0105, relative(1e-4)));
}

namespace {

// (R(q) - 1) v
Vec2 displacement(Rotation q, Vec2 v) {
    const float c = q.c - 1.0f;
    return {c * v.x - q.s * v.y, q.s * v.x + c * v.y};
}

Rotation rotation_since(Rotation before, Rotation now) {
    return {now.c * before.c + now.s * before.s, now.s * before.c - now.c * before.s};
}

// What a contact must have after recycle(), for one contact in plain float.
struct Expected {
    float moved = 0.0f;
    Manifold manifold;

    Expected(const ManifoldReference& reference, const Pose& a, const Pose& b) : manifold(reference.manifold) {
        const Rotation turn_a = rotation_since(reference.rotation_a, a.rotation);
        const Rotation turn_b = rotation_since(reference.rotation_b, b.rotation);
        const Vec2 shift = to_float(b.position - a.position - reference.offset);
        const Vec2 relative =
            shift - displacement(reference.reach_a >= reference.reach_b ? turn_a : turn_b, to_float(reference.offset));
        const Rotation turn = rotation_since(turn_a, turn_b);
        moved = length(relative) +
                std::abs(turn.s) * (1.0f + 0.41422f * (1.0f - turn.c)) * std::min(reference.reach_a, reference.reach_b);
        if (!(turn.c > 0.0f)) moved = std::numeric_limits<float>::infinity();
        const int corners = static_cast<int>(reference.corners);
        const bool is_sharp = corners >= 0, is_edge_of_b = is_sharp && (corners & 4) != 0;
        if (manifold.point_count > 0) manifold.normal = rotate(is_edge_of_b ? turn_b : turn_a, manifold.normal);
        for (int i = 0; i < manifold.point_count; ++i) {
            ManifoldPoint& point = manifold.points[i];
            const Vec2 change_a = displacement(turn_a, point.anchor_a), change_b = displacement(turn_b, point.anchor_b);
            const bool is_end = is_sharp && (corners >> i & 1) != 0;
            const float follows_a = is_sharp && is_edge_of_b != is_end ? 1.0f : 0.0f;  // the point is a corner of A
            const float follows_b = is_sharp && is_edge_of_b == is_end ? 1.0f : 0.0f;
            const Vec2 parted = shift + (change_b - change_a);
            const float opened = dot(parted, manifold.normal);
            const Vec2 half = 0.5f * opened * (follows_b - follows_a) * manifold.normal;
            point.anchor_a += change_a + (follows_b * parted - half);
            point.anchor_b += change_b - (follows_a * parted + half);
            point.separation += opened;
        }
    }
};

// The same bits, but for those of a NaN.
bool same(float x, float y) {
    return std::bit_cast<int>(x) == std::bit_cast<int>(y) || (std::isnan(x) && std::isnan(y));
}

bool same(Vec2 x, Vec2 y) { return same(x.x, y.x) && same(x.y, y.y); }

bool same(const Manifold& x, const Manifold& y) {
    bool points_are = true;
    for (int i = 0; i < 2; ++i) {
        const ManifoldPoint &p = x.points[i], &q = y.points[i];
        points_are &= same(p.anchor_a, q.anchor_a) && same(p.anchor_b, q.anchor_b) && p.feature == q.feature;
        points_are &= same(p.separation, q.separation);
    }
    return points_are && x.point_count == y.point_count && same(x.normal, y.normal);
}

}  // namespace

namespace {

// A box near a flat one, each as A and as B. Both travel and turn, and move by some millimetres and milliradians
// relative to each other: the recycled manifold must be that of a full collision.
struct TwoBoxes {
    bool flat_is_a = false;
    DVec2 position;  // of the box, relative to the flat one
    double angle = 0.0;
    double end = 0.0;        // m, where a corner of the flat box touches an edge, if that is in reach
    double tolerance = 0.0;  // of separations and anchors, m

    Manifold find(const Pose& of_flat, const Pose& of_box, SimplexCache& cache) const {
        const Shape flat = make_box({2.0f, 1.0f}), box = make_box({1.0f, 1.0f});
        return flat_is_a ? collide(flat, of_flat, box, of_box, 0.02, cache)
                         : collide(box, of_box, flat, of_flat, 0.02, cache);
    }

    float corners(const Manifold& manifold, Side edge) const {
        const bool is_edge_of_flat = (edge == Side::a) == flat_is_a;
        float sum = edge == Side::b ? 4.0f : 0.0f;
        for (int i = 0; i < manifold.point_count; ++i) {
            const ManifoldPoint& point = manifold.points[i];
            const double x = static_cast<double>(flat_is_a ? point.anchor_a.x : point.anchor_b.x);
            if ((std::abs(x - end) < 0.02) == is_edge_of_flat) sum += i == 0 ? 1.0f : 2.0f;
        }
        return sum;
    }

    // Returns false if the full collision takes another reference edge, so that there is nothing to compare.
    bool check(std::mt19937& random) const {
        Contact contact;
        ManifoldReference& reference = contact.reference;
        const Pose of_flat{}, of_box{position, make_rotation(angle)};
        SimplexCache cache;
        reference.manifold = find(of_flat, of_box, cache);
        const Side edge = cache.reference_side;
        REQUIRE(edge != Side::none);
        reference.corners = corners(reference.manifold, edge);
        reference.offset = flat_is_a ? position : -position;
        (flat_is_a ? reference.rotation_b : reference.rotation_a) = of_box.rotation;
        reference.tolerance = 0.02f;
        const double turn = value(random, 3.0);
        const Pose flat_now{{value(random, 5.0), value(random, 5.0)}, make_rotation(turn)};
        const DVec2 position_now = position + DVec2{value(random, 0.004), value(random, 0.004)};
        const Pose box_now{flat_now.position + rotate(flat_now.rotation, position_now),
                           make_rotation(turn + angle + value(random, 0.005))};
        CHECK(recycle_at(contact, flat_is_a ? flat_now : box_now, flat_is_a ? box_now : flat_now).recycled == 1);
        const Manifold exact = find(flat_now, box_now, cache);
        if (cache.reference_side != edge) return false;
        REQUIRE(exact.point_count == contact.manifold.point_count);
        CHECK(length(contact.manifold.normal - exact.normal) < 1e-6f);
        for (int i = 0; i < exact.point_count; ++i) {
            const ManifoldPoint &point = contact.manifold.points[i], &wanted = exact.points[i];
            CHECK(near(point.separation, double{wanted.separation}, absolute(tolerance)));
            // The anchor turns with the corner, half the gap from it: by some 5 mrad times 4 mm.
            CHECK(static_cast<double>(length(point.anchor_a - wanted.anchor_a)) < tolerance + 2e-5);
            CHECK(static_cast<double>(length(point.anchor_b - wanted.anchor_b)) < tolerance + 2e-5);
        }
        return true;
    }
};

}  // namespace

TEST_CASE("a corner on an edge is recycled to what a full collision finds") {
    for (int motion = 0; motion < 100; ++motion) {
        CAPTURE(motion);
        std::mt19937 random(static_cast<unsigned>(motion));
        const DVec2 position{0.3 + value(random, 0.4), 0.5 * std::sqrt(2.0) + 0.5 + value(random, 0.003)};
        CHECK(TwoBoxes{motion % 2 == 0, position, 0.25 * kPi + value(random, 0.1), -9.0, 1e-6}.check(random));
    }
}

TEST_CASE("a brick over the end of another one is recycled to what a full collision finds") {
    int compared = 0;
    for (int motion = 0; motion < 100; ++motion) {
        CAPTURE(motion);
        std::mt19937 random(static_cast<unsigned>(motion));
        // A point at the end of the reference edge slides along the other's edge, which leans by up to 8 mrad: 6 mm of
        // that raise it by 0.05 mm.
        compared += TwoBoxes{motion % 2 == 0,
                             {1.2 + value(random, 0.2), 1.0 + value(random, 0.003)},
                             value(random, 0.003),
                             1.0,
                             6e-5}
                        .check(random);
    }
    CHECK(compared > 40);
}

TEST_CASE("eight contacts in lanes are recycled as each of them is in plain float") {
    std::mt19937 random(7);
    const auto vector = [&] {
        return Vec2{static_cast<float>(value(random, 1.0)), static_cast<float>(value(random, 1.0))};
    };
    int recycled = 0, all = 0;
    for (std::size_t round = 0; round < 80; ++round) {
        const std::size_t count = 1 + round % kLaneCount;
        BodyStore bodies;
        std::vector<Contact> contacts(count);
        std::vector<Contact*> pointers;
        for (Contact& contact : contacts) {
            contact.body_a = static_cast<std::uint32_t>(bodies.frames.size());
            contact.body_b = contact.body_a + 1;
            bodies.frames.resize(bodies.frames.size() + 2);
            for (std::uint32_t body = contact.body_a; body <= contact.body_b; ++body)
                bodies.frames[body].pose = {{1000.0 + value(random, 1.0), value(random, 1.0)},
                                            make_rotation(value(random, 1.0))};
            if (random() % 16 == 0) bodies.frames[contact.body_a].pose.position.x = std::nan("");
            if (random() % 16 == 0) bodies.frames[contact.body_b].pose.rotation = {-1.0f, 0.0f};
            ManifoldReference& reference = contact.reference;
            reference.offset = {value(random, 1.0), random() % 4 == 0 ? -0.0 : value(random, 1.0)};
            reference.manifold.point_count = static_cast<int>(random() % 3);
            reference.manifold.normal = vector();
            for (ManifoldPoint& point : reference.manifold.points)
                point = {vector(), vector(), static_cast<float>(value(random, 0.1)),
                         static_cast<std::uint32_t>(random())};
            reference.rotation_b = make_rotation(value(random, 0.1));
            reference.reach_a = random() % 2 == 0 ? 1.0f : 2.0f;
            reference.reach_b = 1.5f;
            reference.tolerance = random() % 8 == 0 ? std::numeric_limits<float>::infinity() : 2.0f;
            reference.corners = static_cast<float>(random() % 9) - 1.0f;
            contact.manifold.points[1].separation = 5.0f;
            pointers.push_back(&contact);
        }
        const std::vector<Contact> before = contacts;
        const Recycling result = recycle(pointers, bodies);
        CHECK(result.recycled < 1u << count);
        for (std::size_t i = 0; i < count; ++i) {
            const Contact &was = before[i], &now = contacts[i];
            const Expected expected(was.reference, bodies.frames[was.body_a].pose, bodies.frames[was.body_b].pose);
            const bool is_recycled = result.recycled >> i & 1;
            CHECK(is_recycled == (expected.moved <= was.reference.tolerance));
            CHECK(same(result.moved[i], expected.moved));
            const Manifold& manifold = is_recycled ? expected.manifold : was.manifold;
            CHECK(same(now.manifold, manifold));
            CHECK(same(now.reference.manifold, was.reference.manifold));
            CHECK(now.speculative_distance == was.speculative_distance);
            recycled += is_recycled;
            ++all;
        }
    }
    CAPTURE(all);
    CHECK(recycled > all * 3 / 10);
    CHECK(recycled < all * 7 / 10);
}
