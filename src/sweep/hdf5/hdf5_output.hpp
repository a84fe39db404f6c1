// An HDF5 file while it is written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "sweep/hdf5/hdf5_handle.hpp"
#include "tumble/file.hpp"

namespace tumble::sweep {

// Like OutputFile: the file is there when commit() returns, or not at all. HDF5 writes to the temporary file as the
// data comes, so that memory does not grow with it. No times are stored: the same calls give the same bytes. To be
// made, used and destroyed under an Hdf5Lock.
class Hdf5Output {
public:
    // Throws FileError, as all functions do.
    explicit Hdf5Output(const std::filesystem::path& file);

    hid_t id() const noexcept { return id_; }
    const std::filesystem::path& temporary() const noexcept { return file_.temporary(); }

    // The result of a call of HDF5. Throws FileError if it is negative.
    template <class Result>
    Result required(Result result) const {
        if (result < 0) fail();
        return result;
    }
    Handle required(Handle handle) const {
        required(static_cast<hid_t>(handle));
        return handle;
    }

    // The properties of a data set without times.
    Handle make_properties() const;

    // A data set of the stated sizes, written whole. `stored` is the type of a number in the file, `given` that of
    // `numbers`.
    void write(hid_t group, const std::string& name, std::span<const hsize_t> sizes, hid_t stored, hid_t given,
               const void* numbers) const;

    // Writes what HDF5 keeps, and closes the file, whose handles must be closed. The temporary file is then whole.
    void close();

    // Renames the temporary file. Returns the size in bytes. To be called once, after close().
    std::uint64_t commit();

private:
    [[noreturn]] void fail() const;

    OutputFile file_;
    Handle id_;
};

}  // namespace tumble::sweep
