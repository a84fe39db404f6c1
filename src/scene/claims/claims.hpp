// The claims of a scene as measures: how far a state is from what is claimed of it.
#pragma once

#include <memory>
#include <string>

#include "scene/model/names.hpp"
#include "tumble/scene.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::scene {

class Claim {
public:
    virtual ~Claim() = default;

    // To be called for the first state and after each step: for claims about what happened since.
    virtual void follow(const SceneWorld&) {}

    // Whether there is anything to look at in this state, which was followed; else it does not count.
    virtual bool applies() const { return true; }

    // 0 where the claim holds in this state, which was followed, else how far it is from holding.
    virtual double excess(const SceneWorld& built) = 0;

    // What was seen in the state that excess() looked at last; `margin` is how near to failing it was, for claims that
    // hold with room: larger is nearer.
    virtual std::string finding(const SceneWorld& built) const = 0;
    virtual double margin() const { return 0.0; }
};

// One of the two below. `built` is the world at its start.
std::unique_ptr<Claim> make_claim(const SceneExpectation& expectation, const BodyNames& names, const SceneWorld& built);

// Of the whole world: rest, depth, joints, energy, hash. Null for other claims.
std::unique_ptr<Claim> make_claim_of_world(const SceneExpectation& expectation, const SceneWorld& built);

// Of bodies: where they are, how fast, what they touch, how many, what happens to them.
std::unique_ptr<Claim> make_claim_of_bodies(const SceneExpectation& expectation, const BodyNames& names);

// Whether it speaks of a place or an angle, which a frame can measure.
bool has_place(const SceneExpectation& expectation);

// "'crate' is inside [0, 0] to [2, 3] at 4 s".
std::string claim_text(const SceneExpectation& expectation);

}  // namespace tumble::scene
