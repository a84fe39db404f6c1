#include "tools/sweep/sweep_work.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#include "sweep/store/durable.hpp"
#include "sweep/store/lease.hpp"
#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/machine/build_info.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/output/input_error.hpp"
#include "tools/sweep/crash_log.hpp"
#include "tools/sweep/runs/frame_recorder.hpp"
#include "tools/sweep/runs/run_table.hpp"
#include "tools/sweep/shard_writer.hpp"
#include "tools/sweep/verification.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostShards = 10000000;
// Between looks at what other processes do: doubled from the shortest to the longest.
constexpr std::chrono::milliseconds kShortestWait{100}, kLongestWait{5000};
constexpr const char* kFinish = "finish";
constexpr const char* kAppend = "append";

sweep::SweepHeader expected_header(const sweep::Plan& plan) {
    return {plan.hash,
            plan.runs,
            runs_in_shard(plan),
            version(),
            table_header(plan),
            plan.allow_outside ? "" : plan.file.filename().string(),
            frame_software(plan.write)};
}

std::string difference_text(const sweep::SweepHeader& found, const sweep::SweepHeader& wanted) {
    if (found.version != wanted.version) return "has a sweep of version " + found.version + " of tumble";
    if (found.frame_software != wanted.frame_software)
        return "has a sweep with frames of " + found.frame_software + ", and this machine draws by " +
               wanted.frame_software;
    return "has another sweep: the plan, the name of its file, its scenes, --runs or --allow-outside differ";
}

// Creates the folder, or refuses one of something else.
void open_folder(const sweep::Plan& plan, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder: " + error.message());
    const sweep::Manifest manifest = sweep::read_manifest(folder);
    const sweep::SweepHeader header = expected_header(plan);
    if (manifest.header && !(*manifest.header == header))
        throw FileError(folder, difference_text(*manifest.header, header) + "; choose another folder");
    if (manifest.header) return;
    if (manifest.damaged_lines > 0 && fs::exists(sweep::table_file(folder)))
        throw FileError(sweep::manifest_file(folder),
                        "the first line is damaged; remove runs.csv, and the sweep makes all its files again");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().filename() != "leases" && entry.path() != copies_in(folder) &&
            entry.path() != sweep::manifest_file(folder) && !entry.path().filename().string().starts_with("shard-"))
            throw FileError(folder, "is not empty, and has no sweep");
    append_header(folder, header);
}

// The runs of the shards of a part.
std::uint64_t runs_of_part(const sweep::Plan& plan, const SweepOptions& options) {
    const std::uint64_t shards = shard_count(plan), last = shards - 1;
    if (options.part >= shards) return 0;
    const std::uint64_t count = (last - options.part) / options.parts + 1;
    const std::uint64_t beyond = last % options.parts == options.part ? shards * runs_in_shard(plan) - plan.runs : 0;
    return count * runs_in_shard(plan) - beyond;
}

// The threads of a process take shards from it.
class Work {
public:
    Work(const sweep::Plan& plan, const SweepOptions& options)
        : plan_(plan),
          options_(options),
          leases_(options.folder, std::chrono::milliseconds(static_cast<std::int64_t>(options.lease * 1e3))),
          crash_log_(options.folder),
          texts_(plan, options.folder),
          part_runs_(runs_of_part(plan, options)),
          progress_("runs", part_runs_) {
        texts_.restore(sweep::read_manifest(options.folder).copies);
        look();
        done_runs_ = part_runs_ - std::min(part_runs_, missing_.size() * runs_in_shard(plan_));
    }

    void run();
    bool finish();
    std::uint64_t simulated_runs() const { return simulated_runs_; }

    // How many shards of this part are missing now.
    std::uint64_t count_missing();

private:
    void look();
    void work();
    std::optional<std::uint64_t> take();
    bool wait_for_others(std::chrono::milliseconds& wait);
    void append(sweep::ShardEntry entry);
    void count_run();

    const sweep::Plan& plan_;
    const SweepOptions& options_;
    sweep::Leases leases_;
    CrashLog crash_log_;
    SceneTexts texts_;
    std::mutex mutex_;
    std::set<std::uint64_t> missing_;  // of this part, and not taken by a thread
    std::set<std::uint64_t> taken_;    // by threads of this process
    std::uint64_t part_runs_ = 0;      // of the shards of this part
    std::uint64_t done_runs_ = 0;      // of these, complete before this process began
    std::atomic<std::uint64_t> simulated_runs_{0};
    std::atomic<bool> is_stopped_{false};
    std::exception_ptr error_;
    Progress progress_;
};

