#include "tools/run/replay_output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/claims/claim_marks.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

void require_replay(const SceneWorld& built, std::uint64_t steps) {
    const std::uint64_t bodies = std::max<std::uint64_t>(built.world.bodies().size(), 1);
    const std::uint64_t most_steps = kMostReplayPoses / bodies - 1;  // one state more than steps
    if (steps <= most_steps) return;
    const double rate = built.world.def().steps_per_second;
    const double most_seconds = std::floor(static_cast<double>(most_steps) / rate * 100.0) / 100.0;
    std::string text = "a replay has at most " + std::to_string(kMostReplayPoses / 1'000'000) +
                       " million poses, one for each body and step: with the " + std::to_string(bodies) +
                       " bodies of this scene, the --duration may be at most ";
    append_number(text, most_seconds);
    append_number(text += " s; it is ", static_cast<double>(steps) / rate);
    throw CLI::ValidationError("--replay", text + " s");
}

ReplayOutput::ReplayOutput(const Scene& scene, const SceneWorld& built, const RunOptions& options)
    : scene_(scene),
      aspect_ratio_(options.size.aspect_ratio()),
      camera_(make_camera(scene, built, aspect_ratio_)),
      file_(open_output(options.replay, options.force)),
      recorder_(
          scene,
          {.aspect_ratio = aspect_ratio_, .contacts = !options.no_replay_contacts, .theme = options.overlay.theme}),
      watch_(scene, built) {}

void ReplayOutput::record(const SceneWorld& built) {
    camera_ = move_camera(camera_, scene_, built);
    recorder_.record(built, apply_camera_keys(camera_, scene_, built, aspect_ratio_));
    watch_.observe(built);
}

std::vector<ReplayClaim> ReplayOutput::claims(const SceneWorld& built) const {
    const std::vector<ExpectationResult> results = watch_.results();
    std::vector<ReplayClaim> claims;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SceneExpectation& expected = scene_.expect[i];
        Marking marks = marks_of(expected, results[i], built);
        // These claims mark the bodies that violate them in the world given, which is the last one.
        if (expected.max_penetration || expected.at_rest_by) marks.bodies.clear();
        claims.push_back({results[i], std::move(marks)});
    }
    return claims;
}

std::uint64_t ReplayOutput::finish(const SceneWorld& built, bool complete) {
    if (!recorder_.is_whole())
        report_warning("the replay ends before the run: it has at most " +
                       std::to_string(kMostReplayPoses / 1'000'000) + " million poses and " +
                       std::to_string(kMostReplayContactPoints / 1'000'000) +
                       " million contact points; lower --duration, or leave out contacts by --no-replay-contacts");
    file_.write(recorder_.page(claims(built), complete));
    return file_.commit();
}

}  // namespace tumble::tools
