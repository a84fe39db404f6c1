#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "scene/json/problem_codes.hpp"
#include "scene/lint/lint.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"
#include "tumble/world_def.hpp"

namespace tumble::scene {

namespace {

constexpr double kLeastRise = 0.5;   // cosine of normal and up: contacts with a smaller one carry no weight
constexpr double kElastic = 0.5;     // a restitution from which a hit is expected to pass on
constexpr double kTouching = 0.005;  // m, in a world of scale 1: bodies this close are hit in the same step

// The contact points of two bodies, combined.
struct Touch {
    std::size_t a = 0, b = 0;  // built bodies
    double separation = 0.0;   // the least, m
    DVec2 normal;              // of that point, from A to B
    double stiffness = 0.0;    // of all points along their normals, N/m
};

class ContactLinter {
public:
    ContactLinter(const Scene& scene, const SceneWorld& started, Diagnostics& diagnostics)
        : scene_(scene),
          built_(started),
          diagnostics_(diagnostics),
          limits_(world_limits(started.world.def())),
          up_(-1.0 * scene.world.gravity) {
        for (std::size_t i = 0; i < built_.bodies.size(); ++i) {
            index_[built_.bodies[i].id.index] = i;
            extents_.push_back(smallest_extent(built_.world, id(i)));
        }
        std::map<std::pair<std::size_t, std::size_t>, Touch> touches;
        for (const ContactPoint& contact : built_.world.contacts()) {
            const std::size_t a = index_.at(contact.body_a.index), b = index_.at(contact.body_b.index);
            Touch& touch = touches.try_emplace({a, b}, Touch{a, b, HUGE_VAL, {}, 0.0}).first->second;
            // The contact is a spring on the effective mass of the point, of this frequency in rad/s.
            const double stiffening = is_dynamic(a) && is_dynamic(b) ? 1.0 : double{limits_.static_stiffening};
            const double frequency = 2.0 * kPi * stiffening * double{limits_.contact_hertz};
            touch.stiffness += frequency * frequency / (mobility(a, contact) + mobility(b, contact));
            if (double{contact.separation} >= touch.separation) continue;
            touch.separation = double{contact.separation};
            touch.normal = DVec2(contact.normal);
        }
        for (const auto& [pair, touch] : touches) touches_.push_back(touch);
    }

    void lint_overlaps() {
        std::set<std::pair<std::size_t, std::size_t>> reported;
        for (const Touch& touch : touches_) {
            const double allowed =
                allowed_overlap(std::min(extent_of(touch.a), extent_of(touch.b)), scene_.world.scale);
            if (touch.separation >= -allowed || !reported.insert({source(touch.a), source(touch.b)}).second) continue;
            warn(codes::overlap, touch.b,
                 name(touch.b) + " starts " + brief(-touch.separation) + " m inside " + name(touch.a) +
                     ": they will be pushed apart at up to " + brief(double{limits_.push_out_speed}) + " m/s",
                 "move one of them, or let a \"filter\" exclude their contact");
        }
    }

    void lint_masses() {
        std::set<std::pair<std::size_t, std::size_t>> reported;
        for (const Touch& touch : touches_) {
            if (!is_dynamic(touch.a) || !is_dynamic(touch.b)) continue;
            const double ratio = mass_ratio(built_.world, id(touch.a), id(touch.b));
            if (ratio <= kLargeMassRatio || !reported.insert({source(touch.a), source(touch.b)}).second) continue;
            warn(codes::contact_mass_ratio, touch.b,
                 name(touch.a) + " of " + brief(mass(touch.a)) + " kg touches " + name(touch.b) + " of " +
                     brief(mass(touch.b)) +
                     " kg: a body in contact with one that is over 100 times heavier is squeezed",
                 "bring their densities closer together, or give the world more substeps");
        }
    }

