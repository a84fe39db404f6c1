// Regions of solver bodies that no contact connects, and that they do not change the result.
#include "dynamics/contacts/regions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "dynamics/contacts/contact_block.hpp"
#include "dynamics/contacts/contact_solver.hpp"
#include "support/random_numbers.hpp"
#include "support/solver_parts.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

Crew crew;  // this thread alone

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // of solver bodies, the lower one first

bool may_start_at(std::uint32_t body, const std::vector<Edge>& edges) {
    return std::ranges::none_of(edges, [&](const Edge& edge) { return edge.first < body && body <= edge.second; });
}

// The same by its definition: each region is as short as possible.
std::vector<std::uint32_t> expected_bounds(std::uint32_t count, const std::vector<Edge>& edges, std::uint32_t least) {
    std::vector<std::uint32_t> bounds{1};
    for (std::uint32_t i = 2; i < count; ++i)
        if (i - bounds.back() >= least && count - i >= least && may_start_at(i, edges)) bounds.push_back(i);
    bounds.push_back(count);
    return bounds;
}

// Clusters of dynamic bodies, side by side among the solver bodies, and a static and a kinematic body.
struct Clusters {
    BodyStore bodies;
    std::vector<Contact> contacts;

    explicit Clusters(RandomNumbers& random) {
        const BodyId ground = add(random, BodyType::static_body);
        const BodyId lift = add(random, BodyType::kinematic_body);
        for (int cluster = 0; cluster < 5; ++cluster) {
            std::vector<BodyId> own;
            const std::size_t size = 3 + random.below(8);
            for (std::size_t i = 0; i < size; ++i) own.push_back(add(random, BodyType::dynamic_body));
            for (std::size_t i = 1; i < own.size(); ++i) touch(random, own[random.below(i)], own[i]);
            touch(random, ground, own[random.below(own.size())]);
            if (cluster == 0) touch(random, lift, own.back());
        }
    }

private:
    BodyId add(RandomNumbers& random, BodyType type) {
        const BodyId id = add_body(bodies, type, {}, random.between(1.0f, 3.0f), 1.0f);
        if (type != BodyType::static_body) bodies.solver_bodies.back().velocity = random.vector(1.0f);
        return id;
    }

    void touch(RandomNumbers& random, BodyId a, BodyId b) {
        const Rotation turn = make_rotation(double{random.between(-3.0f, 3.0f)});
        Contact contact = make_touching(a, b, {turn.c, turn.s}, random.vector(1.0f), random.vector(1.0f),
                                        random.between(-0.01f, 0.01f));
        contact.skipped_colors = static_cast<std::uint8_t>(random.below(4));
        contact.has_extras = random.coin();
        if (contact.has_extras) {
            contact.radius_a = random.between(0.1f, 0.5f);
            contact.restitution = random.coin() ? random.between(0.0f, 1.0f) : 0.0f;
            contact.rolling_resistance = random.coin() ? 0.01f : 0.0f;
            contact.tangent_speed = random.coin() ? random.between(-1.0f, 1.0f) : 0.0f;
        }
        contacts.push_back(contact);
    }
};

// Solves the contacts of each region, the last region first. Returns the number of regions.
std::size_t solve(Clusters& clusters, std::uint32_t least_region) {
    constexpr float kH = 1.0f / 240.0f;
    ContactSolver solver;
    BodyStore& bodies = clusters.bodies;
    solver.prepare(clusters.contacts, bodies, make_tuning(1.0f, {0.0f, -10.0f}, 4.0f * kH), {0.0f, -10.0f}, kH,
                   BounceBy::solver, least_region, crew);
    const std::span<const ContactSolver::Region> regions = solver.graph().regions();
    for (std::size_t i = regions.size(); i-- > 0;) {
        for (int substep = 0; substep < 4; ++substep) {
            solver.warm_start(regions[i], bodies.solver_bodies, crew);
            solver.solve(regions[i], bodies.solver_bodies, 1.0f / kH, 3.0f, crew);
            solver.relax(regions[i], bodies.solver_bodies, 1.0f / kH, FrictionBound::biased, crew);
        }
    }
    solver.apply_restitution(bodies.solver_bodies, 0.1f, kH, crew);
    solver.store_impulses(clusters.contacts, bodies.solver_bodies, crew);
    solver.audit();
    return regions.size();
}

}  // namespace

