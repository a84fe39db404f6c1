// Lease files: which process writes which shard, also on a shared file system.
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

// The leases of one process in the folder DIR/leases. A lease is a file that only one process can make; its text names
// that process. The process renews the file's time each quarter of the term. Another process takes the lease over when
// the time has not changed for a whole term, or when the owner is known to have ended.
class Leases {
public:
    Leases(const std::filesystem::path& sweep_folder, std::chrono::milliseconds term);
    ~Leases();  // releases all
    Leases(const Leases&) = delete;
    Leases& operator=(const Leases&) = delete;

    // False if another process has it. Throws FileError.
    bool take(const std::string& name);

    // Leaves a lease that another process has taken over.
    void release(const std::string& name);

    // Whether a lease that was taken is still that of this process: not if its term has ended meanwhile.
    bool holds(const std::string& name);

    bool has_folder() const;

    // Removes the folder with all leases.
    void remove_folder();

private:
    // What was seen of the lease of another process, and when by the clock of this one: clocks of hosts differ.
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
    std::string text_;   // of the leases of this object
    std::chrono::milliseconds term_;
    std::mutex mutex_;
    std::set<std::string> held_;
    std::map<std::string, Seen> others_;
    std::jthread renewal_;
};

}  // namespace tumble::sweep
