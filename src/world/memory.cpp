#include "world/memory.hpp"

#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "world/visit_members.hpp"

namespace tumble {

namespace {

// Adds up the memory that vectors have allocated.
class MemoryCounter {
public:
    template <class T>
    void leaf(const T&) {}
    template <class T>
    void list(const std::vector<T>& values) {
        bytes_ += values.capacity() * sizeof(T);
        if constexpr (!std::is_trivially_copyable_v<T>)
            for (const T& value : values) visit_value(*this, value);
    }
    template <class T>
    void optional(const std::optional<T>& value) {
        if (value) visit_value(*this, *value);
    }
    template <class... T>
    void variant(const std::variant<T...>& value) {
        std::visit([&](const auto& alternative) { visit_value(*this, alternative); }, value);
    }
    void shape(const Shape& shape) {
        if (!shape.large()) return;
        bytes_ += sizeof(LargePolygon);
        list(shape.large()->x);
        list(shape.large()->y);
        list(shape.large()->edge_angles);
        list(shape.large()->edges_before);
    }

    std::size_t bytes() const { return bytes_; }

private:
    std::size_t bytes_ = 0;
};

template <class Part>
std::size_t bytes_of(const Part& part) {
    MemoryCounter counter;
    visit_value(counter, part);
    return counter.bytes();
}
std::size_t bytes_of(const ContactStore& contacts) {
    MemoryCounter counter;
    visit_value(counter, contacts);
    return counter.bytes() + contacts.spare_bytes();
}
std::size_t bytes_of(const BroadPhase& broad) {
    MemoryCounter counter;
    visit_value(counter, broad);
    return counter.bytes() + broad.spare_bytes();
}

std::size_t bytes_of(const JointStore& joints) {
    MemoryCounter counter;
    visit_value(counter, joints);
    return counter.bytes() + joints.derived_bytes();
}

// Members of the scratch memory are vectors of plain values, or count themselves.
template <class T>
std::size_t scratch_bytes(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}
template <class T>
std::size_t scratch_bytes(const T& value) {
    return value.bytes();
}
std::size_t scratch_bytes(const ContactLists& lists) {
    return scratch_bytes(lists.first) + scratch_bytes(lists.contacts);
}
std::size_t scratch_bytes(const BounceScratch& scratch) {
    return scratch_bytes(scratch.touch_counts) + scratch_bytes(scratch.landings) + scratch_bytes(scratch.group_sizes) +
           scratch_bytes(scratch.group_landings);
}

std::size_t scratch_bytes(const AabbTree& tree) { return bytes_of(tree); }
std::size_t scratch_bytes(const ImpactScratch& scratch) {
    std::size_t bytes = 0;
    visit_fields_of(scratch, [&](const auto&... member) { ((bytes += scratch_bytes(member)), ...); });
    return bytes;
}

// The total that a member's memory belongs to: `other`, unless its type has a line here.
std::size_t& total_of(WorldMemory& memory, const BodyStore&) { return memory.bodies; }
std::size_t& total_of(WorldMemory& memory, const ShapeStore&) { return memory.shapes; }
std::size_t& total_of(WorldMemory& memory, const JointStore&) { return memory.joints; }
std::size_t& total_of(WorldMemory& memory, const BroadPhase&) { return memory.broad_phase; }
std::size_t& total_of(WorldMemory& memory, const ContactStore&) { return memory.contacts; }
std::size_t& total_of(WorldMemory& memory, const SleepingIslands&) { return memory.contacts; }
std::size_t& total_of(WorldMemory& memory, const ContactSolver&) { return memory.solver; }
template <class T>
std::size_t& total_of(WorldMemory& memory, const T&) {
    return memory.other;
}

}  // namespace

WorldMemory count_memory(const Simulation& simulation) {
    WorldMemory memory;
    const SimulationState& state = simulation;
    visit_fields_of(state, [&](const auto&... member) { ((total_of(memory, member) += bytes_of(member)), ...); });
    if (const StepScratch* scratch = simulation.scratch.own())
        visit_fields_of(*scratch,
                        [&](const auto&... member) { ((total_of(memory, member) += scratch_bytes(member)), ...); });
    return memory;
}

}  // namespace tumble
