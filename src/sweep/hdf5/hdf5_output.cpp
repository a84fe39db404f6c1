#include "sweep/hdf5/hdf5_output.hpp"

#include <cerrno>
#include <system_error>

namespace tumble::sweep {

Hdf5Output::Hdf5Output(const std::filesystem::path& file) : file_(file) {
    const Handle access = required(Handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose));
    required(H5Pset_file_locking(access, false, true));  // OutputFile has locked the file
    const Handle creation = required(Handle(H5Pcreate(H5P_FILE_CREATE), H5Pclose));
    required(H5Pset_obj_track_times(creation, false));
    id_ = required(Handle(H5Fcreate(temporary().c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose));
}

Handle Hdf5Output::make_properties() const {
    Handle properties = required(Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose));
    required(H5Pset_obj_track_times(properties, false));
    return properties;
}

void Hdf5Output::write(hid_t group, const std::string& name, std::span<const hsize_t> sizes, hid_t stored, hid_t given,
                       const void* numbers) const {
    const Handle space =
        required(Handle(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose));
    const Handle properties = make_properties();
    Handle data = required(
        Handle(H5Dcreate2(group, name.c_str(), stored, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose));
    required(H5Dwrite(data, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers));
    required(data.close());
}

void Hdf5Output::close() {
    required(H5Fflush(id_, H5F_SCOPE_GLOBAL));
    required(id_.close());
}

std::uint64_t Hdf5Output::commit() {
    file_.take_from_others();
    return file_.commit();
}

void Hdf5Output::fail() const {
    const std::string reason = errno == 0 ? "HDF5 refuses" : std::generic_category().message(errno);
    throw FileError(file_.path(), "cannot write: " + reason);
}

}  // namespace tumble::sweep
