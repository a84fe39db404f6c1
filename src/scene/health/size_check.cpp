// Bodies smaller or larger than those for which the constants of the solver are tested.
#include <algorithm>
#include <string>

#include "scene/health/health_check.hpp"
#include "scene/lint/measures.hpp"
#include "scene/model/display.hpp"

namespace tumble::scene {

namespace {

class SizeCheck final : public HealthCheck {
public:
    void observe(const HealthView& view) override {
        for (std::size_t i = 0; i < view.bodies().size(); ++i) {
            const SeenBody& body = view.bodies()[i];
            if (body.exists && body.is_dynamic && !view.was_there(i) && body.largest > 0.0) note(view, i, body.largest);
        }
    }

    void report(const HealthView&, std::vector<HealthFinding>& findings) const override {
        culprits_.append_to(findings);
    }

private:
    void note(const HealthView& view, std::size_t i, double size) {
        const double smallest = view.scale() * kSmallestBody, largest = view.scale() * kLargestBody;
        const double excess = std::max(size / largest, smallest / size);
        const Culprit culprit{{i}, {view.source(i)}};
        if (!(excess > 1.0) || !culprits_.is_worst(culprit, excess)) return;
        culprits_.set(culprit,
                      {.check = "size",
                       .subject = view.name(i),
                       .text = view.name(i) + " is " + brief(size) + " m large: dynamic bodies behave best between " +
                               brief(smallest) + " m and " + brief(largest) + " m",
                       .remedy = "Set the \"scale\" of the world to the size of a typical body.",
                       .step = view.step(),
                       .time = view.world().time(),
                       .bodies = {view.bodies()[i].id},
                       .point = view.bodies()[i].center,
                       .value = size,
                       .limit = size < smallest ? smallest : largest,
                       .unit = "m"});
    }

    Culprits culprits_;
};

}  // namespace

std::unique_ptr<HealthCheck> make_size_check() { return std::make_unique<SizeCheck>(); }

}  // namespace tumble::scene
