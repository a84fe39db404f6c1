#include "sweep/store/durable.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "tumble/file.hpp"

namespace tumble::sweep {

void make_durable(const std::filesystem::path& file_or_folder) {
    const int descriptor = ::open(file_or_folder.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0) ::close(descriptor);
    // A file system that cannot do this for folders says EINVAL.
    if (!is_synced && error != EINVAL)
        throw FileError(file_or_folder, "cannot write: " + std::generic_category().message(error));
}

}  // namespace tumble::sweep
