#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "scene/claims/claims.hpp"
#include "scene/model/display.hpp"
#include "scene/model/joint_gap.hpp"
#include "scene/model/names.hpp"
#include "tumble/world_def.hpp"

namespace tumble::scene {

namespace {

class AtRest final : public Claim {
public:
    double excess(const SceneWorld& built) override {
        fastest_ = 0.0;
        for (std::size_t i = 0; i < built.bodies.size(); ++i) {
            const BodyId id = built.bodies[i].id;
            if (i == reach_.size()) reach_.push_back(reach_of(built.world, id));
            if (!built.world.is_valid(id) || built.world.type(id) != BodyType::dynamic_body ||
                !built.world.is_awake(id))
                continue;
            const BodyState state = built.world.state(id);
            const double speed = length(state.velocity) + std::abs(double{state.angular_velocity}) * reach_[i];
            if (speed <= fastest_) continue;
            fastest_ = speed;
            body_ = i;
        }
        return fastest_ < double{world_limits(built.world.def()).rest_speed} ? 0.0 : fastest_;
    }
    double severity() const override { return fastest_; }
    std::string finding(const SceneWorld& built) const override {
        return fastest_ > 0.0 ? display_name(built, body_) + " moves at " + brief(fastest_) + " m/s" : "nothing moves";
    }

private:
    static double reach_of(const World& world, BodyId body) {
        float reach = 0.0f;
        if (!world.is_valid(body)) return 0.0;
        for (const ShapeId shape : world.shapes(body))
            reach = std::max(reach, farthest_distance(world.shape(shape), world.mass(body).center));
        return double{reach};
    }

    std::vector<double> reach_;  // [built bodies] m: of the farthest point from the centre of mass
    double fastest_ = 0.0;       // m/s
    std::size_t body_ = 0;
};

class Penetration final : public Claim {
public:
    explicit Penetration(double limit) : limit_(limit) {}

    double excess(const SceneWorld& built) override {
        deepest_ = {};
        for (const ContactPoint& contact : built.world.contacts())
            if (contact.separation < deepest_.separation) deepest_ = contact;
        return std::max(0.0, severity() - limit_);
    }
    double severity() const override { return -double{deepest_.separation}; }
    std::string finding(const SceneWorld& built) const override {
        if (!(deepest_.separation < 0.0f)) return "nothing overlaps";
        return display_name(built, deepest_.body_a) + " and " + display_name(built, deepest_.body_b) + " overlap by " +
               brief(severity()) + " m at " + brief(deepest_.point);
    }

private:
    double limit_;
    ContactPoint deepest_;
};

class JointError final : public Claim {
public:
    JointError(double limit, const std::string& name, const SceneWorld& built) : limit_(limit) {
        for (std::size_t i = 0; i < built.joints.size(); ++i) {
            const SceneJointInstance& joint = built.joints[i];
            if (!name.empty() && joint.name != name && base_name(joint.name) != name) continue;
            joints_.push_back({joint.id, display_joint_name(built, i)});
        }
    }

    double excess(const SceneWorld& built) override {
        widest_ = 0.0;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (!built.world.is_valid(joints_[i].id)) continue;
            const double gap = joint_gap(built.world, joints_[i].id);
            if (gap <= widest_) continue;
            widest_ = gap;
            joint_ = i;
        }
        return std::max(0.0, widest_ - limit_);
    }
    double severity() const override { return widest_; }
    std::string finding(const SceneWorld&) const override {
        if (joints_.empty()) return "no such joint exists";
        return "the anchors of " + joints_[joint_].display_name + " are " + brief(widest_) + " m apart";
    }

private:
    double limit_;
    struct Named {
        JointId id;
        std::string display_name;
    };

    std::vector<Named> joints_;
    double widest_ = 0.0;
    std::size_t joint_ = 0;
};

class EnergyGain final : public Claim {
public:
    explicit EnergyGain(double limit) : limit_(limit) {}

    // The first state that counts is the start.
    double excess(const SceneWorld& built) override {
        const double energy = built.world.energy().total() - built.work;
        if (!first_) {
            first_ = energy;
            work_ = built.work;
        }
        gain_ = energy - *first_;
        has_work_ = built.work != work_;
        return std::max(0.0, gain_ - limit_);
    }
    double severity() const override { return gain_; }
    std::vector<std::uint64_t> state() const override {
        if (!first_) return {};
        return {std::bit_cast<std::uint64_t>(*first_), std::bit_cast<std::uint64_t>(work_)};
    }
    bool set_state(std::span<const std::uint64_t> state) override {
        first_.reset();
        if (state.empty()) return true;
        if (state.size() != 2) return false;
        first_ = std::bit_cast<double>(state[0]);
        work_ = std::bit_cast<double>(state[1]);
        return true;
    }
    std::string finding(const SceneWorld&) const override {
        if (!(gain_ > 0.0)) return "the energy never grew";
        return "the energy is " + brief(gain_) + " J above that of the start" +
               (has_work_ ? " and the work of events and motors" : "");
    }

private:
    double limit_;
    std::optional<double> first_;  // J, without SceneWorld::work
    double work_ = 0.0;            // J, up to the first state that counts
    double gain_ = 0.0;
    bool has_work_ = false;
};

class StateHash final : public Claim {
public:
    explicit StateHash(std::string wanted) : wanted_(std::move(wanted)) {}

    double excess(const SceneWorld& built) override {
        hash_ = built.world.state_hash();
        return state_hash() == wanted_ ? 0.0 : 1.0;
    }
    std::string finding(const SceneWorld&) const override { return "it is " + state_hash(); }
    std::string state_hash() const override {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
        return digits;
    }

private:
    std::string wanted_;
    std::uint64_t hash_ = 0;
};

}  // namespace

std::unique_ptr<Claim> make_claim_of_world(const SceneExpectation& claim, const SceneWorld& built) {
    if (claim.at_rest_by) return std::make_unique<AtRest>();
    if (claim.max_penetration) return std::make_unique<Penetration>(*claim.max_penetration);
    if (claim.max_joint_error) return std::make_unique<JointError>(*claim.max_joint_error, claim.joint, built);
    if (claim.max_energy_gain) return std::make_unique<EnergyGain>(*claim.max_energy_gain);
    if (!claim.state_hash.empty()) return std::make_unique<StateHash>(claim.state_hash);
    return nullptr;
}

}  // namespace tumble::scene
