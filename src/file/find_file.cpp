// Looking at files that other files name.
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble {

namespace fs = std::filesystem;

FoundFile find_file(const fs::path& file) {
    const auto unreadable = [](const std::error_code& reason) { return "cannot be read (" + reason.message() + ")"; };
    std::error_code error;
    const fs::file_type type = fs::status(file, error).type();
    if (type == fs::file_type::not_found) return {};
    if (error) return {true, unreadable(error)};
    if (type == fs::file_type::directory) return {true, "is a folder, not a file"};
    if (type != fs::file_type::regular) return {true, "is no regular file"};
    if (access(file.c_str(), R_OK) != 0) return {true, unreadable({errno, std::generic_category()})};
    return {true, ""};
}

bool is_file_there(const fs::path& file) {
    const FoundFile found = find_file(file);
    if (!found.fault.empty()) throw FileError(file, found.fault);
    return found.is_there;
}

}  // namespace tumble
