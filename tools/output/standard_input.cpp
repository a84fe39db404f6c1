#include "tools/output/standard_input.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "tools/output/input_error.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

constexpr const char* kDevice = "/dev/stdin";
constexpr const char* kShownName = "<stdin>";
constexpr std::size_t kMaxSceneBytes = 32 << 20;  // of a scene file
constexpr std::size_t kMaxInputBytes = 1 << 30;   // it is kept in memory

}  // namespace

bool is_standard_input(const std::filesystem::path& file) { return file == "-" || file == kDevice; }

const std::string& standard_input() {
    static const std::string text = [] {
        std::string bytes = read_file(kDevice, kMaxInputBytes);
        if (bytes.size() > kMaxInputBytes) throw InputError("standard input is longer than 1 GiB; name a file instead");
        return bytes;
    }();
    return text;
}

std::unique_ptr<std::istream> open_input(const std::filesystem::path& file) {
    if (is_standard_input(file)) return std::make_unique<std::istringstream>(standard_input());
    auto stream = std::make_unique<std::ifstream>(file);
    if (!*stream) throw FileError(file, std::strerror(errno));
    return stream;
}

std::string read_input(const std::filesystem::path& file) {
    return is_standard_input(file) ? standard_input() : read_file(file);
}

Scene load_scene_input(const std::filesystem::path& file, const LoadOptions& options,
                       std::vector<Diagnostic>* warnings) {
    if (!is_standard_input(file)) return load_scene(file, options, warnings);
    LoadOptions from_input = options;
    from_input.read_included = [](const std::filesystem::path& included) {
        return included == kShownName ? standard_input() : read_file(included, kMaxSceneBytes);
    };
    return load_scene(kShownName, from_input, warnings);
}

}  // namespace tumble::tools
