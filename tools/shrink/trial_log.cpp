#include "tools/shrink/trial_log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#ifndef __clang_analyzer__
#define XXH_INLINE_ALL
#endif
#include <xxhash.h>

#include <cerrno>
#include <sstream>
#include <system_error>

#include "tools/cli/output_path.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

constexpr const char* kTitle = "tumble shrink 1 ";  // with the version of the format of this file

constexpr std::size_t kMostBytes = 1 << 30;  // of a log: thirty million results

std::string header_of(std::uint64_t task) { return kTitle + to_hex(task) + "\n"; }

std::string text_of(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return "";
    std::string text = read_file(file, kMostBytes);
    if (text.size() > kMostBytes) throw FileError(file, "is longer than 1 GiB");
    return text;
}

}  // namespace

std::uint64_t hash_of(std::string_view text) { return XXH64(text.data(), text.size(), 0); }

bool TrialLog::exists(const std::filesystem::path& file, std::uint64_t task) {
    return text_of(file).starts_with(header_of(task));
}

TrialLog::TrialLog(const std::filesystem::path& file, std::uint64_t task, bool replace) : file_(file) {
    create_folder_of(file);
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw FileError(file, std::generic_category().message(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw FileError(file, "another process is shrinking into this file");
    }
    std::string text = text_of(file);
    const bool is_ours = text.starts_with(header_of(task));
    if (replace || text.empty()) {
        if (::ftruncate(descriptor_, 0) == 0) text.clear();
        write_line(header_of(task));
    } else if (!is_ours) {
        ::close(descriptor_);
        throw FileError(
            file, "is the log of another scene, other options or another build; --force starts from the beginning");
    }
    // A line that was cut off counts as absent.
    if (!text.empty() && !text.ends_with('\n')) write_line("\n");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::uint64_t candidate = 0;
        Result result;
        std::string word, end;
        if (!(words >> std::hex >> candidate >> word >> std::dec >> result.step >> end) || end != ".") continue;
        result.fails = word == "fails";
        results_[candidate] = result;
    }
}

TrialLog::~TrialLog() { ::close(descriptor_); }

std::optional<TrialLog::Result> TrialLog::find(std::uint64_t candidate) const {
    const auto found = results_.find(candidate);
    return found == results_.end() ? std::nullopt : std::optional(found->second);
}

void TrialLog::add(std::uint64_t candidate, const Result& result) {
    results_[candidate] = result;
    write_line(to_hex(candidate) + (result.fails ? " fails " : " other ") + std::to_string(result.step) + " .\n");
}

void TrialLog::write_line(const std::string& line) const {
    if (::write(descriptor_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        throw FileError(file_, std::generic_category().message(errno));
}

}  // namespace tumble::tools
