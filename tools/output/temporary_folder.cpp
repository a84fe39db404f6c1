#include "tools/output/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble::tools {

TemporaryFolder::TemporaryFolder(const std::string& purpose) {
    std::error_code missing;
    std::string name = (std::filesystem::temp_directory_path(missing) / ("tumble-" + purpose + "-XXXXXX")).string();
    if (missing) throw FileError("the folder for temporary files, TMPDIR", missing.message());
    if (::mkdtemp(name.data()) == nullptr)
        throw FileError(name, "cannot create the folder: " + std::generic_category().message(errno));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace tumble::tools
