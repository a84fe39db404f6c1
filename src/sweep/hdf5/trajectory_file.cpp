#include "sweep/hdf5/trajectory_file.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "sweep/hdf5/hdf5_output.hpp"
#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"

namespace tumble::sweep {

namespace {

using Sizes = std::array<hsize_t, 4>;  // [run, step, body, 6]

// The trajectory is stored in chunks, so that it can grow. A chunk has at most 1 MiB, as much as HDF5 keeps in memory:
// a whole run, or an equal part of its steps. Runs of less than 64 KiB share one, because each chunk has an entry in an
// index. The first run decides.
Sizes chunk_for(const TrajectoryArray& first, const TrajectoryFormat& format) {
    constexpr hsize_t kLeast = 1 << 16, kMost = 1 << 20;
    const hsize_t body_bytes = kStateNumbers * (format.bits == 64 ? 8 : 4);
    const hsize_t bodies = std::clamp<hsize_t>(first.bodies, 1, kMost / body_bytes);
    const hsize_t state_bytes = bodies * body_bytes, most_steps = kMost / state_bytes;
    const hsize_t steps = std::max<hsize_t>(first.steps, 1), parts = (steps + most_steps - 1) / most_steps;
    const hsize_t part = (steps + parts - 1) / parts;
    const hsize_t runs = std::clamp<hsize_t>(kLeast / (part * state_bytes), 1, std::max<hsize_t>(format.most_runs, 1));
    return {runs, part, bodies, kStateNumbers};
}

}  // namespace

struct TrajectoryFileWriter::Impl {
    Impl(std::filesystem::path folder_, std::string name_, const TrajectoryFormat& format_)
        : folder(std::move(folder_)), name(std::move(name_)), format(format_), file(folder / name) {}

    void make_data(const TrajectoryArray& first);
    void append(const ShardTrajectory& run);
    void write_columns();

    std::filesystem::path folder;
    std::string name;
    TrajectoryFormat format;
    Hdf5Output file;
    Handle data{};
    Sizes sizes{0, 0, 0, kStateNumbers};
    std::vector<std::uint64_t> runs{}, steps{}, bodies{}, stopped{};
};

void TrajectoryFileWriter::Impl::make_data(const TrajectoryArray& first) {
    constexpr Sizes kLargest{H5S_UNLIMITED, H5S_UNLIMITED, H5S_UNLIMITED, kStateNumbers};
    const double padding = std::numeric_limits<double>::quiet_NaN();
    const Sizes chunk = chunk_for(first, format);
    const Handle properties = file.make_properties();
    file.required(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
    file.required(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &padding));
    const Handle space = file.required(Handle(H5Screate_simple(4, sizes.data(), kLargest.data()), H5Sclose));
    const hid_t type = format.bits == 64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
    data = file.required(
        Handle(H5Dcreate2(file.id(), "trajectory", type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose));
}

void TrajectoryFileWriter::Impl::append(const ShardTrajectory& run) {
    const TrajectoryArray& states = run.states;
    if (data < 0) make_data(states);
    const Sizes start{sizes[0], 0, 0, 0}, count{1, states.steps, states.bodies, kStateNumbers};
    sizes = {sizes[0] + 1, std::max<hsize_t>(sizes[1], states.steps), std::max<hsize_t>(sizes[2], states.bodies),
             kStateNumbers};
    file.required(H5Dset_extent(data, sizes.data()));
    runs.push_back(run.run);
    steps.push_back(states.steps);
    bodies.push_back(states.bodies);
    stopped.push_back(run.is_stopped ? 1 : 0);
    if (states.numbers.empty()) return;
    const Handle space = file.required(Handle(H5Dget_space(data), H5Sclose));
    file.required(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    const Handle block = file.required(Handle(H5Screate_simple(4, count.data(), nullptr), H5Sclose));
    file.required(H5Dwrite(data, H5T_NATIVE_DOUBLE, block, space, H5P_DEFAULT, states.numbers.data()));
}

void TrajectoryFileWriter::Impl::write_columns() {
    const auto write = [this](const char* column, const std::vector<std::uint64_t>& numbers) {
        const std::array<hsize_t, 1> size{numbers.size()};
        file.write(file.id(), column, size, H5T_STD_U64LE, H5T_NATIVE_UINT64, numbers.data());
    };
    write("run", runs);
    write("steps", steps);
    write("bodies", bodies);
    write("stopped", stopped);
    write("every", {format.every});
}

TrajectoryFileWriter::TrajectoryFileWriter(const std::filesystem::path& folder, const std::string& name,
                                           const TrajectoryFormat& format) {
    const Hdf5Lock lock;
    impl_ = std::make_unique<Impl>(folder, name, format);
}

TrajectoryFileWriter::~TrajectoryFileWriter() {
    const Hdf5Lock lock;
    impl_.reset();
}

void TrajectoryFileWriter::append(const ShardTrajectory& run) {
    const Hdf5Lock lock;
    impl_->append(run);
}

StoredFile TrajectoryFileWriter::commit() {
    Hdf5Output& file = impl_->file;
    {
        const Hdf5Lock lock;
        if (impl_->data < 0) impl_->make_data({});
        file.required(impl_->data.close());
        impl_->write_columns();
        file.close();
    }
    make_durable(file.temporary());
    StoredFile stored = read_stored_file(impl_->folder, file.temporary().filename().string());
    stored.name = impl_->name;
    file.commit();
    return stored;
}

}  // namespace tumble::sweep
