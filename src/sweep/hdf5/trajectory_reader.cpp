#include "sweep/hdf5/trajectory_reader.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "sweep/hdf5/hdf5_handle.hpp"
#include "tumble/file.hpp"

namespace tumble::sweep {

namespace {

constexpr hsize_t kMostRunsOfFile = 1000000;                      // of a file: kMostShardRuns of a plan
constexpr std::size_t kMostNumbers = (std::size_t{1} << 31) / 8;  // of a run
constexpr const char* kNoShard = "is no trajectory file of a sweep";

}  // namespace

struct TrajectoryReader::Impl {
    explicit Impl(std::filesystem::path path_) : path(std::move(path_)) {
        const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
        H5Pset_file_locking(access, false, true);  // some file systems have no locks
        file = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
        if (file < 0) fail(errno == 0 ? "is no HDF5 file" : std::generic_category().message(errno));
        data = open("trajectory");
    }

    [[noreturn]] void fail(const std::string& reason) const { throw FileError(path, reason); }

    Handle open(const char* name) const {
        Handle opened(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
        if (opened < 0) fail(std::string(kNoShard) + ": it has no data set '" + name + "'");
        return opened;
    }

    // The sizes of a data set of the stated rank.
    template <std::size_t Rank>
    std::array<hsize_t, Rank> sizes_of(hid_t set) const {
        const Handle space(H5Dget_space(set), H5Sclose);
        std::array<hsize_t, Rank> sizes{};
        if (space < 0 || H5Sget_simple_extent_ndims(space) != static_cast<int>(Rank)) fail(kNoShard);
        H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
        return sizes;
    }

    std::vector<std::uint64_t> column(const char* name, hsize_t size) const {
        const Handle set = open(name);
        if (sizes_of<1>(set)[0] != size) fail(kNoShard);
        std::vector<std::uint64_t> numbers(size);
        if (H5Dread(set, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) fail("is damaged");
        return numbers;
    }

    std::filesystem::path path;
    Handle file{}, data{};
};

TrajectoryReader::TrajectoryReader(const std::filesystem::path& file) {
    const Hdf5Lock lock;
    auto opened = std::make_unique<Impl>(file);
    const auto [run_count, step_count, body_count, numbers] = opened->sizes_of<4>(opened->data);
    if (run_count > kMostRunsOfFile || numbers != kStateNumbers) opened->fail(kNoShard);
    runs_ = opened->column("run", run_count);
    steps_ = opened->column("steps", run_count);
    bodies_ = opened->column("bodies", run_count);
    stopped_ = opened->column("stopped", run_count);
    every_ = opened->column("every", 1)[0];
    const Handle type(H5Dget_type(opened->data), H5Tclose);
    bits_ = H5Tget_size(type) == 8 ? 64 : 32;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (steps_[i] > step_count || bodies_[i] > body_count) opened->fail(kNoShard);
        most_bodies_ = std::max<std::size_t>(most_bodies_, bodies_[i]);
    }
    impl_ = std::move(opened);
}

TrajectoryReader::~TrajectoryReader() {
    const Hdf5Lock lock;
    impl_.reset();
}

ShardTrajectory TrajectoryReader::read(std::size_t index) const {
    const Hdf5Lock lock;
    ShardTrajectory run{runs_.at(index), stopped_[index] != 0, {steps_[index], bodies_[index], {}}};
    const std::array<hsize_t, 4> start{index, 0, 0, 0}, count{1, steps_[index], bodies_[index], kStateNumbers};
    if (count[1] == 0 || count[2] == 0) return run;
    if (count[1] > kMostNumbers / kStateNumbers / count[2])
        impl_->fail("has more than 2 GiB of run " + std::to_string(run.run));
    run.states.numbers.resize(count[1] * count[2] * kStateNumbers);
    const Handle space(H5Dget_space(impl_->data), H5Sclose);
    const Handle block(H5Screate_simple(4, count.data(), nullptr), H5Sclose);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    if (H5Dread(impl_->data, H5T_NATIVE_DOUBLE, block, space, H5P_DEFAULT, run.states.numbers.data()) < 0)
        impl_->fail("is damaged at run " + std::to_string(run.run));
    return run;
}

}  // namespace tumble::sweep
