#include <filesystem>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble {

namespace {

// Without symbolic links as far as the path exists. What cannot be resolved cannot be opened either.
std::filesystem::path resolve(const std::filesystem::path& path) {
    std::error_code unresolved;
    const std::filesystem::path from_root = std::filesystem::absolute(path.empty() ? "." : path, unresolved);
    const std::filesystem::path resolved = std::filesystem::weakly_canonical(from_root, unresolved);
    return (unresolved ? from_root : resolved).lexically_normal();
}

}  // namespace

bool leads_outside(const std::filesystem::path& folder, const std::filesystem::path& named) {
    const std::filesystem::path path = resolve(folder / named).lexically_relative(resolve(folder));
    return path.empty() || *path.begin() == "..";
}

}  // namespace tumble
