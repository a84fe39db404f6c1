#include "dynamics/direct/joint_system.hpp"

#include <algorithm>
#include <utility>

#include "debug/check.hpp"

namespace tumble {

namespace {

// The largest (w h)^2 of a body that tension keeps in line, w its natural frequency. Explicit steps are unstable above
// 4, and resonate with the nonlinearity of large rotations above 2. Higher: taut chains of light links with a heavy end
// lose their energy in shaking links. Lower: such links turn more slowly than their inertia lets them.
constexpr double kStiffRotation = 2.0;

bool is_moved(const RowEnd& end) { return end.inv_mass != Vec2{} || end.inv_inertia != 0.0f; }

RowCoupling coupling(const EqualityRow& row) {
    RowCoupling coupling{};
    TUMBLE_CHECK(row.end_count <= coupling.size());
    for (std::uint32_t i = 0; i < row.end_count; ++i)
        coupling[i] = is_moved(row.ends[i]) ? row.ends[i].body : kStaticSolverBody;
    return coupling;
}

double inverse(float value) { return value > 0.0f ? 1.0 / double{value} : 0.0; }

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Hold hold_of(const RowEnd& end) {
    if (!is_moved(end)) return end.body == kStaticSolverBody ? Hold::fixed : Hold::driven;
    return end.inv_mass.x > 0.0f && end.inv_mass.y > 0.0f ? Hold::free : Hold::fixed;
}

}  // namespace

bool JointSystem::has_same_couplings() {
    bool is_same = pattern_.couplings.size() == listed_.size();
    pattern_.couplings.resize(listed_.size());
    for (std::size_t i = 0; i < listed_.size(); ++i) {
        const RowCoupling now = coupling(listed_[i]);
        is_same &= pattern_.couplings[i] == now;
        pattern_.couplings[i] = now;
    }
    return is_same;
}

void JointSystem::prepare(JointStore& joints, std::span<const SolverBody> bodies, float h, float correction_speed) {
    TUMBLE_CHECK(h > 0.0f);
    TUMBLE_CHECK(correction_speed >= 0.0f);
    h_ = h;
    largest_correction_ = double{h} * double{correction_speed};
    list_rows(joints, bodies);
    if (!has_same_couplings()) {
        pattern_.analyze();
        factor_.analyze(pattern_.lower);
        rows_.assign(pattern_.couplings.size(), {});
        entries_.resize(pattern_.lower.columns.size());
        diagonal_.resize(rows_.size());
        solution_.resize(rows_.size());
        guarded_.resize(pattern_.bodies.size());
    }
    loads_.resize(bodies.size());
    changes_.resize(bodies.size());
    predicted_.resize(bodies.size());
    measure_loads();
    hold_components();
    make_rows();
    factorize();
}

void JointSystem::list_rows(JointStore& joints, std::span<const SolverBody> bodies) {
    listed_.clear();
    joints.visit_equalities(bodies, [&](const EqualityRow& row) { listed_.push_back(row); });
}

// Tension turns a link back into line, like a spring on the rotation. Where that spring is too stiff for the sub-step,
// the joints see a greater inertia (JOINT_SYSTEM.md, steps 9 to 13). It does not change what a chain weighs or where it
// hangs.
void JointSystem::measure_loads() {
    for (const std::uint32_t body : pattern_.bodies) {
        TUMBLE_CHECK(body < loads_.size());
        loads_[body] = {};
    }
    const auto for_each_linear_end = [&](auto&& visit) {
        for (const EqualityRow& row : listed_)
            for (std::uint32_t i = 0; i < row.end_count; ++i)
                if (is_moved(row.ends[i]) && row.ends[i].axis != Vec2{})
                    visit(loads_[row.ends[i].body], row.ends[i], *row.impulse);
    };
    for_each_linear_end([](Load& load, const RowEnd& end, float) {
        load.anchors += end.arm;
        load.anchor_count += 1.0f;
    });
    for_each_linear_end([](Load& load, const RowEnd& end, float impulse) {
        TUMBLE_CHECK(load.anchor_count >= 1.0f);
        const Vec2 arm = end.arm - (1.0f / load.anchor_count) * load.anchors;
        load.stiffness += double{impulse} * double{dot(end.axis, arm)};
    });
    for (const std::uint32_t body : pattern_.bodies)
        loads_[body].least_inertia = std::max(0.0, double{h_} * loads_[body].stiffness / kStiffRotation);
}

void JointSystem::hold_components() {
    TUMBLE_CHECK(guarded_.size() == pattern_.bodies.size());
    guard_.reset(pattern_.component_count);
    driven_.clear();
    for (std::size_t i = 0; i < guarded_.size(); ++i) {
        guarded_[i].body = pattern_.bodies[i];
        guarded_[i].component = pattern_.components[i];
    }
    for (std::size_t index = 0; index < listed_.size(); ++index) {
        const std::uint32_t component = pattern_.row_component[pattern_.positions[index]];
        TUMBLE_CHECK(component <= pattern_.component_count);
        for (std::uint32_t i = 0; i < listed_[index].end_count; ++i) {
            const RowEnd& end = listed_[index].ends[i];
            if (hold_of(end) == Hold::driven) driven_.push_back(end.body);
            if (component == pattern_.component_count) continue;
            guard_.hold(component, hold_of(end));
            if (!is_moved(end)) continue;
            const auto at = std::lower_bound(pattern_.bodies.begin(), pattern_.bodies.end(), end.body);
            GuardedBody& guarded = guarded_[static_cast<std::size_t>(at - pattern_.bodies.begin())];
            TUMBLE_CHECK(guarded.body == end.body);
            TUMBLE_CHECK(guarded.component == component);
            guarded.mass_x = inverse(end.inv_mass.x);
            guarded.mass_y = inverse(end.inv_mass.y);
            guarded.inertia =
                end.inv_inertia > 0.0f ? std::max(inverse(end.inv_inertia), loads_[end.body].least_inertia) : 0.0;
        }
    }
}

JointSystem::End JointSystem::make_end(const RowEnd& end) const {
    const double x = end.axis.x, y = end.axis.y, angular = end.angular;
    const double least = is_moved(end) ? loads_[end.body].least_inertia : 0.0;
    const bool is_stiff = double{end.inv_inertia} * least > 1.0;
    const double inv_inertia = is_stiff ? 1.0 / least : double{end.inv_inertia};
    return {end.body, {x, y, angular}, {end.inv_mass.x * x, end.inv_mass.y * y, inv_inertia * angular}};
}

// The inertia of the body as a part of that in the system: less than 1 under tension.
double JointSystem::own_part(const RowEnd& end) const {
    if (!is_moved(end)) return 1.0;
    const double ratio = double{end.inv_inertia} * loads_[end.body].least_inertia;
    return ratio > 1.0 ? 1.0 / ratio : 1.0;
}

void JointSystem::make_rows() {
    TUMBLE_CHECK(listed_.size() == rows_.size());
    for (std::size_t index = 0; index < listed_.size(); ++index) {
        const EqualityRow& listed = listed_[index];
        Row& row = rows_[pattern_.positions[index]];
        TUMBLE_CHECK(listed.impulse != nullptr);
        row.end_count = listed.end_count;
        row.error = listed.error;
        row.impulse = listed.impulse;
        row.dead_response = listed.dead_response;
        row.kept_part = 1.0;
        for (std::uint32_t i = 0; i < listed.end_count; ++i) {
            row.ends[i] = make_end(listed.ends[i]);
            row.kept_part = std::min(row.kept_part, own_part(listed.ends[i]));
        }
    }
}

void JointSystem::factorize() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        diagonal_[i] = 0.0;
        for (std::uint32_t end = 0; end < rows_[i].end_count; ++end)
            diagonal_[i] += product(rows_[i].ends[end].response, rows_[i].ends[end].jacobian);
    }
    std::fill(entries_.begin(), entries_.end(), 0.0);
    for (const EntryTerm& term : pattern_.terms) {
        TUMBLE_CHECK(term.end < rows_[term.row].end_count);
        TUMBLE_CHECK(term.other_end < rows_[term.other].end_count);
        const double value =
            product(rows_[term.row].ends[term.end].response, rows_[term.other].ends[term.other_end].jacobian);
        if (term.entry == EntryTerm::kDiagonal)
            diagonal_[term.row] += 2.0 * value;
        else
            entries_[term.entry] += value;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) damp(rows_[i], diagonal_[i]);
    factor_.factorize(pattern_.lower, entries_, diagonal_);
}