    void lint_sleepers() {
        std::set<std::size_t> supported;  // by a contact or a joint
        for (const Touch& touch : touches_) supported.insert({touch.a, touch.b});
        for (const JointId joint : built_.world.joints())
            std::visit(
                [&](const auto& def) {
                    supported.insert({index_.at(def.body_a.index), index_.at(def.body_b.index)});
                },
                built_.world.joint(joint));
        std::set<std::size_t> reported;
        for (std::size_t i = 0; i < built_.bodies.size(); ++i) {
            const SceneBody& body = scene_.bodies[source(i)];
            const bool falls = length(up_) > 0.0 && body.gravity_scale != 0.0;
            if (body.awake || !is_dynamic(i) || !falls || supported.contains(i) || !reported.insert(source(i)).second)
                continue;
            warn(codes::asleep_in_the_air, i,
                 name(i) + " starts asleep without support: it falls only after something touches it",
                 R"(remove "awake": false, or place it on its support)");
        }
    }

    // Dynamic bodies that touch two others: the first that is hit shares the hit with them.
    void lint_rows() {
        if (scene_.world.impacts == ImpactModel::in_order) return;
        std::vector<int> neighbours(built_.bodies.size());
        for (const Touch& touch : touches_) {
            if (!is_dynamic(touch.a) || !is_dynamic(touch.b) || !is_elastic(touch)) continue;
            for (const std::size_t i : {touch.a, touch.b})
                if (++neighbours[i] == 2)
                    return warn(codes::spread_impact, i,
                                name(i) +
                                    " touches two elastic bodies: a hit on one of them spreads over all three, "
                                    "because impacts happen at the step's end",
                                R"(set "impacts": "in_order" for the world, or leave gaps between the bodies)");
        }
    }

    // Warns of the pile that sinks most, and lists the other piles whose worst body is of another kind.
    void lint_stacks() {
        if (!(length(up_) > 0.0)) return;
        const Sinking sinking = find_sinking();
        const std::vector<int> pile = built_.world.islands();
        std::map<int, std::size_t> worst;  // of each pile
        for (std::size_t i = 0; i < built_.bodies.size(); ++i) {
            if (!is_dynamic(i) || !(sinking.sunk[i] > kVisibleSag * extent_of(i))) continue;
            const auto [found, is_new] = worst.try_emplace(pile[i], i);
            if (!is_new && sinking.sunk[i] > sinking.sunk[found->second]) found->second = i;
        }
        std::vector<std::size_t> tops;
        for (const auto& [number, i] : worst) tops.push_back(i);
        std::ranges::stable_sort(tops, std::ranges::greater{}, [&](std::size_t i) { return sinking.sunk[i]; });
        if (!tops.empty()) warn_of_sinking(tops, sinking);
    }

private:
    struct Support {
        std::size_t body = 0;
        double stiffness = 0.0;  // N/m
    };

    // [built bodies]
    struct Sinking {
        std::vector<double> sunk;          // m
        std::vector<std::size_t> softest;  // the body below that adds most to it
    };

    // Loads add up from the top body downwards, displacements from the ground upwards.
    Sinking find_sinking() const {
        std::vector<std::vector<Support>> below(built_.bodies.size());
        for (const Touch& touch : touches_) {
            const double rise = dot(touch.normal, up_) / length(up_);
            if (rise > kLeastRise) below[touch.b].push_back({touch.a, touch.stiffness});
            if (rise < -kLeastRise) below[touch.a].push_back({touch.b, touch.stiffness});
        }
        std::vector<std::size_t> upwards(built_.bodies.size());
        std::iota(upwards.begin(), upwards.end(), std::size_t{0});
        std::ranges::stable_sort(upwards, {}, [this](std::size_t i) { return height(i); });
        std::vector<double> load(built_.bodies.size());  // N
        Sinking result{std::vector<double>(load.size()), std::vector<std::size_t>(load.size())};
        for (std::size_t k = upwards.size(); k-- > 0;) {
            const std::size_t i = upwards[k];
            if (!is_dynamic(i)) continue;
            load[i] += mass(i) * length(up_);
            for (const Support& under : below[i]) load[under.body] += load[i] / static_cast<double>(below[i].size());
        }
        for (const std::size_t i : upwards) {
            if (!is_dynamic(i)) continue;
            const double share = load[i] / static_cast<double>(below[i].size());
            for (const Support& under : below[i]) {
                const double with_it = result.sunk[under.body] + share / under.stiffness;
                if (with_it > result.sunk[i]) result.softest[i] = under.body;
                result.sunk[i] = std::max(result.sunk[i], with_it);
            }
        }
        return result;
    }

