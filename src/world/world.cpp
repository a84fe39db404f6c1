// The world as a whole: its settings, the step, its reports and its snapshots.
#include "tumble/world.hpp"

#include <exception>
#include <string>
#include <vector>

#include "dynamics/stages/sleep.hpp"
#include "dynamics/step.hpp"
#include "tasks/crew.hpp"
#include "world/audit.hpp"
#include "world/contact_report.hpp"
#include "world/input_checks.hpp"
#include "world/island_numbers.hpp"
#include "world/memory.hpp"
#include "world/snapshot.hpp"
#include "world/state_hash.hpp"
#include "world/world_impl.hpp"

namespace tumble {

StepCounters World::Impl::count() const {
    StepCounters counters_now;
    counters_now.bodies = static_cast<int>(simulation.bodies.ids.live().size());
    counters_now.joints = static_cast<int>(simulation.joints.ids.live().size());
    counters_now.colors = simulation.report.colors;
    counters_now.awake_bodies = simulation.bodies.awake_dynamic_count();
    counters_now.sleeping_islands = static_cast<int>(simulation.sleeping.count());
    counters_now.contacts = static_cast<int>(simulation.contact_counts.contacts);
    counters_now.contact_points = static_cast<int>(simulation.contact_counts.points);
    counters_now.pairs = simulation.report.collided.pairs;
    counters_now.collided = simulation.report.collided.full;
    counters_now.gjk_iterations = simulation.report.collided.iterations;
    counters_now.ms = simulation.report.times;
    return counters_now;
}

void World::Impl::apply_settings() { simulation.settings = make_settings(def); }

World::World(const WorldDef& def) {
    check(def);
    impl_ = std::make_unique<Impl>();
    impl_->def = def;
    impl_->apply_settings();
    impl_->simulation.crew = Crew(def.threads);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::set_threads(const Threads& threads) {
    check(threads);
    impl_->def.threads = threads;
    impl_->simulation.crew = Crew(threads);
}

void World::set_gravity(Vec2 gravity) {
    check_action(gravity, "gravity");
    impl_->def.gravity = gravity;
    impl_->apply_settings();
    for (const BodyId id : impl_->simulation.bodies.ids.live()) wake(impl_->simulation, id.index);
}

void World::Impl::step() {
    if (diverged_body == kNoBody) {
        const bool is_finite = tumble::step(simulation, step_count);
        for (const JointId id : simulation.events.broken_joints)
            if (simulation.joints.ids.is_live(id))  // a broken gear may be destroyed already, with one of its joints
                destroy_joint(id);
        ++step_count;
        counters = count();
        if (!is_finite) diverged_body = find_diverged(simulation.bodies);
    }
    if (diverged_body != kNoBody) throw SimulationDiverged(simulation.bodies.ids.at(diverged_body), step_count);
}

void World::step() {
    impl_->simulation.scratch.use_own();
    impl_->step();
}

void World::step(StepMemory& memory) {
    if (!memory.scratch_) memory.scratch_ = std::make_unique<StepScratch>();
    const ScratchLoan loan(impl_->simulation.scratch, *memory.scratch_);
    impl_->step();
}

StepMemory::StepMemory() = default;
StepMemory::~StepMemory() = default;
StepMemory::StepMemory(StepMemory&&) noexcept = default;
StepMemory& StepMemory::operator=(StepMemory&&) noexcept = default;

void step_all(std::span<World* const> worlds, const Threads& threads) {
    check(threads);
    std::vector<std::exception_ptr> errors(worlds.size());
    Crew crew({threads.count, threads.tasks, 0});
    crew.work_together(worlds.size(), [&] {
        crew.for_each(worlds.size(), 1, [&](std::size_t i) {
            try {
                worlds[i]->step();
            } catch (...) {
                errors[i] = std::current_exception();
            }
        });
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

std::uint64_t World::step_count() const noexcept { return impl_->step_count; }
double World::time() const noexcept {
    return static_cast<double>(impl_->step_count) / double{impl_->def.steps_per_second};
}
const WorldDef& World::def() const noexcept { return impl_->def; }

std::vector<int> World::islands() const { return find_island_numbers(impl_->simulation); }

const StepEvents& World::events() const noexcept { return impl_->simulation.events; }

std::vector<ContactPoint> World::contacts() const { return report_contacts(impl_->simulation, kNoBody); }

std::vector<ContactPoint> World::contacts(BodyId id) const {
    impl_->require(id);
    return report_contacts(impl_->simulation, id.index);
}

std::vector<ShapePair> World::candidate_pairs() const { return report_pairs(impl_->simulation); }

std::uint64_t World::state_hash() const { return hash_bodies(impl_->simulation.bodies); }

const StepCounters& World::counters() const noexcept { return impl_->counters; }

WorldMemory World::memory() const { return count_memory(impl_->simulation); }

std::vector<std::byte> World::save() const {
    return write_snapshot({impl_->def, impl_->simulation, impl_->step_count, impl_->diverged_body});
}

World World::load(std::span<const std::byte> snapshot) {
    World world;
    Impl& impl = *world.impl_;
    read_snapshot(snapshot, {impl.def, impl.simulation, impl.step_count, impl.diverged_body});
    impl.apply_settings();
    impl.counters = impl.count();
    impl.is_restored = true;
    return world;
}

void World::assign(const World& other) {
    if (this == &other) return;
    const Threads threads = impl_->def.threads;
    impl_->def = other.impl_->def;
    impl_->def.threads = threads;
    static_cast<SimulationState&>(impl_->simulation) = other.impl_->simulation;
    impl_->simulation.report = other.impl_->simulation.report;
    impl_->step_count = other.impl_->step_count;
    impl_->diverged_body = other.impl_->diverged_body;
    impl_->is_restored = true;
    impl_->counters = other.impl_->counters;
    impl_->apply_settings();
}

void World::audit() const { tumble::audit(impl_->simulation); }

SimulationDiverged::SimulationDiverged(BodyId body_, std::uint64_t step_, const std::string& name)
    : std::runtime_error("the simulation diverged in step " + std::to_string(step_) + ": body " +
                         (name.empty() ? std::to_string(body_.index) : name) + " is not finite"),
      body(body_),
      step(step_) {}

}  // namespace tumble