// Near a dead point the inverse of the diagonal is damped_inverse() of the response.
void JointSystem::damp(Row& row, double& response) {
    if (row.dead_response == 0.0 || response == 0.0) return;
    const double damped = response + row.dead_response * row.dead_response / response;
    row.kept_part *= response / damped;
    response = damped;
}

// The joints warm start too, but not with these impulses: their rows have the bodies' own inertia.
void JointSystem::warm_start(std::span<SolverBody> bodies) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].carried = static_cast<float>(rows_[i].kept_part) * std::exchange(*rows_[i].impulse, 0.0f);
        solution_[i] = double{rows_[i].carried};
    }
    add_solution(bodies);
}

void JointSystem::predict(std::span<const std::uint32_t> chosen, std::span<const SolverBody> bodies) {
    TUMBLE_CHECK(bodies.size() == predicted_.size());
    for (const std::uint32_t i : chosen) {
        predicted_[i] = bodies[i];
        predicted_[i].delta_position += h_ * bodies[i].velocity;
        predicted_[i].delta_rotation =
            compose(small_rotation(h_ * bodies[i].angular_velocity), bodies[i].delta_rotation);
    }
}

void JointSystem::solve_chord(JointStore& joints, std::span<SolverBody> bodies) {
    if (rows_.empty()) return;
    for (const Row& row : rows_) *row.impulse = row.carried;
    project(bodies);
    guard_.before_chord(guarded_, bodies);
    predict(pattern_.bodies, bodies);
    predict(driven_, bodies);
    std::size_t index = 0;
    joints.visit_equalities(predicted_, [&](const EqualityRow& row) {
        const std::uint32_t position = pattern_.positions[index++];
        const double now = rows_[position].error;
        const double left = now - std::clamp(now, -largest_correction_, largest_correction_);
        solution_[position] = (left - double{row.error}) / double{h_};
    });
    TUMBLE_CHECK(index == rows_.size());
    apply(bodies);
    guard_.after_chord(guarded_, bodies);
}

