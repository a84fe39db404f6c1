// Parity over a running scene: the pairs that the broad phase passes to the narrow phase.
#include <algorithm>
#include <chrono>

#include "reference/parity/parallel_blocks.hpp"
#include "reference/parity/parity_block.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::reference {

namespace {

constexpr std::size_t kBlockQueries = 256;

std::vector<PairQuery> candidate_queries(const World& world) {
    std::vector<PairQuery> queries;
    for (const ShapePair& pair : world.candidate_pairs())
        queries.push_back({world.shape(pair.a), world.shape(pair.b), world.state(world.body(pair.a)).pose,
                           world.state(world.body(pair.b)).pose});
    return queries;
}

void compare_step(ParityRow& row, const std::vector<PairQuery>& queries, const ParityOptions& options) {
    const std::uint64_t first = row.pairs;
    const auto block_of = [&](std::size_t block) {
        const std::size_t begin = block * kBlockQueries, count = std::min(kBlockQueries, queries.size() - begin);
        return std::span(queries).subspan(begin, count);
    };
    run_blocks<ParityRow>(
        (queries.size() + kBlockQueries - 1) / kBlockQueries, options.threads,
        [&](std::size_t block) { return compare_queries(block_of(block), first + block * kBlockQueries, options); },
        [&](std::size_t, const ParityRow& part) { row.merge(part); });
}

void name_cases(ParityRow& row) {
    for (ParityCase& comparison : row.ours_failures) comparison.family = row.name;
    for (ParityCase& comparison : row.worst_box2d) comparison.family = row.name;
}

}  // namespace

ParityResult run_scene_parity(const Scene& scene, const ParityOptions& options, std::uint64_t steps) {
    const auto start = std::chrono::steady_clock::now();
    if (steps == 0) steps = count_steps(scene);
    SceneRun run(scene);
    ParityResult result;
    result.seed = options.seed;
    ParityRow& row = result.families.emplace_back();
    row.name = scene.name;
    for (std::uint64_t step = 0; step < steps && !run.is_stopped(); ++step) {
        run.step();
        compare_step(row, candidate_queries(run.world()), options);
        if (options.progress) options.progress(row.pairs);
    }
    name_cases(row);
    result.pairs = row.pairs;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace tumble::reference
