// HealthWatch: all checks, the series of the plots, and the slowest steps.
#include <algorithm>
#include <utility>

#include "scene/health/extremes.hpp"
#include "scene/health/health_check.hpp"
#include "scene/model/joint_gap.hpp"
#include "tumble/scene_run.hpp"

namespace tumble {

namespace {

HealthSample sample_of(const scene::HealthView& view) {
    const Energy energy = view.world().energy();
    HealthSample sample{.time = view.world().time(),
                        .kinetic = energy.kinetic,
                        .potential = energy.potential,
                        .work = view.built().work,
                        .momentum = view.world().momentum(),
                        .awake = view.world().counters().awake_bodies,
                        .milliseconds = view.world().counters().ms.step};
    for (const ContactPoint& contact : view.contacts())
        sample.overlap = std::max(sample.overlap, -double{contact.separation});
    for (const SceneJointInstance& joint : view.built().joints)
        if (view.world().is_valid(joint.id))
            sample.joint_error = std::max(sample.joint_error, scene::joint_gap(view.world(), joint.id));
    return sample;
}

// The later of two samples with the larger errors of both.
HealthSample merged_samples(const HealthSample& earlier, HealthSample later) {
    later.overlap = std::max(later.overlap, earlier.overlap);
    later.joint_error = std::max(later.joint_error, earlier.joint_error);
    later.milliseconds = std::max(later.milliseconds, earlier.milliseconds);
    return later;
}

}  // namespace

struct HealthWatch::Impl {
    explicit Impl(const Scene& scene) : view(scene) {
        for (const auto make :
             {scene::make_overlap_check, scene::make_tunnelling_check, scene::make_lost_check, scene::make_jitter_check,
              scene::make_joint_check, scene::make_mass_check, scene::make_sleep_check, scene::make_speed_check,
              scene::make_energy_check, scene::make_size_check, scene::make_spring_check, scene::make_motor_check})
            checks.push_back(make());
    }

    void add_sample(const HealthSample& sample) {
        pending = merged_samples(pending, sample);
        if (++pending_count < stride) return;
        samples.push_back(std::exchange(pending, {}));
        pending_count = 0;
        if (samples.size() < kMostHealthSamples) return;
        for (std::size_t i = 0; i < samples.size() / 2; ++i)
            samples[i] = merged_samples(samples[2 * i], samples[2 * i + 1]);
        samples.resize(samples.size() / 2);
        stride *= 2;
    }

    void add_step(const World& world) {
        if (world.step_count() == 0) return;
        slow_steps.push_back({world.step_count(), world.counters()});
        std::ranges::stable_sort(slow_steps, std::ranges::greater{},
                                 [](const SlowStep& slow) { return slow.counters.ms.step; });
        if (slow_steps.size() > kSlowSteps) slow_steps.pop_back();
    }

    scene::HealthView view;
    std::vector<std::unique_ptr<scene::HealthCheck>> checks;
    scene::Extremes extremes;
    std::vector<HealthSample> samples;
    std::uint64_t stride = 1;  // states in a sample
    std::uint64_t pending_count = 0;
    HealthSample pending;  // of the states after the last sample
    std::vector<SlowStep> slow_steps;
};

HealthWatch::HealthWatch(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
HealthWatch::~HealthWatch() = default;
HealthWatch::HealthWatch(HealthWatch&&) noexcept = default;
HealthWatch& HealthWatch::operator=(HealthWatch&&) noexcept = default;

void HealthWatch::observe(const SceneWorld& built) {
    impl_->view.update(built);
    for (const auto& check : impl_->checks) check->observe(impl_->view);
    impl_->extremes.observe(impl_->view);
    impl_->add_sample(sample_of(impl_->view));
    impl_->add_step(built.world);
}

std::vector<HealthFinding> HealthWatch::findings() const {
    std::vector<HealthFinding> findings;
    if (!impl_->view.has_state()) return findings;
    for (const auto& check : impl_->checks) check->report(impl_->view, findings);
    return findings;
}

std::vector<HealthExtreme> HealthWatch::extremes() const { return impl_->extremes.list(); }

const std::vector<HealthSample>& HealthWatch::samples() const noexcept { return impl_->samples; }
const std::vector<SlowStep>& HealthWatch::slow_steps() const noexcept { return impl_->slow_steps; }

}  // namespace tumble
