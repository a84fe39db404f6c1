#include "tools/run/replay_output.hpp"

#include <algorithm>
#include <utility>

#include "tools/claims/claim_marks.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"

namespace tumble::tools {

namespace {

// Opens the file if the replay is not too long.
OutputFile open_replay(const SceneWorld& built, const RunOptions& options, std::uint64_t steps) {
    const std::uint64_t bodies = std::max<std::uint64_t>(built.world.bodies().size(), 1);
    if (steps >= kMostReplayPoses / bodies)
        throw CLI::ValidationError("--replay", "a replay has at most " + std::to_string(kMostReplayPoses) +
                                                   " poses; these are " + std::to_string(bodies) + " bodies in " +
                                                   std::to_string(steps) + " steps: shorten the --duration to " +
                                                   std::to_string(kMostReplayPoses / bodies - 1) + " steps");
    return open_output(options.replay, options.force);
}

}  // namespace

ReplayOutput::ReplayOutput(const Scene& scene, const SceneWorld& built, const RunOptions& options, std::uint64_t steps)
    : scene_(scene),
      file_(open_replay(built, options, steps)),
      recorder_(scene, {make_camera(scene, built, options.size.aspect_ratio()), !options.no_replay_contacts}),
      watch_(scene, built) {}

void ReplayOutput::record(const SceneWorld& built) {
    recorder_.record(built);
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
        claims.push_back({results[i].claim, results[i].finding, results[i].passed, results[i].step,
                          std::move(marks.regions), std::move(marks.bodies)});
    }
    return claims;
}

std::uint64_t ReplayOutput::finish(const SceneWorld& built, bool complete) {
    if (!recorder_.is_whole())
        report_warning("the replay ends before the run: it has at most " + std::to_string(kMostReplayPoses) + " poses");
    file_.write(recorder_.page(claims(built), complete));
    return file_.commit();
}

}  // namespace tumble::tools
