#include "tools/sweep/slurm_script.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "tools/cli/shell_word.hpp"
#include "tools/sweep/sweep_folder.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

std::string head(const SlurmOptions& options, const std::string& name) {
    std::string text = "#!/bin/sh\n#SBATCH --job-name=" + name + "\n";
    for (const std::string& setting : options.settings) text += "#SBATCH " + setting + "\n";
    return text;
}

// A job name without characters that Slurm would split.
std::string job_name(const sweep::Plan& plan) {
    std::string name = plan.name;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; }, '_');
    return name;
}

std::string ranges_of(const std::set<std::uint64_t>& numbers) {
    std::string text;
    for (auto it = numbers.begin(); it != numbers.end();) {
        const std::uint64_t first = *it;
        std::uint64_t last = first;
        while (++it != numbers.end() && *it == last + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(first);
        if (last > first) text += "-" + std::to_string(last);
    }
    return text;
}

}  // namespace

std::uint64_t choose_tasks(const sweep::Plan& plan, double seconds) {
    const double wanted = std::ceil(seconds / kSecondsOfTask);
    return static_cast<std::uint64_t>(
        std::clamp(wanted, 1.0, static_cast<double>(std::min(kMostTasks, shard_count(plan)))));
}

std::string missing_tasks(const sweep::Plan& plan, const fs::path& folder, std::uint64_t tasks) {
    const sweep::Manifest manifest = sweep::read_manifest(folder);
    if (!manifest.header) return "0-" + std::to_string(tasks - 1);
    std::set<std::uint64_t> missing;
    for (const auto& [first, last] : missing_shards(folder, manifest))
        for (std::uint64_t shard = first; shard <= last && missing.size() < std::min(tasks, shard_count(plan)); ++shard)
            missing.insert(shard % tasks);
    return ranges_of(missing);
}

std::string slurm_script(const sweep::Plan& plan, const SlurmOptions& options, const std::string& array) {
    return head(options, job_name(plan)) + "#SBATCH --array=" + array +
           "\n#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --output=" + options.folder.string() +
           ".slurm/%a.log\nexec " + shell_word(options.program) + " sweep " +
           shell_word(fs::absolute(plan.file).string()) + " -o " + shell_word(options.folder.string()) + " --runs " +
           std::to_string(plan.runs) + (plan.allow_outside ? " --allow-outside" : "") +
           " --shard \"$SLURM_ARRAY_TASK_ID\"/" + std::to_string(options.tasks) + " -j \"${SLURM_CPUS_PER_TASK:-1}\"\n";
}

std::string merge_script(const sweep::Plan& plan, const SlurmOptions& options) {
    return head(options, job_name(plan) + "-merge") + "#SBATCH --output=" + options.folder.string() +
           ".slurm/merge.log\nexec " + shell_word(options.program) + " sweep merge " +
           shell_word(options.folder.string()) + "\n";
}

}  // namespace tumble::tools
