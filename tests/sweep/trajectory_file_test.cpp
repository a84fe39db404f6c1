// The HDF5 files of shards: what is in them, that their bytes repeat, that memory does not grow, and damaged ones.
#include <doctest/doctest.h>
#include <malloc.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/small_disk.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/hdf5/trajectory_file.hpp"
#include "sweep/hdf5/trajectory_reader.hpp"
#include "sweep/hdf5_contents.hpp"
#include "tumble/file.hpp"

namespace fs = std::filesystem;
using namespace tumble::sweep;
using tumble::FileError;
using tumble::TemporaryFolder;
using tumble::test::Hdf5Contents;

namespace {

// Each number of a run is another: 1000 times the run, plus its place in the array.
ShardTrajectory numbered(std::uint64_t run, std::size_t steps, std::size_t bodies) {
    ShardTrajectory result{run, run % 2 == 1, {steps, bodies, std::vector<double>(steps * bodies * kStateNumbers)}};
    for (std::size_t i = 0; i < result.states.numbers.size(); ++i)
        result.states.numbers[i] = 1000.0 * static_cast<double>(run) + static_cast<double>(i);
    return result;
}

StoredFile write(const fs::path& folder, const std::string& name, const std::vector<ShardTrajectory>& runs,
                 int bits = 64) {
    TrajectoryFileWriter writer(folder, name, {10, bits});
    for (const ShardTrajectory& run : runs) writer.append(run);
    return writer.commit();
}

// From now on, peak_memory() is that since this call. Earlier tests may have used more.
void forget_peak_memory() {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;
}

// The most memory that this process has used, in MB.
double peak_memory() {
    std::ifstream status("/proc/self/status");
    double kilobytes = 0.0;
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) std::istringstream(line.substr(6)) >> kilobytes;
    return kilobytes / 1024.0;
}

}  // namespace

TEST_CASE("a trajectory file has the runs of a shard, padded by NaN to the longest and to the most bodies") {
    for (const int bits : {32, 64}) {
        const TemporaryFolder folder;
        write(folder.path, "a.h5", {numbered(3, 2, 2), numbered(8, 1, 1), numbered(9, 4, 1)}, bits);
        const Hdf5Contents file(folder.path / "a.h5");
        CHECK(file.sizes("trajectory") == std::vector<hsize_t>{3, 4, 2, 6});
        CHECK(file.type("trajectory") == "float " + std::to_string(bits / 8));
        CHECK(file.numbers("run") == std::vector<double>{3, 8, 9});
        CHECK(file.numbers("steps") == std::vector<double>{2, 1, 4});
        CHECK(file.numbers("bodies") == std::vector<double>{2, 1, 1});
        CHECK(file.numbers("stopped") == std::vector<double>{1, 0, 1});
        CHECK(file.numbers("every") == std::vector<double>{10});
        const std::vector<double> all = file.numbers("trajectory");  // [3, 4, 2, 6]
        CHECK(all[23] == 3023.0);                                    // the last of two states of two bodies
        CHECK(std::isnan(all[24]));
        CHECK(all[48 + 5] == 8005.0);
        CHECK(std::isnan(all[48 + 6]));  // its second body
        CHECK(all[96 + 36 + 5] == 9023.0);
        CHECK(std::isnan(all[96 + 36 + 6]));
    }
}

TEST_CASE("the bytes of a trajectory file depend on its runs alone, also if another thread writes one meanwhile") {
    const TemporaryFolder folder;
    // Chunks of several runs, of a part of a run, and a first run that is the smallest.
    const std::vector<ShardTrajectory> short_runs{numbered(0, 5, 3), numbered(1, 5, 3), numbered(2, 4, 3)};
    const std::vector<ShardTrajectory> long_runs{numbered(0, 1, 1), numbered(1, 900, 200), numbered(2, 901, 201)};
    const StoredFile a = write(folder.path, "a", short_runs), b = write(folder.path, "b", long_runs);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts times in seconds
    StoredFile c, d;
    std::thread other([&] { c = write(folder.path, "c", short_runs); });
    d = write(folder.path, "d", long_runs);
    other.join();
    CHECK(a.hash == c.hash);
    CHECK(b.hash == d.hash);
    CHECK(a.name == "a");
    CHECK(a.bytes == fs::file_size(folder.path / "a"));
    CHECK(tumble::read_file(folder.path / "b") == tumble::read_file(folder.path / "d"));
    CHECK(hash_of(tumble::read_file(folder.path / "d")) == d.hash);
}

