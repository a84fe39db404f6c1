// Decides in which states a claim is evaluated, and which state decides it: the worst one of a claim that must always
// hold, the best one of a claim that must hold sometime. The finding is that of the deciding state, so that a report
// shows how near the claim was to failing or holding.
#include <bit>
#include <limits>
#include <memory>

#include "debug/check.hpp"
#include "scene/claims/claims.hpp"
#include "scene/model/names.hpp"
#include "scene/model/saved_bytes.hpp"
#include "scene/model/step_time.hpp"
#include "tumble/scene_run.hpp"

namespace tumble {

namespace {

constexpr std::uint64_t kMagic = 0x32'54'41'57'4c'42'4d'54;  // "TMBLWAT2"
constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

// Claims on a state have a `when`; the moment of all others is fixed.
SceneMoment moment_of(const SceneExpectation& claim) {
    if (claim.at_rest_by || claim.max_penetration || claim.max_joint_error || claim.max_energy_gain ||
        !claim.never_touches.empty())
        return SceneMoment::always;
    if (!claim.touches.empty()) return SceneMoment::sometime;
    return claim.when;
}

struct Watched {
    std::unique_ptr<scene::Claim> claim;
    std::string text;
    SceneMoment moment = SceneMoment::end;
    bool is_decided = true;
    std::uint64_t from = 0;       // the first step that counts
    std::uint64_t to = kForever;  // the last one
    bool reached = false;         // whether the run has had a step that counts
    bool seen = false;            // whether the claim applied to one of them
    double excess = 0.0;          // of the state that decides so far
    double severity = 0.0;
    std::string finding;
    std::string state_hash;
    std::uint64_t step = 0;

    std::string finding_text() const {
        if (seen) return finding;
        return reached ? "no copy ever exists" : "the run ends before that";
    }

    // Whether a new state decides in place of the one that decides so far.
    bool decides(double new_excess, double new_severity) const {
        if (!seen || moment == SceneMoment::end) return true;
        const bool is_worse = new_excess > excess || (new_excess == excess && new_severity > severity);
        const bool is_better = new_excess < excess;
        return moment == SceneMoment::always ? is_worse : is_better;
    }
};

void save_to(scene::SaveWriter& writer, const Watched& watched) {
    writer.text(watched.text);
    writer.number((watched.reached ? 1u : 0u) | (watched.seen ? 2u : 0u));
    writer.number(std::bit_cast<std::uint64_t>(watched.excess));
    writer.number(std::bit_cast<std::uint64_t>(watched.severity));
    writer.number(watched.step);
    writer.text(watched.finding);
    writer.text(watched.state_hash);
    const std::vector<std::uint64_t> state = watched.claim->state();
    writer.number(state.size());
    for (const std::uint64_t number : state) writer.number(number);
}

void load_from(scene::SaveReader& reader, Watched& watched) {
    const bool is_same = reader.text() == watched.text;
    const std::uint64_t flags = reader.number();
    watched.reached = (flags & 1u) != 0;
    watched.seen = (flags & 2u) != 0;
    watched.excess = std::bit_cast<double>(reader.number());
    watched.severity = std::bit_cast<double>(reader.number());
    watched.step = reader.number();
    watched.finding = reader.text();
    watched.state_hash = reader.text();
    std::vector<std::uint64_t> state(reader.count(sizeof(std::uint64_t)));
    for (std::uint64_t& number : state) number = reader.number();
    if (!is_same || !watched.claim->set_state(state))
        throw SnapshotError("the saved claims are those of another scene");
}

}  // namespace

struct ExpectationWatch::Impl {
    void observe(const SceneWorld& built, bool may_be_end);

    std::vector<Watched> watched;  // [scene.expect.size()]
    double rate = 0.0;             // steps/s
    std::uint64_t last_step = 0;
};

ExpectationWatch::ExpectationWatch(const Scene& scene, const SceneWorld& built) : impl_(std::make_unique<Impl>()) {
    const double rate = double{built.world.def().steps_per_second};
    impl_->rate = rate;
    const scene::BodyNames bodies(scene);
    const scene::JointNames joints(scene);
    const scene::KnownNames names{scene, bodies, joints};
    for (const SceneExpectation& expectation : scene.expect) {
        Watched& watched = impl_->watched.emplace_back();
        watched.claim = scene::make_claim(expectation, names, built);
        watched.text = scene::claim_text(expectation);
        watched.moment = moment_of(expectation);
        watched.is_decided = scene::is_decided_by_watch(expectation);
        if (expectation.from) watched.from = scene::first_step_at(*expectation.from, rate);
        if (expectation.until) watched.to = scene::first_step_at(*expectation.until, rate);
        if (expectation.at_rest_by) watched.from = scene::first_step_at(*expectation.at_rest_by, rate);
        if (expectation.at) watched.from = watched.to = scene::first_step_at(*expectation.at, rate);
    }
}

ExpectationWatch::~ExpectationWatch() = default;
ExpectationWatch::ExpectationWatch(ExpectationWatch&&) noexcept = default;
ExpectationWatch& ExpectationWatch::operator=(ExpectationWatch&&) noexcept = default;

void ExpectationWatch::observe(const SceneWorld& built) { impl_->observe(built, true); }
void ExpectationWatch::observe_before_end(const SceneWorld& built) { impl_->observe(built, false); }

void ExpectationWatch::Impl::observe(const SceneWorld& built, bool may_be_end) {
    const std::uint64_t step = built.world.step_count();
    TUMBLE_CHECK(step >= last_step);
    last_step = step;
    for (Watched& claim : watched) {
        claim.claim->follow(built);
        const bool is_on_end = claim.moment == SceneMoment::end && claim.to == kForever;
        if (is_on_end && !may_be_end) continue;
        if (step < claim.from || step > claim.to) continue;
        claim.reached = true;
        if (!claim.claim->applies()) continue;
        const double excess = claim.claim->excess(built), severity = claim.claim->severity();
        if (!claim.decides(excess, severity)) continue;
        claim.seen = true;
        claim.excess = excess;
        claim.severity = severity;
        claim.finding = claim.claim->finding(built);
        claim.state_hash = claim.claim->state_hash();
        claim.step = step;
    }
}

std::vector<ExpectationResult> ExpectationWatch::results() const {
    std::vector<ExpectationResult> results;
    for (const Watched& watched : impl_->watched) {
        const bool passed = watched.seen && watched.excess == 0.0;
        const std::uint64_t step = watched.seen ? watched.step : impl_->last_step;
        results.push_back({passed, watched.text, watched.finding_text(), step, static_cast<double>(step) / impl_->rate,
                           watched.state_hash, watched.is_decided});
    }
    return results;
}

std::vector<std::byte> ExpectationWatch::save() const {
    scene::SaveWriter writer;
    writer.number(kMagic);
    writer.number(impl_->last_step);
    writer.number(impl_->watched.size());
    for (const Watched& watched : impl_->watched) save_to(writer, watched);
    return writer.finish();
}

ExpectationWatch ExpectationWatch::load(const Scene& scene, const SceneWorld& start, std::span<const std::byte> saved) {
    scene::SaveReader reader(saved, "state of claims");
    if (reader.number() != kMagic) throw SnapshotError("these bytes are no saved claims of this version");
    ExpectationWatch watch(scene, start);
    watch.impl_->last_step = reader.number();
    if (reader.number() != watch.impl_->watched.size())
        throw SnapshotError("the saved claims are those of another scene");
    for (Watched& watched : watch.impl_->watched) load_from(reader, watched);
    reader.finish();
    return watch;
}

}  // namespace tumble