    // `tops` has the worst body of each pile, the worst of all first.
    void warn_of_sinking(const std::vector<std::size_t>& tops, const Sinking& sinking) {
        const auto depth = [&](std::size_t i) {
            return sinking.sunk[i] > extent_of(i) ? "more than the size of the body"
                                                  : "about " + brief(sinking.sunk[i]) + " m";
        };
        const std::size_t worst = tops.front();
        std::string text = "the support of " + name(worst) + " (" + name(sinking.softest[worst]) + ") will sink by " +
                           depth(worst) + " under the weight on it";
        std::set<std::size_t> reported{source(worst)};
        for (const std::size_t i : tops)
            if (reported.insert(source(i)).second) text += ", that of " + name(i) + " by " + depth(i);
        warn(codes::sinking_stack, worst, text,
             "each contact yields a little: stack fewer or lighter bodies, or lower the gravity");
    }

    void warn(std::string_view code, std::size_t body, const std::string& message, const std::string& hint) {
        diagnostics_.warning(code, "/bodies/" + std::to_string(source(body)), message, hint);
    }

    // Whether the bodies touch and the larger restitution of their shapes, which a contact has, is that of an elastic
    // impact.
    bool is_elastic(const Touch& touch) const {
        double largest = 0.0;
        for (const std::size_t i : {touch.a, touch.b})
            for (const ShapeId shape : built_.world.shapes(id(i)))
                largest = std::max(largest, double{built_.world.material(shape).restitution});
        return largest >= kElastic && touch.separation <= scene_.world.scale * kTouching;
    }

    BodyId id(std::size_t body) const { return built_.bodies[body].id; }
    std::size_t source(std::size_t body) const { return built_.bodies[body].source; }
    std::string name(std::size_t body) const { return display_name(built_, body); }
    bool is_dynamic(std::size_t body) const { return built_.world.type(id(body)) == BodyType::dynamic_body; }
    double mass(std::size_t body) const { return double{built_.world.mass(id(body)).mass}; }
    double height(std::size_t body) const { return dot(built_.world.state(id(body)).pose.position, up_); }

    // The change of the normal velocity of the body at a contact point by a unit impulse there (1/kg).
    double mobility(std::size_t body, const ContactPoint& contact) const {
        if (!is_dynamic(body)) return 0.0;
        const BodyMass own = built_.world.mass(id(body));
        const DVec2 lever = contact.point - transform_point(built_.world.state(id(body)).pose, own.center);
        const double turn = cross(lever, DVec2(contact.normal));
        return 1.0 / double{own.mass} + (own.inertia > 0.0f ? turn * turn / double{own.inertia} : 0.0);
    }

    double extent_of(std::size_t body) const { return extents_[body]; }

    const Scene& scene_;
    const SceneWorld& built_;
    Diagnostics& diagnostics_;
    WorldLimits limits_;
    DVec2 up_;                                    // the negative gravity (m/s^2)
    std::map<std::uint32_t, std::size_t> index_;  // of BodyId::index
    std::vector<double> extents_;                 // [built bodies] m: the smallest
    std::vector<Touch> touches_;                  // in the order of the bodies
};

}  // namespace

void add_contact_lints(const Scene& scene, const SceneWorld& started, Diagnostics& diagnostics) {
    ContactLinter linter(scene, started, diagnostics);
    linter.lint_overlaps();
    linter.lint_masses();
    linter.lint_sleepers();
    linter.lint_stacks();
    linter.lint_rows();
}

}  // namespace tumble::scene
