#include "sweep/hdf5/trajectory_file.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "sweep/hdf5/hdf5_output.hpp"
#include "sweep/store/durable.hpp"
#include "sweep/store/stored_file.hpp"

namespace tumble::sweep {

namespace {

using Sizes = std::array<hsize_t, 4>;  // [run, step, body, 6]

constexpr hsize_t kLeastChunk = 1 << 16, kMostChunk = 1 << 20;  // bytes

// The trajectory is stored in chunks, so that it can grow. A chunk has at most 1 MiB, as much as HDF5 keeps in memory:
// a whole run, or an equal part of its steps. Runs of less than 64 KiB share one, because each chunk takes memory and
// an entry in an index. `first` are the first runs of the file, of which the largest decides.
Sizes chunk_for(const std::vector<ShardTrajectory>& first, int bits) {
    hsize_t steps = 1, bodies = 1;
    for (const ShardTrajectory& run : first) {
        steps = std::max<hsize_t>(steps, run.states.steps);
        bodies = std::max<hsize_t>(bodies, run.states.bodies);
    }
    const hsize_t body_bytes = kStateNumbers * (bits == 64 ? 8 : 4);
    bodies = std::min(bodies, kMostChunk / body_bytes);
    const hsize_t state_bytes = bodies * body_bytes, most_steps = kMostChunk / state_bytes;
    const hsize_t parts = (steps + most_steps - 1) / most_steps, part = (steps + parts - 1) / parts;
    const hsize_t runs = std::clamp<hsize_t>(kLeastChunk / (part * state_bytes), 1, std::max<hsize_t>(first.size(), 1));
    return {runs, part, bodies, kStateNumbers};
}

}  // namespace

struct TrajectoryFileWriter::Impl {
    Impl(std::filesystem::path folder_, std::string name_, const TrajectoryFormat& format_)
        : folder(std::move(folder_)), name(std::move(name_)), format(format_), file(folder / name) {}

    void append(ShardTrajectory run);
    void start();
    void make_data();
    void store(const ShardTrajectory& run);
    void write_columns();

    std::filesystem::path folder;
    std::string name;
    TrajectoryFormat format;
    Hdf5Output file;
    Handle data{};
    Sizes sizes{0, 0, 0, kStateNumbers};
    std::vector<ShardTrajectory> first{};  // until they are as large as a chunk
    std::size_t first_bytes = 0;
    std::vector<std::uint64_t> runs{}, steps{}, bodies{}, stopped{};
};

void TrajectoryFileWriter::Impl::append(ShardTrajectory run) {
    if (data >= 0) return store(run);
    first_bytes += run.states.numbers.size() * static_cast<std::size_t>(format.bits) / 8;
    first.push_back(std::move(run));
    if (first_bytes >= kLeastChunk) start();
}

void TrajectoryFileWriter::Impl::start() {
    make_data();
    for (const ShardTrajectory& run : first) store(run);
    first = {};
}

void TrajectoryFileWriter::Impl::make_data() {
    constexpr Sizes kLargest{H5S_UNLIMITED, H5S_UNLIMITED, H5S_UNLIMITED, kStateNumbers};
    const double padding = std::numeric_limits<double>::quiet_NaN();
    const Sizes chunk = chunk_for(first, format.bits);
    const Handle properties = file.make_properties();
    file.required(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
    file.required(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &padding));
    const Handle space = file.required(Handle(H5Screate_simple(4, sizes.data(), kLargest.data()), H5Sclose));
    const hid_t type = format.bits == 64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
    data = file.required(
        Handle(H5Dcreate2(file.id(), "trajectory", type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose));
}

void TrajectoryFileWriter::Impl::store(const ShardTrajectory& run) {
    const TrajectoryArray& states = run.states;
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

void TrajectoryFileWriter::append(ShardTrajectory run) {
    const Hdf5Lock lock;
    impl_->append(std::move(run));
}

StoredFile TrajectoryFileWriter::commit() {
    Hdf5Output& file = impl_->file;
    {
        const Hdf5Lock lock;
        if (impl_->data < 0) impl_->start();
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
