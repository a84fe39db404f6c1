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

}  // namespace

// Calls visit(list, def) with the list that holds a joint and its definition, both of the joint's kind.
template <class Self, class Visitor>
void JointStore::visit_list_of(Self& self, JointId id, Visitor&& visit) {
    std::visit([&](const auto& kind) { visit(std::get<JointList<decltype(make_joint(kind))>>(self.lists_), kind); },
               self.records_[id.index].def);
}

JointId JointStore::create(const JointDef& def) {
    const JointId id = ids.acquire();
    if (id.index == records_.size()) records_.emplace_back();
    records_[id.index] = {def, 0, false};
    visit_list_of(*this, id, [&](auto& list, const auto& kind) {
        if (list.free.empty()) {
            list.free.push_back(static_cast<std::uint32_t>(list.joints.size()));
            list.joints.push_back(make_joint(kind));
        }
        const std::uint32_t slot = list.free.back();
        list.free.pop_back();
        list.joints[slot] = make_joint(kind);
        records_[id.index].slot = slot;
    });
    wake(id);
    return id;
}

void JointStore::destroy(JointId id) {
    put_to_sleep({&id, 1});
    visit_list_of(*this, id, [&](auto& list, const auto&) { list.free.push_back(records_[id.index].slot); });
    ids.release(id);
    ids.recycle(id.index);
}

JointReaction JointStore::reaction(JointId id) const {
    JointReaction result;
    visit_list_of(*this, id,
                  [&](const auto& list, const auto&) { result = list.joints[records_[id.index].slot].reaction(); });
    return result;
}

void JointStore::wake(JointId id) {
    JointRecord& record = records_[id.index];
    if (record.is_awake) return;
    record.is_awake = true;
    is_unsorted_ = true;
    visit_list_of(*this, id, [&](auto& list, const auto&) { list.awake.push_back({id.index, record.slot}); });
}

void JointStore::put_to_sleep(std::span<const JointId> sleepers) {
    for (const JointId id : sleepers) records_[id.index].is_awake = false;
    for_each_list(*this, [&](auto& list) {
        std::erase_if(list.awake, [&](AwakeJoint awake) { return !records_[awake.joint].is_awake; });
    });
}

void JointStore::prepare(const BodyStore& bodies) {
    if (is_unsorted_) for_each_list(*this, [](auto& list) { std::sort(list.awake.begin(), list.awake.end()); });
    is_unsorted_ = false;
    for_each_awake(*this, [&](auto& joint) { joint.prepare(bodies); });
}

void JointStore::warm_start(std::span<SolverBody> bodies) const {
    for_each_awake(*this, [&](const auto& joint) { joint.warm_start(bodies); });
}

void JointStore::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies) {
    for_each_awake(*this, [&](auto& joint) { joint.solve(context, use_bias, bodies); });
}

void JointStore::store(const JointContext& context) {
    for_each_awake(*this, [&](auto& joint) { joint.store(context); });
}

}  // namespace tumble
