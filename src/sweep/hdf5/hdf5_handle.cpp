#include "sweep/hdf5/hdf5_handle.hpp"

#include <cerrno>

namespace tumble::sweep {

namespace {

std::mutex library_mutex;

}  // namespace

Hdf5Lock::Hdf5Lock() : lock_(library_mutex) {
    // A file that could not be closed, as on a full disk, is still listed: at exit the library would close it once
    // more, and crash. All that is open closes itself before.
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    errno = 0;
}

}  // namespace tumble::sweep
