// In place of the library if there is no Box2D v3. Only version() is ever called.
#include "reference/box2d_v3/library/v3_library.hpp"

namespace tumble::box2d_v3 {

const char* version() { return nullptr; }
Nearest distance(const Points&, const Points&, const Place&, bool) { return {}; }
Hit cast_shape(const Points&, const Points&, const Place&, float, float) { return {}; }
Hit cast_ray(const Points&, float, float, float, float) { return {}; }
Hit time_of_impact(const Points&, const Points&, const Motion&, const Motion&) { return {}; }
float linear_slop() { return 0.0f; }
Queries* make_distances(std::span<const PosedPair>, bool) { return nullptr; }
Queries* make_manifolds(std::span<const PosedPair>) { return nullptr; }
Queries* make_impacts(std::span<const MovingPair>) { return nullptr; }
Queries* make_rays(std::span<const Ray>) { return nullptr; }
World* make_world(float, float, bool, bool) { return nullptr; }
void destroy(World*) {}
int add_body(World*, const BodyPlan&) { return 0; }
bool add_shape(World*, int, const Points&, const Surface&) { return false; }
void set_mass(World*, int, const MassPlan&) {}
void add_joint(World*, const JointPlan&) {}
void step(World*, float, int) {}
Place pose_of(const World*, int) { return {}; }

}  // namespace tumble::box2d_v3