void JointSystem::project_velocities(JointStore& joints, std::span<SolverBody> bodies) {
    if (rows_.empty()) return;
    list_rows(joints, bodies);
    make_rows();
    factorize();
    guard_.before_projection(guarded_, bodies);
    project(bodies);
    guard_.after_projection(guarded_, bodies);
}

void JointSystem::project(std::span<SolverBody> bodies) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        solution_[i] = 0.0;
        for (std::uint32_t end = 0; end < rows_[i].end_count; ++end) {
            const SolverBody& body = bodies[rows_[i].ends[end].body];
            solution_[i] -= product(rows_[i].ends[end].jacobian,
                                    {double{body.velocity.x}, double{body.velocity.y}, double{body.angular_velocity}});
        }
    }
    apply(bodies);
}

void JointSystem::apply(std::span<SolverBody> bodies) {
    factor_.solve(solution_);
    for (std::size_t i = 0; i < rows_.size(); ++i) *rows_[i].impulse += static_cast<float>(solution_[i]);
    add_solution(bodies);
}

// Adds the impulses up for each body before they change its velocity: those of the two joints of a taut link almost
// cancel.
void JointSystem::add_solution(std::span<SolverBody> bodies) {
    for (const std::uint32_t body : pattern_.bodies) changes_[body] = {};
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (std::uint32_t end = 0; end < rows_[i].end_count; ++end) {
            const End& one = rows_[i].ends[end];
            for (std::size_t k = 0; k < 3; ++k) changes_[one.body][k] += one.response[k] * solution_[i];
        }
    for (const std::uint32_t index : pattern_.bodies) {
        SolverBody& body = bodies[index];
        const Motion& change = changes_[index];
        body.velocity = {static_cast<float>(double{body.velocity.x} + change[0]),
                         static_cast<float>(double{body.velocity.y} + change[1])};
        body.angular_velocity = static_cast<float>(double{body.angular_velocity} + change[2]);
    }
}

std::size_t JointSystem::bytes() const {
    return pattern_.bytes() + factor_.bytes() + guard_.bytes() + rows_.capacity() * sizeof(Row) +
           loads_.capacity() * sizeof(Load) + changes_.capacity() * sizeof(Motion) +
           listed_.capacity() * sizeof(EqualityRow) + driven_.capacity() * sizeof(std::uint32_t) +
           guarded_.capacity() * sizeof(GuardedBody) + predicted_.capacity() * sizeof(SolverBody) +
           (entries_.capacity() + diagonal_.capacity() + solution_.capacity()) * sizeof(double);
}

}  // namespace tumble
