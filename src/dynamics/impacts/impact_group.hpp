// Impacts that happen at one time, solved together: which velocities the bodies leave with.
//
// A contact that bounces and is approached faster than its threshold reflects; any other contact only keeps its bodies
// apart. The solver works in rounds [Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012, "Reflections on simultaneous
// impact"]: a round finds the least impulses after which no contact is approached, and applies those of bouncing
// contacts 1 + e times. Then other contacts may be approached, and the next round follows. Contacts that bounce but are
// not approached do not take part in a round: a row of balls hands an impact on from ball to ball. With e = 1 and
// without friction the energy is kept.
//
// The motion ahead may still approach: gravity pulls a body that has landed, or the solver pushes another one out of an
// overlap. What keeps such bodies apart for the rest of the step is the `hold`, which is no impulse.
//
// The rounds end when no contact is approached faster than its threshold; the contact solver of the next step stops
// what is slower. A contact bounces in at most kMaxBounces rounds: points of a pile that hand an impact to and fro
// would need hundreds.
//
// No round gains energy: where friction or different restitutions would, the bounce is weaker. Kinematic bodies and
// moving surfaces do work of their own, which does not count. A round in which friction keeps the impulses from
// settling is solved without friction. A body that is crushed between bodies which no impulse moves has no solution:
// the rounds end, and the approach stays. The number of solved points is bounded for the rounds and for the holds
// (kMaxImpactWork each): a group that has approaching contacts when the rounds end keeps these approaches.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/impacts/swept_body.hpp"

namespace tumble {

// How often a group solves one of its points in all rounds together, and again for all holds: some 1.2 ms each. A stack
// of twenty boxes needs 20 000 while the group grows through it.
inline constexpr int kMaxImpactWork = 32000;

// The rounds in which a point may bounce. More: impacts in piles cost more. Fewer: elastic bodies that touch several
// others lose energy.
inline constexpr int kMaxBounces = 4;

struct ImpactBody {
    DVec2 inv_mass;  // 1/kg, along each world axis; 0 for a body that no impulse moves
    double inv_inertia = 0.0;
    Twist velocity;        // at the impact
    Twist mean_velocity;   // of the motion ahead
    DVec2 acceleration;    // of its free motion, m/s^2
    double reach = 0.0;    // of its farthest point from the centre of mass, m
    Twist change;          // of both velocities, by the impulses so far
    Twist earlier_change;  // of both velocities, by the rounds before this one
    Twist hold;            // of the mean velocity alone
};

// One point of a contact.
struct ImpactPoint {
    std::size_t a = 0, b = 0;  // bodies of the group
    DVec2 normal;              // unit, from A to B
    DVec2 arm_a, arm_b;        // from the centres of mass to the point, m
    double friction = 0.0;
    double restitution = 0.0;
    double separation = 0.0;       // m, negative if the shapes overlap
    double least_response = 0.0;   // a direction in which locks leave the bodies less than this is not solved, 1/kg
    double threshold = 0.0;        // approach speed from which it bounces, m/s
    double tangent_speed = 0.0;    // of B's surface against A's beside that of the bodies, m/s
    int bounce_count = 0;          // rounds in which it bounced
    double normal_impulse = 0.0;   // on B, of all rounds, N s
    double tangent_impulse = 0.0;  // along -perp(normal)
};

// A direction in which a point pushes, along its normal or its tangent, with what a pass needs of its bodies.
struct ImpactDirection {
    DVec2 axis;
    double across_a = 0.0, across_b = 0.0;  // arm x axis, m
    Twist push_a, push_b;                   // what a unit impulse adds to the velocities
    double mass = 0.0;                      // kg; 0 if it is not solved
    double speed = 0.0;                     // of B's point against A's, without the changes, m/s
    double speed_at_start = 0.0;            // with the changes of the rounds before, m/s
    double impulse = 0.0;                   // of this round, N s
};

// A point during one round.
struct ImpactRow {
    std::size_t point = 0, a = 0, b = 0;  // indices of the point and of its bodies
    ImpactDirection normal, tangent;
    double friction = 0.0;
    double restitution = 0.0;  // 0 if it does not bounce in this round
    bool is_paired = false;    // the next row is the other point of the same contact: both normals are solved at once
    // The speed that a unit impulse along the normal adds along the tangent, and, of a paired row, along the other
    // normal, 1/kg.
    double tangent_coupling = 0.0, coupling = 0.0;
};

struct ImpactGroup {
    std::vector<ImpactBody> bodies;
    std::vector<ImpactPoint> points;
    std::vector<ImpactRow> rows;  // scratch of a round
    int work = 0;                 // how often a point was solved in the rounds
    int hold_work = 0;            // and for the holds
    int depth = 1;                // contacts in the longest row from the impact: 1, and 1 more for each growth

    void clear() {
        work = 0;
        hold_work = 0;
        depth = 1;
        bodies.clear();
        points.clear();
    }
    std::size_t bytes() const {
        return bodies.capacity() * sizeof(ImpactBody) + points.capacity() * sizeof(ImpactPoint) +
               rows.capacity() * sizeof(ImpactRow);
    }
};

// Adds the impulses of all points to the changes of the bodies, and then sets their holds.
void solve_impacts(ImpactGroup& group);

}  // namespace tumble
