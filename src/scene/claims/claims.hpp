// The claims of a scene as measures: how far a state is from one in which the claim holds.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/expressions/program.hpp"
#include "scene/model/names.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

class Claim {
public:
    virtual ~Claim() = default;

    // To be called for the first state and after each step: collects the events of the step.
    virtual void follow(const SceneWorld&) {}

    // Whether the claim can be evaluated in the state that follow() saw last; if not, that state does not count.
    virtual bool applies() const { return true; }

    // 0 if the claim holds in this state, which is the one that follow() saw last; else how far it is from holding.
    virtual double excess(const SceneWorld& built) = 0;

    // What excess() found in the state that it evaluated last. severity() ranks states in which the claim holds: the
    // larger it is, the nearer the claim is to failing.
    virtual std::string finding(const SceneWorld& built) const = 0;
    virtual double severity() const { return 0.0; }

    // Of a claim on the state hash: the hash that excess() found.
    virtual std::string state_hash() const { return {}; }

    // What follow() collected from earlier steps, to be saved; set_state() takes it back, and answers whether it can be
    // the state of this claim.
    virtual std::vector<std::uint64_t> state() const { return {}; }
    virtual bool set_state(std::span<const std::uint64_t> state) { return state.empty(); }
};

// A claim on the world or on bodies. `built` is the world at its start.
std::unique_ptr<Claim> make_claim(const SceneExpectation& expectation, const KnownNames& names,
                                  const SceneWorld& built);

// Claims on the whole world: rest, penetration, joint error, energy, state hash. Null for other claims.
std::unique_ptr<Claim> make_claim_of_world(const SceneExpectation& expectation, const SceneWorld& built);

// Conditions and the order of two conditions. Null for other claims.
std::unique_ptr<Claim> make_claim_of_conditions(const SceneExpectation& expectation, const KnownNames& names);

// Claims on the time of a step, and those that a watch cannot decide. Null for other claims.
std::unique_ptr<Claim> make_claim_of_runs(const SceneExpectation& expectation);

// Whether a watch can decide the claim: it needs neither frames nor another scene.
bool is_decided_by_watch(const SceneExpectation& expectation);

// Claims that bodies touch or never touch. On the common name of copies, any copy may touch. Null for other claims.
std::unique_ptr<Claim> make_claim_of_touches(const SceneExpectation& expectation, const BodyNames& names);

// Counts of bodies and of events. Null for other claims.
std::unique_ptr<Claim> make_claim_of_counts(const SceneExpectation& expectation);

// All other claims, which are on bodies: position, speed, angle. A claim on the common name of copies must hold for
// every copy.
std::unique_ptr<Claim> make_claim_of_bodies(const SceneExpectation& expectation, const BodyNames& names);

// Whether the claim is on a position, an angle or a condition, which can be measured in a frame.
bool can_have_frame(const SceneExpectation& expectation);

// "'crate' is inside [0, 0] to [2, 3] at 4 s".
std::string claim_text(const SceneExpectation& expectation);

}  // namespace tumble::scene
