// The direct solver of joints: the equality constraints of all joints that it takes as one linear system, solved
// exactly. It takes all joints, or those of joint_store/joint_groups.hpp.
//
// In a sub-step of length h, C are the errors of the rows, J their Jacobian, M the masses, and A = J M^-1 J^T:
//   before the bodies move   1. A P = -J v: the velocities, with what gravity and forces have added, satisfy the rows
//   (the chord)              2. A P = -C(x + h v) / h: the errors are zero at the end of the sub-step. The velocity is
//                               that along the chord of each path, not its tangent
//   after they have moved    3. A P = -J v with J at the new x: the velocities satisfy the rows again
//   (the projection)
// This is RATTLE [Andersen 1983] with gravity as a kick before each sub-step. JOINT_SYSTEM.md derives it.
//
// Contacts, limits, motors and springs are not part of the system; they are iterated before steps 1 and 3.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/direct/energy_guard.hpp"
#include "dynamics/direct/sparse_ldlt.hpp"
#include "dynamics/direct/system_pattern.hpp"
#include "dynamics/joint_store/joint_store.hpp"

namespace tumble {

class JointSystem {
public:
    // Lists and factorizes the rows at the start of a step. Allocates only if their bodies are others than in the last
    // step, or if other joints are solved directly. `h` is the sub-step, s; errors are corrected at no more than
    // `correction_speed`, m/s or rad/s.
    void prepare(JointStore& joints, std::span<const SolverBody> bodies, float h, float correction_speed);

    // Applies the impulses of the last sub-step, so that contacts, limits, motors and springs see the forces of the
    // joints (JOINT_SYSTEM.md, section 4).
    void warm_start(std::span<SolverBody> bodies);

    void solve_chord(JointStore& joints, std::span<SolverBody> bodies);
    void project_velocities(JointStore& joints, std::span<SolverBody> bodies);

    std::size_t bytes() const;

private:
    using Motion = std::array<double, 3>;  // along x and y, and the rotation

    // A row at one of its bodies.
    struct End {
        std::uint32_t body = kStaticSolverBody;
        Motion jacobian{};  // the derivative of the row's velocity by that of the body
        Motion response{};  // the velocity of the body by a unit impulse along the row
    };
    struct Row {
        std::array<End, 4> ends;
        std::uint32_t end_count = 0;
        double error = 0.0;          // at the start of the sub-step, m or rad
        float* impulse = nullptr;    // of the joint
        double dead_response = 0.0;  // of rows/joint_row.hpp
        double kept_part = 1.0;      // of the impulse, in the next sub-step (JOINT_SYSTEM.md, section 5)
        float carried = 0.0f;        // the impulse with which the sub-step began
    };
    // What the rows of a step need of a body that they move.
    struct Load {
        Vec2 anchors;                // the sum of the arms of linear rows, m
        float anchor_count = 0.0f;   // their number
        double stiffness = 0.0;      // of the rotation, N m s: h times the torque per angle
        double least_inertia = 0.0;  // kg m^2
    };

    void list_rows(JointStore& joints, std::span<const SolverBody> bodies);
    bool has_same_couplings();
    void measure_loads();
    void hold_components();
    double own_part(const RowEnd& end) const;
    End make_end(const RowEnd& end) const;
    void make_rows();
    void factorize();
    static void damp(Row& row, double& response);
    void predict(std::span<const std::uint32_t> chosen, std::span<const SolverBody> bodies);
    void project(std::span<SolverBody> bodies);
    void apply(std::span<SolverBody> bodies);
    void add_solution(std::span<SolverBody> bodies);

    float h_ = 0.0f;
    double largest_correction_ = 0.0;  // in a sub-step, m or rad
    SystemPattern pattern_;
    std::vector<EqualityRow> listed_;  // as the joints list them
    std::vector<Row> rows_;            // by position
    std::vector<Load> loads_;          // by solver body
    std::vector<Motion> changes_;      // by solver body: of the velocity
    std::vector<GuardedBody> guarded_;
    EnergyGuard guard_;
    std::vector<double> entries_, diagonal_, solution_;
    SparseLdlt factor_;
    std::vector<std::uint32_t> driven_;  // kinematic solver bodies of the rows, some more than once
    std::vector<SolverBody> predicted_;  // those of the rows at the end of the sub-step with the present velocities
};

}  // namespace tumble
