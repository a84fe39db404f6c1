// Which bodies take part in an impact, and at which points.
#pragma once

#include "dynamics/state/simulation.hpp"

namespace tumble {

// Builds the impact group of scratch.ordered_impacts: its bodies, which advance to the time of the impact, and the
// points where they touch. Each pair of shapes that collides here becomes one of `impacts`.
class ImpactMembers {
public:
    ImpactMembers(Simulation& simulation, const NextImpact& impact);

    // Begins with the two shapes of the impact, at the points where they are nearest.
    void begin();

    // Begins with the point that the search has found: a manifold of shapes that overlap deeply may have another
    // normal.
    void begin_at_found_point();

    // Adds the contacts that the bodies now press together by more than `least` (m/s), and those with static and
    // kinematic bodies that are approached at all, at the impact or ahead. False if there are none.
    bool grow(double least);

    // Makes the impacts of the group the last ones of their bodies in the step.
    void link_impacts();

private:
    struct Arm {
        DVec2 now, shift;  // from the centre of mass; of its end since the step began, m
    };
    // Which points count: the nearest ones, or if the shapes bounce only those where they touch.
    enum class Reach { nearest, bouncing_touch };

    void clear();
    std::size_t member(std::uint32_t body);
    ImpactBody make_body(SweptBody& swept);
    Pose pose(std::uint32_t body, std::size_t index) const;
    DVec2 center_now(std::size_t index, std::uint32_t body) const;
    Twist velocity_now(std::uint32_t body) const;
    Arm arm(std::uint32_t body, std::size_t index, Vec2 anchor, Vec2 from_core) const;

    Impact& begin_impact(ProxyPair shapes);
    int last_impact() const { return static_cast<int>(scratch_.impacts.size()) - 1; }
    void record_approach(Impact& impact, std::size_t first_point) const;
    void add_manifold(ProxyPair shapes, Reach reach);
    void add_point(const Contact& contact, std::size_t a, std::size_t b, DVec2 normal, DVec2 arm_a, DVec2 arm_b,
                   double separation);
    void forget_points(std::size_t from);

    bool may_add(ProxyPair shapes) const;
    void add_contact(const Contact& contact, double least);
    void add_earlier(std::uint32_t body, int last_impact, double least);
    void add_if_approached(ProxyPair shapes, double least);
    void add_from_start(const Contact& contact, double least);
    bool add_point_from_start(const Contact& contact, const ManifoldPoint& point, std::size_t a, std::size_t b);

    std::uint32_t body_of(std::uint32_t shape) const { return simulation_.shapes[shape].body; }
    bool is_with_immovable(std::uint32_t a, std::uint32_t b) const;
    bool is_approached(const ImpactPoint& point, double least, bool is_bound) const;
    bool may_be_approached(const Contact& contact, double threshold) const;
    bool is_out_of_date(const Contact& contact, const Sweep& a, const Sweep& b) const;
    bool may_touch_now(const Contact& contact, const Sweep& a, const Sweep& b) const;
    double largest_gap(const Contact& contact, const ImpactPoint& point) const;

    Simulation& simulation_;
    ImpactScratch& scratch_;
    ImpactGroup& group_;
    const NextImpact& impact_;
    std::size_t first_;  // of this group among all impacts of the step
    double duration_;    // of the step, s
};

}  // namespace tumble
