// The lists of contacts: those of a round of waking, and all.
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/shape_store.hpp"
#include "dynamics/contacts/contact_store.hpp"

using namespace tumble;

namespace {

// Three dynamic bodies with a ball each.
struct Balls {
    Balls() {
        for (int i = 0; i < 3; ++i) {
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
