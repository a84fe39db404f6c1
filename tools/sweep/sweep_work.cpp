#include "tools/sweep/sweep_work.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#include "sweep/store/claim.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/machine/build_info.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/input_error.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/shard_writer.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostShards = 10000000;
constexpr std::chrono::milliseconds kWait{100};  // between looks at what other processes do
constexpr const char* kFinish = "finish";

sweep::SweepHeader expected_header(const sweep::Plan& plan) {
    return {plan.hash, plan.runs, runs_in_shard(plan), version(), table_header(plan)};
}

// Creates the folder, or refuses one of something else.
void open_folder(const sweep::Plan& plan, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder: " + error.message());
    const sweep::Manifest manifest = sweep::read_manifest(folder);
    const sweep::SweepHeader header = expected_header(plan);
    if (manifest.header && !(*manifest.header == header))
        throw FileError(folder, "has another sweep: the plan, its scenes, --runs or the version of tumble (" +
                                    manifest.header->version + ") differ; choose another folder");
    if (manifest.header) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().filename() != "claims" && entry.path() != sweep::manifest_file(folder) &&
            !entry.path().filename().string().starts_with("shard-"))
            throw FileError(folder, "is not empty, and has no sweep");
    append_header(folder, header);
}

// The threads of a process take shards from it.
class Work {
public:
    Work(const sweep::Plan& plan, const SweepOptions& options)
        : plan_(plan),
          options_(options),
          claims_(options.folder, std::chrono::milliseconds(static_cast<std::int64_t>(options.lease * 1e3))),
          progress_("runs", plan.runs) {
        look();
    }

    void run();
    bool finish();
    std::uint64_t simulated_runs() const { return simulated_runs_; }

private:
    void look();
    void work();
    std::optional<std::uint64_t> take();
    bool wait_for_others();
    void count_run();

    const sweep::Plan& plan_;
    const SweepOptions& options_;
    sweep::Claims claims_;
    SceneTexts texts_;
    std::mutex mutex_;
    std::set<std::uint64_t> missing_;  // of this part, and not taken by a thread
    std::set<std::uint64_t> taken_;    // by threads of this process
    std::uint64_t done_runs_ = 0;      // complete before this process began
    std::atomic<std::uint64_t> simulated_runs_{0};
    std::atomic<bool> is_stopped_{false};
    std::exception_ptr error_;
    Progress progress_;
};

std::string claim_name(std::uint64_t shard) { return sweep::shard_file_name(shard, ""); }

// Finds out what is missing. With mutex_, or before the threads.
void Work::look() {
    missing_.clear();
    for (const auto& [first, last] : missing_shards(options_.folder, sweep::read_manifest(options_.folder)))
        for (std::uint64_t shard = first; shard <= last; ++shard)
            if (shard % options_.parts == options_.part && !taken_.contains(shard)) missing_.insert(shard);
    if (simulated_runs_ == 0 && taken_.empty())
        done_runs_ = plan_.runs - std::min(plan_.runs, missing_.size() * runs_in_shard(plan_));
}

// A shard for a thread, claimed; nothing if other processes have all that are missing.
std::optional<std::uint64_t> Work::take() {
    const std::lock_guard lock(mutex_);
    for (auto it = missing_.begin(); it != missing_.end();) {
        const std::uint64_t shard = *it;
        if (!claims_.take(claim_name(shard))) {
            ++it;
            continue;
        }
        it = missing_.erase(it);
        // Another process may have completed it since the manifest was read.
        if (fs::exists(options_.folder / sweep::shard_file_name(shard, ".csv")) &&
            is_stored(options_.folder, sweep::read_manifest(options_.folder), shard)) {
            claims_.release(claim_name(shard));
            continue;
        }
        taken_.insert(shard);
        return shard;
    }
    return std::nullopt;
}

// False if nothing is left that other processes could be writing.
bool Work::wait_for_others() {
    {
        const std::lock_guard lock(mutex_);
        if (missing_.empty()) return false;
    }
    std::this_thread::sleep_for(kWait);
    const std::lock_guard lock(mutex_);
    look();
    return true;
}

void Work::count_run() {
    if (is_stopped_ || is_interrupted()) throw Interrupted{};
    const std::uint64_t done = done_runs_ + ++simulated_runs_;
    const std::lock_guard lock(mutex_);
    progress_.show(done);
}

void Work::work() {
    while (!is_stopped_ && !is_interrupted()) {
        const std::optional<std::uint64_t> shard = take();
        if (!shard && !wait_for_others()) return;
        if (!shard) continue;
        const sweep::ShardEntry entry = write_shard(plan_, *shard, options_.folder, texts_, [this] { count_run(); });
        const std::lock_guard lock(mutex_);
        if (claims_.holds(claim_name(*shard)))
            append_shard(options_.folder, entry);
        else if (is_complete(options_.folder, sweep::read_manifest(options_.folder)))
            fs::remove(options_.folder / entry.table.name);  // another process has done it all, and made the table
        taken_.erase(*shard);
        claims_.release(claim_name(*shard));
    }
}

void Work::run() {
    const auto guarded_work = [this] {
        try {
            work();
        } catch (const Interrupted&) {
            is_stopped_ = true;
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!error_) error_ = std::current_exception();
            is_stopped_ = true;
        }
    };
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < options_.jobs; ++i) others.emplace_back(guarded_work);
        guarded_work();
    }
    if (error_) std::rethrow_exception(error_);
}

// Completes the folder, unless another process does: then waits for it. False if shards are missing.
bool Work::finish() {
    while (!is_interrupted()) {
        const sweep::Manifest manifest = sweep::read_manifest(options_.folder);
        if (!missing_shards(options_.folder, manifest).empty()) return false;
        if (is_complete(options_.folder, manifest) && !claims_.has_folder()) return true;
        if (claims_.take(kFinish)) {
            complete_folder(options_.folder);
            claims_.release(kFinish);
            claims_.remove_folder();
            return true;
        }
        std::this_thread::sleep_for(kWait);
    }
    return false;
}

}  // namespace

SweepReport run_sweep(const sweep::Plan& plan, const SweepOptions& options) {
    if (shard_count(plan) > kMostShards)
        throw InputError("the plan has " + std::to_string(shard_count(plan)) + " shards, and at most " +
                         std::to_string(kMostShards) +
                         " fit into a folder; state a larger \"shard_runs\", or fewer --runs");
    const Stopwatch watch;
    open_folder(plan, options.folder);
    SweepReport report{.runs = plan.runs, .shards = shard_count(plan)};
    {
        Work work(plan, options);
        work.run();
        if (options.parts == 1 && !is_interrupted()) work.finish();
        report.simulated_runs = work.simulated_runs();
    }
    const sweep::Manifest manifest = sweep::read_manifest(options.folder);
    for (const auto& [shard, entry] : manifest.shards)
        for (const auto& [outcome, count] : entry.outcomes) report.outcomes[outcome] += count;
    for (const auto& [first, last] : missing_shards(options.folder, manifest))
        report.missing_shards += last - first + 1;
    report.complete = is_complete(options.folder, manifest);
    report.interrupted = is_interrupted();
    report.seconds = watch.seconds();
    return report;
}

}  // namespace tumble::tools
