// One scene running in tumble, with either model of impacts, or in Box2D 2.4.1, seen in the same way: motions of
// bodies, energies, gaps of joints.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tumble/math.hpp"
#include "tumble/scene.hpp"

namespace tumble::reference {

// tumble with the impacts of the scene, tumble with ImpactModel::at_step_end, and Box2D.
enum class Engine { tumble, at_step_end, box2d };
inline constexpr Engine kEngines[] = {Engine::tumble, Engine::at_step_end, Engine::box2d};

// World coordinates, SI units.
struct BodyMotion {
    DVec2 position;      // of the origin, which is the centre of mass of a body whose shape is centred
    double angle = 0.0;  // -pi to pi
    DVec2 velocity;      // of the centre of mass
    double spin = 0.0;   // rad/s
    bool awake = true;
};

class EngineRun {
public:
    virtual ~EngineRun() = default;
    EngineRun(const EngineRun&) = delete;
    EngineRun& operator=(const EngineRun&) = delete;

    // Advances by one step of the scene. Throws SimulationDiverged.
    void step();
    void run_until(double time);  // s, to the nearest step

    // Bodies are numbered from 0 in the order of the scene. Repeaters count.
    virtual BodyMotion body(int index) const = 0;

    int body_count() const noexcept { return static_cast<int>(masses_.size()); }
    bool is_dynamic(int index) const { return masses_[static_cast<std::size_t>(index)].mass > 0.0; }
    double mass(int index) const { return masses_[static_cast<std::size_t>(index)].mass; }
    double time() const noexcept { return static_cast<double>(steps_) * step_duration_; }  // s
    double step_duration() const noexcept { return step_duration_; }                       // s
    double step_milliseconds() const;  // CPU time of a step, the mean so far

    double kinetic_energy() const;    // J, of all dynamic bodies
    double potential_energy() const;  // J, of the centres of mass under the scene's gravity, 0 at the origin
    double energy() const { return kinetic_energy() + potential_energy(); }

    // The widest distance between the anchors of a revolute joint, m; 0 without joints.
    double widest_gap() const;

    bool all_asleep() const;

protected:
    explicit EngineRun(const Scene& scene);
    virtual void advance() = 0;

private:
    struct Mass {
        double mass = 0.0, inertia = 0.0;
        Vec2 center;
    };
    struct Hinge {
        int body_a = 0, body_b = 0;
        Vec2 anchor_a, anchor_b;
    };
    DVec2 center(int index) const;

    std::vector<Mass> masses_;
    std::vector<Hinge> hinges_;
    DVec2 gravity_;
    double step_duration_ = 0.0;
    double cpu_seconds_ = 0.0;
    long steps_ = 0;
};

// Builds the scene's world in the engine. Throws the exceptions of build_world().
std::unique_ptr<EngineRun> start(Engine engine, const Scene& scene);

}  // namespace tumble::reference
