#include "world/memory.hpp"

#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "world/visit_members.hpp"

namespace tumble {

namespace {

// Adds up what vectors have allocated.
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

template <class... Part>
std::size_t bytes_of(const Part&... part) {
    MemoryCounter counter;
    (visit_value(counter, part), ...);
    return counter.bytes();
}

// Of vectors of plain values.
template <class... T>
std::size_t capacity_bytes(const std::vector<T>&... values) {
    return ((values.capacity() * sizeof(T)) + ...);
}

}  // namespace

WorldMemory count_memory(const Simulation& simulation) {
    WorldMemory memory;
    memory.bodies = bytes_of(simulation.bodies);
    memory.shapes = bytes_of(simulation.shapes);
    memory.joints = bytes_of(simulation.joints);
    memory.broad_phase = bytes_of(simulation.broad) + simulation.broad.spare_bytes();
    memory.contacts = bytes_of(simulation.contacts, simulation.sleeping);
    memory.solver = simulation.graph.bytes() + capacity_bytes(simulation.blocks);
    memory.other = bytes_of(simulation.events) + simulation.islands.bytes() +
                   capacity_bytes(simulation.sleepers, simulation.island_of_root, simulation.sleeping_joints,
                                  simulation.given_work, simulation.footings, simulation.movers, simulation.near_shapes,
                                  simulation.impacts, simulation.sensor_passes);
    return memory;
}

}  // namespace tumble
