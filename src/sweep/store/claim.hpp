// Claim files: which process writes which shard, also on a shared file system.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace tumble::sweep {

// The claims of one process in the folder DIR/claims. A claim is a file that only one process can make; its text names
// that process. Its process
// touches it again and again; if it has not been touched for the time of the lease, or if its process is known to have
// ended, another process takes it over. If two processes come to write one shard, they write the same bytes.
class Claims {
public:
    Claims(const std::filesystem::path& sweep_folder, std::chrono::milliseconds lease);
    ~Claims();  // releases all
    Claims(const Claims&) = delete;
    Claims& operator=(const Claims&) = delete;

    // False if another process has it. Throws FileError.
    bool take(const std::string& name);
    void release(const std::string& name);

    // Whether a claim that was taken is still that of this process: not if its lease has ended meanwhile.
    bool holds(const std::string& name);

    bool has_folder() const;

    // Removes the folder with all claims.
    void remove_folder();

private:
    // What was seen of the claim of another process, and when by the clock of this one: clocks of hosts differ.
    struct Seen {
        std::filesystem::file_time_type touched;
        std::chrono::steady_clock::time_point since;
    };

    bool make(const std::string& name) const;
    bool is_abandoned(const std::filesystem::path& file, const std::string& name);
    void renew(const std::stop_token& stop);

    std::filesystem::path folder_;
    std::string text_;  // of the claims of this process
    std::chrono::milliseconds lease_;
    std::mutex mutex_;
    std::set<std::string> held_;
    std::map<std::string, Seen> others_;
    std::jthread renewal_;
};

}  // namespace tumble::sweep
