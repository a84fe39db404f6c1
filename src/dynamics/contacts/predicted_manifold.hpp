// Contacts that begin within the step ahead: the shapes are apart when it starts, and touch before it ends if nothing
// stops their bodies.
//
// The solver keeps such shapes from overlapping as it does those that nearly touch: a speculative contact, here of
// swept shapes. Its normal and its points are those at the time of impact. Shapes that pass each other have no such
// time, so they get no contact.
#pragma once

#include <span>

#include "dynamics/contacts/chain_crossing.hpp"
#include "tumble/manifold.hpp"

namespace tumble {

class BodyStore;
struct Contact;
struct FreeMotion;

// The step for which contacts are collided.
struct StepAhead {
    float duration = 0.0f;                  // s
    Vec2 gravity;                           // m/s^2
    std::span<const FreeMotion> motions{};  // by solver body, of those that were awake when the step began
    bool predicts = false;                  // contacts that begin within the step get their manifold when it starts
};

// The manifold from A to B with separations and anchors of the start of the step. Without points if the shapes do not
// touch in the step, or move by less than the speculative distance: then the contact's own manifold serves. A contact
// that has one point gets the others that the motion may reach. The shapes are at their present poses. Their features
// that have no point are farther apart than the speculative distance by at least `gap` (m). It is negative for a
// contact that has moved since its last full collision.
Manifold predict_manifold(Contact& contact, const PosedShape& a, const PosedShape& b, float gap,
                          const BodyStore& bodies, const StepAhead& step);

}  // namespace tumble
