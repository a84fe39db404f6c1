// The lists of contacts: those of a round of waking, and all.
#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/contact_store.hpp"

using namespace tumble;

namespace {

// Dynamic bodies with a ball each.
struct Balls {
    explicit Balls(int count = 3) {
        for (int i = 0; i < count; ++i) {
            BodyDef def;
            def.pose.position = {1.0 * i, 0.0};
            const BodyId body = bodies.create(def);
            bodies.set_mass(body, BodyMass{1.0f, {}, 1.0f}, 1.0f, 1.0f);
            shapes.create(body.index, {.shape = make_circle(0.5f)});
        }
    }

    BodyStore bodies;
    ShapeStore shapes;
    ContactStore contacts;
};

const std::vector<ProxyPair> kPairs{{0, 1}, {0, 2}, {1, 2}};

}  // namespace

TEST_CASE("contacts that begin in a round of waking draw the same colours as others") {
    Balls at_once, in_round;
    at_once.contacts.add(kPairs, at_once.bodies, at_once.shapes, {});
    in_round.contacts.add_to_woken(kPairs, in_round.bodies, in_round.shapes, {});
    CHECK(in_round.contacts.all().empty());
    in_round.contacts.merge_woken();
    CHECK(in_round.contacts.woken().empty());
    REQUIRE(in_round.contacts.all().size() == kPairs.size());
    for (std::size_t i = 0; i < kPairs.size(); ++i) {
        CHECK(in_round.contacts.all()[i].shapes == kPairs[i]);
        CHECK(in_round.contacts.all()[i].skipped_colors == at_once.contacts.all()[i].skipped_colors);
    }
}

TEST_CASE("each round of woken contacts is sorted, and a pair is found in any of them") {
    Balls balls;
    balls.contacts.add_to_woken({{0, 2}}, balls.bodies, balls.shapes, {});
    balls.contacts.sort_woken(0);
    balls.contacts.add_to_woken({{0, 1}, {1, 2}}, balls.bodies, balls.shapes, {});
    balls.contacts.sort_woken(1);
    const std::vector<Contact>& woken = balls.contacts.woken();
    REQUIRE(woken.size() == 3);
    CHECK(woken[0].shapes == ProxyPair{0, 2});
    CHECK(woken[1].shapes == ProxyPair{0, 1});
    CHECK(woken[2].shapes == ProxyPair{1, 2});
    const std::vector<std::uint32_t> rounds{0, 1};
    for (const Contact& contact : woken) CHECK(balls.contacts.find_in_woken(contact.shapes, rounds) == &contact);
    CHECK(balls.contacts.find_in_woken({2, 3}, rounds) == nullptr);
    CHECK(balls.contacts.find_in_woken({0, 1}, {}) == nullptr);
    CHECK(balls.contacts.find({0, 1}) == nullptr);
    balls.contacts.keep_woken_if(1, [](const Contact& contact) { return contact.shapes.b == 2; });
    REQUIRE(woken.size() == 2);
    CHECK(woken[1].shapes == ProxyPair{1, 2});
}

TEST_CASE("contacts that end and begin at the same time leave the others in order, as one after the other") {
    // Pairs of 12 balls in random order: each round ends some of those that exist and begins some of the others.
    Balls balls(12), reference(12);
    std::vector<ProxyPair> all;
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b) all.push_back({a, b});
    std::mt19937 random(5);
    Crew crew;
    for (int round = 0; round < 300; ++round) {
        const unsigned part = 1u + random() % 8u;  // one of so many changes
        ChunkLists<std::uint32_t> ended;
        const std::vector<Contact>& before = balls.contacts.all();
        ended.fill(crew, before.size(), 1, [&](std::size_t i, std::vector<std::uint32_t>& list) {
            if (random() % part == 0) list.push_back(static_cast<std::uint32_t>(i));
        });
        std::vector<ProxyPair> begun;
        for (const ProxyPair pair : all)
            if (!balls.contacts.find(pair) && random() % part == 0) begun.push_back(pair);
        balls.contacts.replace(ended, begun, balls.bodies, balls.shapes, {});
        reference.contacts.remove(ended);
        reference.contacts.add(begun, reference.bodies, reference.shapes, {});
        const std::vector<Contact>& after = balls.contacts.all();
        REQUIRE(after.size() == reference.contacts.all().size());
        for (std::size_t i = 0; i < after.size(); ++i) {
            REQUIRE((i == 0 || after[i - 1].shapes < after[i].shapes));
            REQUIRE(after[i].shapes == reference.contacts.all()[i].shapes);
            REQUIRE(after[i].body_b == after[i].shapes.b);
            REQUIRE(after[i].skipped_colors == reference.contacts.all()[i].skipped_colors);
        }
    }
}
