#include "dynamics/joint_store.hpp"

#include <algorithm>

namespace tumble {

namespace {

RevoluteJoint make_joint(const RevoluteJointDef& def) {
    return RevoluteJoint(def);
}
DistanceJoint make_joint(const DistanceJointDef& def) {
    return DistanceJoint(def);
}

// Where a joint of this id is in its list, or belongs.
template <class List>
auto position(List& list, JointId id) {
    return std::lower_bound(list.begin(), list.end(), id,
                            [](const auto& entry, JointId key) { return entry.id < key; });
}

}  // namespace

JointId JointStore::create(const JointDef& def) {
    const JointId id = ids.acquire();
    if (id.index == defs_.size()) defs_.emplace_back();
    defs_[id.index] = def;
    std::visit(
        [&](const auto& kind) {
            using Joint = decltype(make_joint(kind));
            auto& list = std::get<std::vector<Entry<Joint>>>(lists_);
            list.insert(position(list, id), {id, make_joint(kind)});
        },
        def);
    return id;
}

void JointStore::destroy(JointId id) {
    std::visit(
        [&](const auto& kind) {
            auto& list = std::get<std::vector<Entry<decltype(make_joint(kind))>>>(lists_);
            list.erase(position(list, id));
        },
        defs_[id.index]);
    ids.release(id);
    ids.recycle(id.index);
}

JointReaction JointStore::reaction(JointId id) const {
    return std::visit(
        [&](const auto& kind) {
            const auto& list = std::get<std::vector<Entry<decltype(make_joint(kind))>>>(lists_);
            return position(list, id)->joint.reaction();
        },
        defs_[id.index]);
}

void JointStore::prepare(const BodyStore& bodies) {
    for_each(*this, [&](auto& joint) { joint.prepare(bodies); });
}

void JointStore::warm_start(std::span<SolverBody> bodies) const {
    for_each(*this, [&](const auto& joint) { joint.warm_start(bodies); });
}

void JointStore::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    for_each(*this, [&](auto& joint) { joint.solve(context, use_bias, bodies); });
}

void JointStore::store(const JointContext& context) {
    for_each(*this, [&](auto& joint) { joint.store(context); });
}

}  // namespace tumble
