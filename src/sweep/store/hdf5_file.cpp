#include "sweep/store/hdf5_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace tumble::sweep {

namespace {

constexpr std::size_t kGrowth = 1 << 20;  // bytes by which the file in memory grows

template <class Result>
Result required(Result result, const char* what) {
    if (result < 0) throw std::runtime_error(std::string("HDF5 cannot ") + what);
    return result;
}

// An identifier of HDF5 that is closed by its function.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(required(id, what)), close_(close) {}
    ~Handle() { close_(id_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const noexcept { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

Handle make_file() {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
    required(H5Pset_fapl_core(access, kGrowth, false), "write to memory");
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a property list");
    required(H5Pset_obj_track_times(creation, false), "leave out times");
    // The name is not used: nothing is written to disk.
    return {H5Fcreate("shard.h5", H5F_ACC_TRUNC, creation, access), H5Fclose, "make a file"};
}

Handle make_data(hid_t file, const char* name, hid_t type, std::span<const hsize_t> sizes) {
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
    required(H5Pset_obj_track_times(creation, false), "leave out times");
    required(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), "leave out fill values");
    const Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose,
                       "make a space");
    return {H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, "make a data set"};
}

void write_column(hid_t file, const char* name, const std::vector<std::uint64_t>& numbers) {
    const std::array<hsize_t, 1> size{numbers.size()};
    const Handle data = make_data(file, name, H5T_STD_U64LE, size);
    required(H5Dwrite(data, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), "write a data set");
}

// The states of one run in a block of the size of the largest.
std::vector<double> padded(const TrajectoryArray& states, std::size_t steps, std::size_t bodies) {
    std::vector<double> block(steps * bodies * kStateNumbers, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t step = 0; step < states.steps; ++step) {
        const auto row = states.numbers.begin() + static_cast<std::ptrdiff_t>(step * states.bodies * kStateNumbers);
        std::copy_n(row, states.bodies * kStateNumbers,
                    block.begin() + static_cast<std::ptrdiff_t>(step * bodies * kStateNumbers));
    }
    return block;
}

void write_trajectories(hid_t file, std::span<ShardTrajectory> runs, hid_t type) {
    std::size_t steps = 0, bodies = 0;
    for (const ShardTrajectory& run : runs) {
        steps = std::max(steps, run.states.steps);
        bodies = std::max(bodies, run.states.bodies);
    }
    const std::array<hsize_t, 4> sizes{runs.size(), steps, bodies, kStateNumbers};
    const Handle data = make_data(file, "trajectory", type, sizes);
    const Handle space(H5Dget_space(data), H5Sclose, "find a space");
    const std::array<hsize_t, 4> count{1, steps, bodies, kStateNumbers};
    const Handle row(H5Screate_simple(4, count.data(), nullptr), H5Sclose, "make a space");
    for (std::size_t i = 0; i < runs.size() && steps * bodies > 0; ++i) {
        const std::vector<double> block = padded(runs[i].states, steps, bodies);
        runs[i].states.numbers = {};
        const std::array<hsize_t, 4> start{i, 0, 0, 0};
        required(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
                 "select a run");
        required(H5Dwrite(data, H5T_NATIVE_DOUBLE, row, space, H5P_DEFAULT, block.data()), "write a run");
    }
}

std::string image_of(hid_t file) {
    required(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete the file");
    const ssize_t size = required(H5Fget_file_image(file, nullptr, 0), "find the size of the file");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    required(H5Fget_file_image(file, bytes.data(), bytes.size()), "copy the file");
    return bytes;
}

}  // namespace

std::string to_hdf5(std::span<ShardTrajectory> runs, std::uint64_t every, int bits) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    required(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "keep its messages");
    std::vector<std::uint64_t> numbers, steps, bodies;
    for (const ShardTrajectory& run : runs) {
        numbers.push_back(run.run);
        steps.push_back(run.states.steps);
        bodies.push_back(run.states.bodies);
    }
    const Handle file = make_file();
    write_column(file, "run", numbers);
    write_column(file, "steps", steps);
    write_column(file, "bodies", bodies);
    write_column(file, "every", {every});
    write_trajectories(file, runs, bits == 64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE);
    return image_of(file);
}

}  // namespace tumble::sweep
