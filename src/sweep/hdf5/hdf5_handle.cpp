#include "sweep/hdf5/hdf5_handle.hpp"

#include <cerrno>

namespace tumble::sweep {

namespace {

std::mutex library_mutex;

}  // namespace

Hdf5Lock::Hdf5Lock() : lock_(library_mutex) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    errno = 0;
}

}  // namespace tumble::sweep
