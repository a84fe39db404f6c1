// The impulse of one point of an impact under Coulomb friction, with all other impulses fixed (IMPACTS.md, section 3).
#pragma once

namespace tumble {

// How the relative velocity of the point answers a unit impulse, 1/kg. Positive semidefinite: coupling^2 is at most
// normal * tangent.
struct PointResponse {
    double normal = 0.0;    // along the normal, to an impulse along the normal; positive
    double tangent = 0.0;   // along the tangent, to an impulse along the tangent; positive
    double coupling = 0.0;  // along the tangent, to an impulse along the normal, and the reverse
};

// The least normal impulse x >= 0, N s, after which the point is not approached, where the tangential impulse is the
// one of Coulomb's law for x: it stops the sliding, or it has the size `friction` x and opposes the sliding.
// `normal_speed` and `tangent_speed` are those without impulses, m/s; a negative normal speed is an approach.
// If friction jams the point (no x stops the approach): the impulse that stops the approach without friction.
double find_point_impulse(const PointResponse& response, double normal_speed, double tangent_speed, double friction);

}  // namespace tumble