std::string lease_name(std::uint64_t shard) { return sweep::shard_file_name(shard, ""); }

// Finds out what is missing. With mutex_, or before the threads.
void Work::look() {
    missing_.clear();
    for (const auto& [first, last] : missing_shards(options_.folder, sweep::read_manifest(options_.folder)))
        for (std::uint64_t shard = first; shard <= last; ++shard)
            if (shard % options_.parts == options_.part && !taken_.contains(shard)) missing_.insert(shard);
}

std::uint64_t Work::count_missing() {
    const std::lock_guard lock(mutex_);
    look();
    return missing_.size();
}

// Whether another process has completed a shard, or the whole sweep. The manifest of a complete sweep is written before
// the files of its shards are removed: if a file has gone since the manifest was read, the second look finds it.
bool is_done(const fs::path& folder, std::uint64_t shard) {
    const bool may_be_stored =
        fs::exists(folder / sweep::shard_file_name(shard, ".csv")) || fs::exists(sweep::table_file(folder));
    const auto look = [&] { return is_stored(folder, sweep::read_manifest(folder), shard); };
    return may_be_stored && (look() || look());
}

// A shard for a thread, with its lease; nothing if other processes have all that are missing.
std::optional<std::uint64_t> Work::take() {
    const std::lock_guard lock(mutex_);
    for (auto it = missing_.begin(); it != missing_.end();) {
        const std::uint64_t shard = *it;
        if (!leases_.take(lease_name(shard))) {
            ++it;
            continue;
        }
        it = missing_.erase(it);
        if (is_done(options_.folder, shard)) {
            leases_.release(lease_name(shard));
            continue;
        }
        taken_.insert(shard);
        return shard;
    }
    return std::nullopt;
}

// False if nothing is left that other processes could be writing, or could have left.
bool Work::wait_for_others(std::chrono::milliseconds& wait) {
    if (count_missing() == 0) return false;
    std::this_thread::sleep_for(wait);
    wait = std::min(2 * wait, kLongestWait);
    return true;
}

// Under a lease, because on NFS processes of two hosts that append at once overwrite each other. With mutex_.
void Work::append(sweep::ShardEntry entry) {
    while (!leases_.take(kAppend)) {
        if (!leases_.has_folder()) return;  // another process has done it all, and removed the leases
        if (is_interrupted()) throw Interrupted{};
        std::this_thread::sleep_for(kShortestWait / 10);
    }
    sweep::make_durable(options_.folder);  // the names of the shard's files
    entry.copies = texts_.unstated();
    append_shard(options_.folder, entry);
    texts_.note_stated(entry.copies.size());
    leases_.release(kAppend);
}

void Work::count_run() {
    if (is_stopped_ || is_interrupted()) throw Interrupted{};
    const std::uint64_t done = done_runs_ + ++simulated_runs_;
    const std::lock_guard lock(mutex_);
    progress_.show(done);
}

void Work::work() {
    const HandlerStack stack;
    RunMaker runs(plan_, texts_);
    std::chrono::milliseconds wait = kShortestWait;
    while (!is_stopped_ && !is_interrupted()) {
        const std::optional<std::uint64_t> shard = take();
        if (!shard && !wait_for_others(wait)) return;
        if (!shard) continue;
        wait = kShortestWait;
        const ShardCalls calls{.count_run = [this] { count_run(); },
                               .may_commit = [&] { return leases_.holds(lease_name(*shard)); },
                               .crashed = CrashLog::runs_to_skip(options_.folder)};
        const std::optional<sweep::ShardEntry> entry = write_shard(plan_, *shard, options_.folder, runs, calls);
        const std::lock_guard lock(mutex_);
        if (entry) append(*entry);
        taken_.erase(*shard);
        leases_.release(lease_name(*shard));
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
        if (is_complete(options_.folder, manifest) && !leases_.has_folder()) return true;
        if (leases_.take(kFinish)) {
            complete_folder(options_.folder);
            leases_.release(kFinish);
            leases_.remove_folder();
            return true;
        }
        std::this_thread::sleep_for(kShortestWait);
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
    if (options.check) remove_damaged_files(options.folder);
    SweepReport report{.runs = plan.runs, .shards = shard_count(plan)};
    {
        Work work(plan, options);
        work.run();
        if (options.parts == 1 && !is_interrupted()) work.finish();
        report.simulated_runs = work.simulated_runs();
        report.missing_of_part = work.count_missing();
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
