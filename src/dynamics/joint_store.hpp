// All joints, one array a kind, each sorted by id. Every kind has the same skeleton: prepare, warm_start, solve, store;
// a new kind is a file, a line in KindList and a definition in joint.hpp.
#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "dynamics/distance_joint.hpp"
#include "dynamics/id_pool.hpp"
#include "dynamics/revolute_joint.hpp"
#include "tumble/joint.hpp"

namespace tumble {

// The bodies of a joint, whatever its kind.
inline BodyId joint_body_a(const JointDef& def) {
    return std::visit([](const auto& d) { return d.body_a; }, def);
}
inline BodyId joint_body_b(const JointDef& def) {
    return std::visit([](const auto& d) { return d.body_b; }, def);
}
inline bool collides_connected(const JointDef& def) {
    return std::visit([](const auto& d) { return d.collide_connected; }, def);
}

class JointStore {
public:
    JointId create(const JointDef& def);
    void destroy(JointId id);
    const JointDef& def(JointId id) const { return defs_[id.index]; }
    JointReaction reaction(JointId id) const;

    void prepare(const BodyStore& bodies);
    void warm_start(std::span<SolverBody> bodies) const;
    void solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies);
    void store(const JointContext& context);

    IdPool<JointId> ids;

private:
    template <class Joint>
    struct Entry {
        JointId id;
        Joint joint;
    };
    template <class... Joints>
    using Lists = std::tuple<std::vector<Entry<Joints>>...>;
    using KindList = Lists<RevoluteJoint, DistanceJoint>;  // in order of solving

    template <class Self, class Visitor>
    static void for_each(Self& self, Visitor&& visit) {
        std::apply([&](auto&... list) { (visit_all(list, visit), ...); }, self.lists_);
    }
    template <class List, class Visitor>
    static void visit_all(List& list, Visitor&& visit) {
        for (auto& entry : list) visit(entry.joint);
    }

    std::vector<JointDef> defs_;  // by joint index
    KindList lists_;
};

}  // namespace tumble
