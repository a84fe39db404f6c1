// Hinges that are solved several at a time, in worlds whose hinges and bodies change between steps.
#include <doctest/doctest.h>

#include <optional>
#include <random>
#include <vector>

#include "support/thread_tasks.hpp"
#include "support/worlds.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr DVec2 kLink{0.6, 0.0};

JointId add_hinge(World& world, BodyId left, BodyId right) {
    return world.create_joint(
        RevoluteJointDef{.body_a = left, .body_b = right, .anchor_a = {0.3f, 0.0f}, .anchor_b = {-0.3f, 0.0f}});
}

// Chains of hinges of a world that is edited before each step.
class EditedChains {
public:
    explicit EditedChains(std::uint32_t seed) : random_(seed) {
        for (int chain = 0; chain < 6; ++chain)
            for (int link = 0; link < 6; ++link) {
                bodies_.push_back(add_dynamic(world, DVec2{0.0, -3.0 * chain} + double{1.0 * link} * kLink,
                                              make_capsule({-0.2f, 0.0f}, {0.2f, 0.0f}, 0.05f)));
                if (link > 0) hinges_.push_back(add_hinge(world, bodies_[bodies_.size() - 2], bodies_.back()));
            }
    }

    // Changes a part of the same hinge of each chain, so that these stay alike, or one body or hinge.
    void edit() {
        const BodyId body = bodies_[random_() % bodies_.size()];
        const std::size_t link = random_() % 5;
        JointId& hinge = hinges_[random_() % hinges_.size()];
        const bool turns_on = random_() % 2 == 0;
        const auto change = [&](auto&& change_def) {
            for (std::size_t i = link; i < hinges_.size(); i += 5) {
                if (!world.is_valid(hinges_[i])) continue;
                auto def = std::get<RevoluteJointDef>(world.joint(hinges_[i]));
                change_def(def);
                world.set_joint(hinges_[i], def);
            }
        };
        const auto join_again = [&] {
            const std::size_t i = static_cast<std::size_t>(&hinge - hinges_.data()), first = i / 5 * 6 + i % 5;
            hinge = add_hinge(world, bodies_[first], bodies_[first + 1]);
        };
        switch (random_() % 12) {
            case 0:
            case 9: change([&](auto& def) { def.limits = only_if(turns_on, JointLimits{-0.1f, 0.2f}); }); break;
            case 1:
            case 10: change([&](auto& def) { def.motor = only_if(turns_on, AngularMotor{2.0f, 0.5f}); }); break;
            case 2:
            case 11: change([&](auto& def) { def.spring = only_if(turns_on, JointSpring{4.0f, 0.5f}); }); break;
            case 3: world.is_valid(hinge) ? world.destroy_joint(hinge) : join_again(); break;
            case 4: world.set_type(body, turns_on ? BodyType::static_body : BodyType::dynamic_body); break;
            case 5: world.set_enabled(body, turns_on); break;
            case 6: world.set_mass(body, turns_on ? std::optional(BodyMass{2.0f, {}, 0.1f}) : std::nullopt); break;
            case 7: world.set_awake(body, turns_on); break;
            default: world.set_locks(body, {.x = turns_on}); break;
        }
    }

    World world;

private:
    template <class Part>
    static std::optional<Part> only_if(bool exists, const Part& part) {
        return exists ? std::optional<Part>(part) : std::nullopt;
    }

    std::mt19937 random_;
    std::vector<BodyId> bodies_;
    std::vector<JointId> hinges_;
};

}  // namespace

// A world that is loaded finds anew which hinges are solved together.
TEST_CASE("after each change of hinges and bodies, a step is that of a world that is loaded from a snapshot") {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        EditedChains chains(seed);
        for (int step = 0; step < 60; ++step) {
            CAPTURE(step);
            chains.edit();
            World loaded = World::load(chains.world.save());
            chains.world.step();
            loaded.step();
            REQUIRE(chains.world.save() == loaded.save());
        }
        chains.world.audit();
    }
}

// Static bodies are one solver body: threads must not write it at the same time.
TEST_CASE("hinges of many static bodies make the same steps on any number of threads") {
    const auto make = [] {
        World world;
        for (int i = 0; i < 700; ++i) {
            const DVec2 place{2.0 * i, 0.0};
            const BodyId anchor = add_static(world, place, make_circle(0.1f));
            BodyId last = anchor;
            for (int link = 1; link <= 2; ++link) {
                const BodyId next = add_dynamic(world, place + double{1.0 * link} * kLink, make_circle(0.1f));
                add_hinge(world, last, next);
                last = next;
            }
        }
        return world;
    };
    World serial = make(), parallel = make();
    parallel.set_threads(eager_threads(3));
    for (int step = 0; step < 20; ++step) {
        serial.step();
        parallel.step();
        REQUIRE(parallel.state_hash() == serial.state_hash());
    }
    CHECK(parallel.save() == serial.save());
}