TEST_CASE("a reader gives the runs that were written") {
    const TemporaryFolder folder;
    const std::vector<ShardTrajectory> runs{numbered(4, 3, 2), numbered(5, 700, 300), numbered(7, 1, 0)};
    write(folder.path, "a.h5", runs);
    const TrajectoryReader reader(folder.path / "a.h5");
    REQUIRE(reader.size() == 3);
    CHECK(reader.every() == 10);
    CHECK(reader.bits() == 64);
    CHECK(reader.most_bodies() == 300);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ShardTrajectory read = reader.read(i);
        CHECK(read.run == runs[i].run);
        CHECK(reader.run(i) == runs[i].run);
        CHECK(read.is_stopped == runs[i].is_stopped);
        CHECK(read.states.steps == runs[i].states.steps);
        CHECK(read.states.bodies == runs[i].states.bodies);
        CHECK(read.states.numbers == runs[i].states.numbers);
    }
    write(folder.path, "none.h5", {}, 32);
    CHECK(TrajectoryReader(folder.path / "none.h5").size() == 0);
    CHECK(TrajectoryReader(folder.path / "none.h5").bits() == 32);
}

TEST_CASE("the memory of a writer does not grow with the runs of its shard") {
    const TemporaryFolder folder;
    const ShardTrajectory run = numbered(0, 300, 72);  // 1.04 MB
    TrajectoryFileWriter writer(folder.path, "a.h5", {1, 32});
    for (int i = 0; i < 10; ++i) writer.append(run);
    forget_peak_memory();
    const double before = peak_memory();
    for (int i = 10; i < 300; ++i) writer.append(run);
    writer.commit();
    CHECK(peak_memory() - before < 20.0);  // and not 300
}

TEST_CASE("a small file has no padding, and a first run that is the smallest costs no memory") {
    const TemporaryFolder folder;
    // 3 runs of 5 states of 3 bodies: 2160 bytes, and some 7 kB of HDF5.
    CHECK(write(folder.path, "small", {numbered(0, 5, 3), numbered(1, 5, 3), numbered(2, 5, 3)}).bytes < 12000);
    const std::vector<ShardTrajectory> growing{numbered(0, 1, 1), numbered(1, 900, 200),
                                               numbered(2, 900, 200)};  // 17 MB
    forget_peak_memory();
    const double before = peak_memory();
    CHECK(write(folder.path, "growing", growing).bytes < 19000000);
    CHECK(peak_memory() - before < 25.0);
}

TEST_CASE("a full disk is an error of the file, and nothing is left of it") {
    const TemporaryFolder folder;
    const tumble::test::SmallDisk disk(folder.path / "disk", 512);
    std::string error;
    try {
        write(folder.path / "disk", "a.h5", std::vector<ShardTrajectory>(40, numbered(0, 300, 10)));
    } catch (const FileError& caught) {
        error = caught.what();
    }
    CHECK_MESSAGE(error.find("a.h5: cannot write: No space left on device") != std::string::npos, error);
    CHECK(fs::is_empty(folder.path / "disk"));
    CHECK_NOTHROW(write(folder.path, "a.h5", {numbered(0, 300, 10)}));  // HDF5 goes on
    CHECK_THROWS_AS(TrajectoryFileWriter(folder.path / "none", "a.h5", {}), FileError);
}

TEST_CASE("a reader refuses files that are no trajectory files, or were cut off") {
    const TemporaryFolder folder;
    const auto error_of = [&](const std::string& name) -> std::string {
        try {
            const TrajectoryReader reader(folder.path / name);
            for (std::size_t i = 0; i < reader.size(); ++i) reader.read(i);
        } catch (const FileError& error) {
            return error.what();
        }
        return "none";
    };
    CHECK(error_of("gone.h5").find("gone.h5: No such file") != std::string::npos);
    std::ofstream(folder.path / "text.h5") << "no HDF5\n";
    CHECK(error_of("text.h5").find("text.h5: is no HDF5 file") != std::string::npos);
    const hid_t empty = H5Fcreate((folder.path / "empty.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(empty);
    CHECK(error_of("empty.h5").find("it has no data set 'trajectory'") != std::string::npos);
    write(folder.path, "cut.h5", {numbered(0, 300, 10)});
    fs::resize_file(folder.path / "cut.h5", fs::file_size(folder.path / "cut.h5") / 2);
    CHECK(error_of("cut.h5").find("cut.h5: is ") != std::string::npos);
    // A claim of more states than there are.
    write(folder.path, "steps.h5", {numbered(0, 300, 10)});
    const hid_t file = H5Fopen((folder.path / "steps.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t data = H5Dopen2(file, "steps", H5P_DEFAULT);
    const std::uint64_t many = 301;
    H5Dwrite(data, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &many);
    H5Dclose(data);
    H5Fclose(file);
    CHECK(error_of("steps.h5").find("is no trajectory file of a sweep") != std::string::npos);
}
