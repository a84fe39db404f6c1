#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>

#include "tumble/file.hpp"

namespace tumble {

namespace {

// Reads "1234-5", the process and the number that temporary_name() appends to the name of a file.
std::optional<int> process_of(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos || dash + 1 == text.size()) return std::nullopt;
    int process = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + dash, process);
    const bool is_number = error == std::errc() && end == text.data() + dash && process > 0;
    if (!is_number || text.find_first_not_of("0123456789", dash + 1) != std::string_view::npos) return std::nullopt;
    return process;
}

// Whether an OutputFile has the lock of this file. The system releases the lock when the process ends.
bool is_open_for_output(const std::filesystem::path& path, int process) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const bool is_free = descriptor >= 0 && ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
    const bool is_locked = descriptor >= 0 && !is_free && errno == EWOULDBLOCK;
    if (descriptor >= 0) ::close(descriptor);
    if (is_free || is_locked) return is_locked;
    return process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);  // a file system without locks
}

std::optional<PartialFile> parse_partial(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const std::string whole = std::filesystem::path(name).stem().string();  // without ".partial"
    const std::size_t dot = whole.rfind('.');
    if (path.extension() != ".partial" || dot == std::string::npos || dot == 0) return std::nullopt;
    const std::optional<int> process = process_of(std::string_view(whole).substr(dot + 1));
    if (!process) return std::nullopt;
    return PartialFile{path, path.parent_path() / whole.substr(0, dot), *process, is_open_for_output(path, *process)};
}

}  // namespace

std::vector<PartialFile> find_partial_files(const std::filesystem::path& folder) {
    std::vector<PartialFile> found;
    std::error_code ignored;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder, ignored))
        if (std::optional<PartialFile> partial = parse_partial(entry.path())) found.push_back(std::move(*partial));
    return found;
}

}  // namespace tumble
