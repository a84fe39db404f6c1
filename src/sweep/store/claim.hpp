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
// that process. The process renews the file's time each quarter of the lease. Another process takes the claim over when
// the time has not changed for a whole lease, or when the owner is known to have ended.
class Claims {
public:
    Claims(const std::filesystem::path& sweep_folder, std::chrono::milliseconds lease);
    ~Claims();  // releases all
    Claims(const Claims&) = delete;
    Claims& operator=(const Claims&) = delete;

    // False if another process has it. Throws FileError.
    bool take(const std::string& name);

    // Leaves a claim that another process has taken over.
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
    bool is_own(const std::string& name) const;
    bool is_abandoned(const std::filesystem::path& file, const std::string& name);
    void renew(const std::stop_token& stop);

    std::filesystem::path folder_;
    std::string nonce_;  // no other object has it
    std::string text_;   // of the claims of this object
    std::chrono::milliseconds lease_;
    std::mutex mutex_;
    std::set<std::string> held_;
    std::map<std::string, Seen> others_;
    std::jthread renewal_;
};

}  // namespace tumble::sweep
