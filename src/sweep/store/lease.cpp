#include "sweep/store/lease.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <cstdint>
#include <random>
#include <sstream>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble::sweep {

namespace fs = std::filesystem;

namespace {

// A text of the system, empty if there is none.
std::string system_text(const fs::path& file) {
    try {
        return read_file(file, 4096);
    } catch (const FileError&) {
        return {};
    }
}

std::string first_word(const std::string& text) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    return word;
}

// The start of the system and the namespace of process numbers: processes of other hosts and containers have numbers
// that mean nothing here.
std::string system_identity() {
    std::error_code error;
    return first_word(system_text("/proc/sys/kernel/random/boot_id")) + "/" +
           fs::read_symlink("/proc/self/ns/pid", error).string();
}

std::string random_nonce() {
    std::random_device random;
    const std::uint64_t number = std::uint64_t{random()} << 32 | random();
    return std::to_string(number);
}

// When a process started, so that a later process of the same number is not mistaken for it: the 22nd word of its
// status, the 20th after the name in brackets. Empty if there is no such process.
std::string process_start(const std::string& process) {
    const std::string status = system_text("/proc/" + process + "/stat");
    const std::size_t name_end = status.rfind(')');
    if (name_end == std::string::npos) return {};
    std::istringstream words(status.substr(name_end + 1));
    std::string word;
    for (int i = 0; i < 20; ++i) words >> word;
    return word;
}

std::string own_text(const std::string& nonce) {
    const std::string process = std::to_string(::getpid());
    return system_identity() + " " + process + " " + process_start(process) + " " + nonce + "\n";
}

bool has_ended(const fs::path& lease) {
    std::istringstream words(system_text(lease));
    std::string system, process, start;
    words >> system >> process >> start;
    return !start.empty() && system == system_identity() && process_start(process) != start;
}

}  // namespace

Leases::Leases(const fs::path& sweep_folder, std::chrono::milliseconds term)
    : folder_(sweep_folder / "leases"), nonce_(random_nonce()), text_(own_text(nonce_)), term_(term) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw FileError(folder_, "cannot create the folder: " + error.message());
    renewal_ = std::jthread([this](const std::stop_token& stop) { renew(stop); });
}

Leases::~Leases() {
    renewal_.request_stop();
    renewal_.join();
    std::error_code ignored;
    for (const std::string& name : held_)
        if (is_own(name)) fs::remove(folder_ / name, ignored);
}

bool Leases::is_own(const std::string& name) const { return system_text(folder_ / name) == text_; }

// Linking a file with its text gives it its text at once, and fails if there is one.
bool Leases::make(const std::string& name) const {
    const fs::path file = folder_ / name, own = folder_ / (name + ".new-" + nonce_);
    const int descriptor = ::open(own.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == ENOENT) return false;  // another process has completed the sweep
    if (descriptor < 0) throw FileError(file, "cannot write: " + std::generic_category().message(errno));
    const bool is_written = ::write(descriptor, text_.data(), text_.size()) == static_cast<ssize_t>(text_.size());
    int error = is_written ? 0 : errno;
    ::close(descriptor);
    if (is_written && ::link(own.c_str(), file.c_str()) != 0) error = errno;
    ::unlink(own.c_str());
    if (error != 0 && error != EEXIST && error != ENOENT)
        throw FileError(file, "cannot write: " + std::generic_category().message(error));
    return error == 0;
}

bool Leases::is_abandoned(const fs::path& file, const std::string& name) {
    if (has_ended(file)) return true;
    std::error_code error;
    const fs::file_time_type touched = fs::last_write_time(file, error);
    if (error) return false;  // it has just been released
    const auto now = std::chrono::steady_clock::now();
    const auto [seen, is_new] = others_.try_emplace(name, Seen{touched, now});
    if (!is_new && seen->second.touched != touched) seen->second = {touched, now};
    return now - seen->second.since > term_;
}

bool Leases::take(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const fs::path file = folder_ / name;
    if (held_.contains(name)) return false;  // another thread has it
    if (!make(name)) {
        if (!is_abandoned(file, name)) return false;
        // Of several processes that take it over, renaming succeeds in one.
        const fs::path old = folder_ / (name + ".old-" + nonce_);
        std::error_code error;
        fs::rename(file, old, error);
        if (error) return false;
        fs::remove(old, error);
        if (!make(name)) return false;
    }
    others_.erase(name);
    held_.insert(name);
    return true;
}

void Leases::release(const std::string& name) {
    const std::lock_guard lock(mutex_);
    std::error_code ignored;
    if (held_.erase(name) > 0 && is_own(name)) fs::remove(folder_ / name, ignored);
}

bool Leases::holds(const std::string& name) {
    const std::lock_guard lock(mutex_);
    return held_.contains(name) && is_own(name);
}

bool Leases::has_folder() const { return fs::exists(folder_); }

void Leases::remove_folder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void Leases::renew(const std::stop_token& stop) {
    std::mutex sleep;
    std::condition_variable_any wake;
    std::unique_lock sleeping(sleep);
    while (!wake.wait_for(sleeping, stop, term_ / 4, [&] { return stop.stop_requested(); })) {
        const std::lock_guard lock(mutex_);
        for (const std::string& name : held_)
            if (is_own(name)) ::utimensat(AT_FDCWD, (folder_ / name).c_str(), nullptr, 0);
    }
}

}  // namespace tumble::sweep
