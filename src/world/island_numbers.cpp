#include "world/island_numbers.hpp"

#include "dynamics/state/collision_rules.hpp"

namespace tumble {

namespace {

// Joins body indices, not solver bodies as the step does, because sleeping bodies have no solver bodies.
class IslandNumbers {
public:
    explicit IslandNumbers(const Simulation& simulation) : simulation_(simulation) {
        sets_.reset(simulation.bodies.frames.size());
        for (const Contact& contact : simulation.contacts.all()) join(contact);
        for (const Contact& contact : simulation.contacts.woken()) join(contact);
        for (const SleepingIsland& island : simulation.sleeping.all())
            for (const Contact& contact : island.contacts) join(contact);
        for (const JointId id : simulation.joints.ids.live())
            simulation.joints.bodies(id).for_each_pair([this](std::uint32_t a, std::uint32_t b) { join(a, b); });
    }

    std::vector<int> number() {
        std::vector<int> of_root(simulation_.bodies.frames.size(), -1), numbers;
        int count = 0;
        for (const BodyId id : simulation_.bodies.ids.live()) {
            int& number = of_root[sets_.root(id.index)];
            const bool has_island = simulation_.bodies.is_dynamic(id.index);
            if (has_island && number < 0) number = count++;
            numbers.push_back(has_island ? number : -1);
        }
        return numbers;
    }

private:
    void join(const Contact& contact) {
        if (contact.manifold.point_count > 0 && !is_over(simulation_, contact)) join(contact.body_a, contact.body_b);
    }
    void join(std::uint32_t a, std::uint32_t b) {
        if (simulation_.bodies.is_dynamic(a) && simulation_.bodies.is_dynamic(b)) sets_.join(a, b);
    }

    const Simulation& simulation_;
    IslandFinder sets_;
};

}  // namespace

std::vector<int> find_island_numbers(const Simulation& simulation) { return IslandNumbers(simulation).number(); }

}  // namespace tumble
