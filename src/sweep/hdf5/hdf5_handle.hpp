// Identifiers of HDF5 that close themselves, and the lock of the library.
#pragma once

#include <hdf5.h>

#include <mutex>
#include <utility>

namespace tumble::sweep {

// HDF5 serves one thread at a time: a thread that calls it, or closes a handle, holds this lock. The lock clears errno,
// so that after a failed call errno is the system's reason, or 0. The library prints no messages.
class Hdf5Lock {
public:
    Hdf5Lock();

private:
    std::unique_lock<std::mutex> lock_;
};

// An identifier that is closed by its function; negative if the call that made it failed.
class Handle {
public:
    using Close = herr_t (*)(hid_t);

    Handle() = default;
    Handle(hid_t id, Close with) : id_(id), close_(with) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    ~Handle() { close(); }

    operator hid_t() const noexcept { return id_; }

    // Negative if it fails. An identifier that is closed, or was never valid, is left as it is.
    herr_t close() { return id_ < 0 ? 0 : close_(std::exchange(id_, -1)); }

private:
    hid_t id_ = -1;
    Close close_ = nullptr;
};

}  // namespace tumble::sweep
