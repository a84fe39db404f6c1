#include "dynamics/joint_store/joint_store.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/joint_store/revolute_block.hpp"
#include "dynamics/rows/joint_ends.hpp"

namespace tumble {

namespace {

RevoluteJoint make_joint(const RevoluteJointDef& def) { return RevoluteJoint(def); }
DistanceJoint make_joint(const DistanceJointDef& def) { return DistanceJoint(def); }
PrismaticJoint make_joint(const PrismaticJointDef& def) { return PrismaticJoint(def); }
WeldJoint make_joint(const WeldJointDef& def) { return WeldJoint(def); }
WheelJoint make_joint(const WheelJointDef& def) { return WheelJoint(def); }
MotorJoint make_joint(const MotorJointDef& def) { return MotorJoint(def); }
MouseJoint make_joint(const MouseJointDef& def) { return MouseJoint(def); }
FilterJoint make_joint(const FilterJointDef& def) { return FilterJoint(def); }
PulleyJoint make_joint(const PulleyJointDef& def) { return PulleyJoint(def); }

// A filter joint has neither a strength nor collide_connected; every other definition has both.
struct Strength {
    JointStrength operator()(const FilterJointDef&) const { return {}; }
    JointStrength operator()(const auto& def) const { return {def.break_force, def.break_torque}; }
};

struct CollidesConnected {
    bool operator()(const FilterJointDef&) const { return false; }
    bool operator()(const auto& def) const { return def.collide_connected; }
};

JointRows rows_if(bool is_rigid) { return is_rigid ? JointRows::rigid : JointRows::other; }

struct Rows {
    JointRows operator()(const FilterJointDef&) const { return JointRows::none; }
    JointRows operator()(const MouseJointDef&) const { return JointRows::other; }
    JointRows operator()(const MotorJointDef&) const { return JointRows::other; }
    JointRows operator()(const WheelJointDef&) const { return JointRows::other; }
    JointRows operator()(const PulleyJointDef&) const { return JointRows::rigid; }
    JointRows operator()(const GearJointDef&) const { return JointRows::rigid; }
    JointRows operator()(const WeldJointDef& def) const { return rows_if(!def.linear_spring && !def.angular_spring); }
    JointRows operator()(const auto& def) const { return rows_if(!def.limits && !def.motor && !def.spring); }
};
JointRows rows_of(const JointDef& def) { return std::visit(Rows{}, def); }

}  // namespace

bool collides_connected(const JointDef& def) { return std::visit(CollidesConnected{}, def); }

JointStrength joint_strength(const JointDef& def) { return std::visit(Strength{}, def); }

template <class Def>
auto JointStore::make(const Def& kind) const {
    if constexpr (std::is_same_v<Def, GearJointDef>)
        return GearJoint(kind, def(kind.joint_a), def(kind.joint_b));
    else
        return make_joint(kind);
}

template <class Self, class Visitor>
void JointStore::visit_list_of(Self& self, JointId id, Visitor&& visit) {
    std::visit([&](const auto& kind) { visit(std::get<JointList<decltype(self.make(kind))>>(self.lists_), kind); },
               self.records_[id.index].def);
}

JoinedBodies JointStore::bodies(JointId id) const {
    TUMBLE_CHECK(ids.is_live(id));
    JoinedBodies joined;
    const auto add = [&](const JointDef& joint) {
        joined.add(joint_body_a(joint));
        joined.add(joint_body_b(joint));
    };
    if (const auto* gear = std::get_if<GearJointDef>(&def(id))) {
        add(def(gear->joint_a));
        add(def(gear->joint_b));
    } else {
        add(def(id));
    }
    return joined;
}

JointId JointStore::create(const JointDef& def) {
    const JointId id = ids.acquire();
    TUMBLE_CHECK(id.index <= records_.size());
    if (id.index == records_.size()) {
        records_.emplace_back();
        loads_.emplace_back();
    }
    records_[id.index] = JointRecord{def, 0, false};
    loads_[id.index] = {{}, joint_strength(def)};
    visit_list_of(*this, id, [&](auto& list, const auto& kind) {
        if (list.free.empty()) {
            list.free.push_back(static_cast<std::uint32_t>(list.joints.size()));
            list.joints.emplace_back();
        }
        const std::uint32_t slot = list.free.back();
        TUMBLE_CHECK(slot < list.joints.size());
        list.free.pop_back();
        list.joints[slot] = make(kind);
        records_[id.index].slot = slot;
    });
    wake(id);
    return id;
}

void JointStore::destroy(JointId id) {
    TUMBLE_CHECK(ids.is_live(id));
    visit_list_of(*this, id, [&](auto& list, const auto&) {
        const std::uint32_t slot = records_[id.index].slot;
        TUMBLE_CHECK(slot < list.joints.size());
        TUMBLE_CHECK(list.free.size() < list.joints.size());
        list.free.push_back(slot);
        if (records_[id.index].is_awake)
            list.awake.erase(std::find(list.awake.begin(), list.awake.end(), AwakeJoint{id.index, slot}));
    });
    records_[id.index].is_awake = false;
    has_groups_ = false;
    ids.release(id);
    ids.recycle(id.index);
}

float JointStore::position(JointId id) const {
    TUMBLE_CHECK(ids.is_live(id));
    float result = 0.0f;
    visit_list_of(*this, id,
                  [&](const auto& list, const auto&) { result = list.joints[records_[id.index].slot].position(); });
    return result;
}

void JointStore::redefine(JointId id, const JointDef& def) {
    TUMBLE_CHECK(ids.is_live(id));
    TUMBLE_CHECK(def.index() == records_[id.index].def.index());
    has_groups_ &= rows_of(def) == rows_of(records_[id.index].def);
    records_[id.index].def = def;
    loads_[id.index].strength = joint_strength(def);
    visit_list_of(*this, id, [&](auto& list, const auto& kind) {
        TUMBLE_CHECK(records_[id.index].slot < list.joints.size());
        auto& joint = list.joints[records_[id.index].slot];
        auto changed = make(kind);
        if constexpr (requires { changed.drive_parts(); }) has_groups_ &= changed.drive_parts() == joint.drive_parts();
        changed.take_over(joint);
        joint = changed;
    });
}

void JointStore::set_user_data(JointId id, std::uint64_t data) {
    std::visit([data](auto& def) { def.user_data = data; }, records_[id.index].def);
}

void JointStore::forget_impulses(JointId id) {
    TUMBLE_CHECK(ids.is_live(id));
    visit_list_of(*this, id, [&](auto& list, const auto&) { list.joints[records_[id.index].slot].forget_impulses(); });
}

void JointStore::wake(JointId id) {
    TUMBLE_CHECK(ids.is_live(id));
    JointRecord& record = records_[id.index];
    if (record.is_awake) return;
    record.is_awake = true;
    is_unsorted_ = true;
    has_groups_ = false;
    visit_list_of(*this, id, [&](auto& list, const auto&) { list.awake.push_back({id.index, record.slot}); });
}

void JointStore::put_to_sleep(std::span<const JointId> sleepers) {
    for (const JointId id : sleepers) {
        TUMBLE_CHECK(ids.is_live(id));
        records_[id.index].is_awake = false;
    }
    has_groups_ &= sleepers.empty();
    for_each_list(*this, [&](auto& list) {
        std::erase_if(list.awake, [&](AwakeJoint awake) { return !records_[awake.joint].is_awake; });
    });
}

void JointStore::find_groups(const BodyStore& bodies, JointSolver solver) {
    std::vector<GroupedJoint> joints(records_.size());
    for_each_list(*this, [&](auto& list) {
        for (const AwakeJoint& awake : list.awake)
            joints[awake.joint] = {rows_of(records_[awake.joint].def), this->bodies(ids.at(awake.joint))};
    });
    groups_.find(solver, joints, bodies);
}

void JointStore::find_blocks(const BodyStore& bodies) {
    for_each_list(*this, [&](auto& list) {
        list.blocks.find(list.awake.size(), bodies,
                         [&](std::size_t i) { return this->bodies(ids.at(list.awake[i].joint)); });
    });
}

void JointStore::find_lanes(const BodyStore& bodies) {
    const auto& list = std::get<JointList<RevoluteJoint>>(lists_);
    std::vector<RevoluteLanes::Entry> entries;
    for (const AwakeJoint& awake : list.awake)
        entries.push_back({awake.slot, !groups_.is_lone(awake.joint) && !groups_.may_be_direct(awake.joint) &&
                                           list.joints[awake.slot].fits_lanes(bodies)});
    revolute_lanes_.find(list.blocks, entries, list.joints, bodies);
}

void JointStore::prepare(const BodyStore& bodies, JointSolver solver, float h, Crew& crew) {
    constexpr std::size_t kLeastJoints = 96;  // in a chunk: about 3 us of work
    if (is_unsorted_) for_each_list(*this, [](auto& list) { std::sort(list.awake.begin(), list.awake.end()); });
    is_unsorted_ = false;
    for_each_list(*this, [](const auto& list) {
        TUMBLE_CHECK(std::is_sorted(list.awake.begin(), list.awake.end()));
        TUMBLE_CHECK(list.awake.size() + list.free.size() <= list.joints.size());
    });
    if (!has_groups_) {
        find_blocks(bodies);
        find_groups(bodies, solver);
        find_lanes(bodies);
        has_groups_ = true;
    }
    for_each_list(*this, [&](auto& list) {
        crew.for_each(list.awake.size(), kLeastJoints, [&](std::size_t i) {
            auto& joint = list.joints[list.awake[i].slot];
            joint.prepare(bodies);
            if (!is_in_lanes(list, i)) joint.update_rows(bodies.solver_bodies);
            if constexpr (requires { joint.set_lone(true); }) joint.set_lone(groups_.is_lone(list.awake[i].joint));
        });
    });
    revolute_lanes_.load(std::get<JointList<RevoluteJoint>>(lists_).joints, bodies, h, crew);
}

// Calls visit(joint, index) for each awake joint of a list, in blocks if there are many, and visit_block(block) for
// those that are solved in lanes. Inlined: a call for each list in each pass takes 3 % of the step of a double
// pendulum.
template <class Self, class List, class VisitBlock, class Visitor>
[[gnu::always_inline]] inline void JointStore::for_each_in_blocks(Self& self, List& list, Crew& crew,
                                                                  VisitBlock&& visit_block, Visitor&& visit) {
    if (list.awake.empty()) return;
    const auto visit_one = [&](std::size_t i) __attribute__((always_inline)) {
        visit(list.joints[list.awake[i].slot], list.awake[i].joint);
    };
    const auto visit_range = [&](std::size_t first, std::size_t end) __attribute__((always_inline)) {
        for (std::size_t i = first; i < end; ++i) visit_one(i);
    };
    if constexpr (std::is_same_v<std::remove_const_t<List>, JointList<RevoluteJoint>>)
        if (self.revolute_lanes_.is_used())
            return RevoluteLanes::for_each(self.revolute_lanes_, crew, visit_block, visit_one);
    if (list.blocks.is_divided()) [[unlikely]]
        list.blocks.for_each(crew, visit_range);
    else
        visit_range(0, list.awake.size());
}

void JointStore::warm_start(std::span<SolverBody> bodies, Crew& crew) const {
    TUMBLE_CHECK(bodies.size() > kStaticSolverBody);
    for_each_list(*this, [&](const auto& list) {
        for_each_in_blocks(
            *this, list, crew, [&](const RevoluteBlock& block) { warm_start_joints(block, bodies); },
            [&](const auto& joint, std::uint32_t) { joint.warm_start(bodies); });
    });
}

void JointStore::solve(const JointContext& context, bool use_bias, std::span<SolverBody> bodies, Crew& crew) {
    TUMBLE_CHECK(context.h > 0.0f);
    TUMBLE_CHECK(bodies.size() > kStaticSolverBody);
    JointContext without_equalities = context;
    without_equalities.iterates_equalities = false;
    const bool has_any_direct = has_direct();
    for_each_list(*this, [&](auto& list) {
        for_each_in_blocks(
            *this, list, crew, [&](RevoluteBlock& block) { solve_joints(block, context, use_bias, bodies); },
            [&](auto& joint, std::uint32_t index) {
                if (!use_bias) joint.update_rows(bodies);
                const bool is_direct = has_any_direct && groups_.is_direct(index);
                joint.solve(is_direct ? without_equalities : context, use_bias, bodies);
            });
    });
}

void JointStore::store(const JointContext& context, Crew& crew) {
    TUMBLE_CHECK(context.inv_h > 0.0f);
    revolute_lanes_.store(std::get<JointList<RevoluteJoint>>(lists_).joints, crew);
    broken_.clear();
    for_each_list(*this, [&](auto& list) {
        for (const AwakeJoint& awake : list.awake) {
            JointLoad& load = loads_[awake.joint];
            load.reaction = list.joints[awake.slot].reaction(context.inv_h);
            TUMBLE_CHECK(ids.at(awake.joint).index == awake.joint);
            const bool is_intact = length(load.reaction.force) <= load.strength.force &&
                                   std::abs(load.reaction.torque) <= load.strength.torque;
            if (!is_intact) broken_.push_back(ids.at(awake.joint));
        }
    });
    std::sort(broken_.begin(), broken_.end());
}

}  // namespace tumble