TEST_CASE("no contact connects two regions, and no region is smaller than the rule allows") {
    RandomNumbers random(3);
    std::size_t divided = 0;
    for (int round = 0; round < 300; ++round) {
        const auto count = static_cast<std::uint32_t>(2 + random.below(60));
        const auto least = static_cast<std::uint32_t>(1 + random.below(6));
        std::vector<std::uint32_t> farthest(count, 0);
        std::vector<Edge> edges;
        const std::size_t edge_count = random.below(std::size_t{2} * count);
        for (std::size_t i = 0; i < edge_count; ++i) {
            const auto lower = static_cast<std::uint32_t>(1 + random.below(count - 1));
            const auto higher = static_cast<std::uint32_t>(std::min<std::size_t>(lower + random.below(8), count - 1));
            edges.emplace_back(lower, higher);
            farthest[lower] = std::max(farthest[lower], higher);
        }
        const std::vector<std::uint32_t> expected = expected_bounds(count, edges, least);
        std::vector<std::uint32_t> bounds;
        find_regions(farthest, least, bounds);
        CHECK(bounds == expected);
        divided += expected.size() > 2;
    }
    CAPTURE(divided);
    CHECK(divided > 90);
    CHECK(divided < 210);
}

TEST_CASE("regions solved in any order give the same bits as one region") {
    RandomNumbers random(8);
    for (int round = 0; round < 20; ++round) {
        Clusters whole(random), divided = whole;
        CHECK(solve(whole, kOneRegion) == 1);
        CHECK(solve(divided, 2) >= 4);
        for (std::size_t i = 0; i < whole.bodies.solver_bodies.size(); ++i) {
            const SolverBody &a = whole.bodies.solver_bodies[i], &b = divided.bodies.solver_bodies[i];
            CHECK(a.velocity == b.velocity);
            CHECK(a.angular_velocity == b.angular_velocity);
        }
        for (std::size_t i = 0; i < whole.contacts.size(); ++i) {
            CHECK(whole.contacts[i].applied[0].normal == divided.contacts[i].applied[0].normal);
            CHECK(whole.contacts[i].impulses[0].tangent == divided.contacts[i].impulses[0].tangent);
        }
    }
}

// The graph is kept while contacts and bodies stay the same.
TEST_CASE("a graph follows the least size of its regions") {
    RandomNumbers random(9);
    const Clusters clusters(random);
    ConstraintGraph graph;
    for (const std::uint32_t least : {kOneRegion, 1u, 8u, 1000u, 2u}) {
        ConstraintGraph fresh;
        fresh.build(clusters.contacts, clusters.bodies, crew, least);
        graph.build(clusters.contacts, clusters.bodies, crew, least);
        REQUIRE(graph.block_count() == fresh.block_count());
        CHECK(graph.regions().size() == fresh.regions().size());
        for (std::size_t i = 0; i < fresh.block_count(); ++i) CHECK(std::ranges::equal(graph.block(i), fresh.block(i)));
    }
}

// A thread solves a region from begin to end: one that is too large makes the others wait.
TEST_CASE("regions are even if none takes one and a half shares of the work") {
    BodyStore bodies;
    bodies.create({.type = BodyType::static_body});
    for (int i = 0; i < 12; ++i) bodies.create({.type = BodyType::dynamic_body});
    ConstraintGraph graph;
    graph.build({}, bodies, crew, 4);
    REQUIRE(graph.regions().size() == 3);  // of 4 bodies
    CHECK(graph.has_even_regions(4));      // a share is 3 bodies
    CHECK_FALSE(graph.has_even_regions(5));
    graph.build({}, bodies, crew);
    CHECK(graph.has_even_regions(1));
    CHECK_FALSE(graph.has_even_regions(2));
}
