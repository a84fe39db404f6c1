// Errors of the files of a sweep: a full disk, a read-only one, files of other kinds, and limits.
#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "support/small_disk.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/store/durable.hpp"
#include "sweep/store/lease.hpp"
#include "sweep/store/manifest.hpp"
#include "sweep/store/stored_file.hpp"
#include "sweep/store/tar.hpp"
#include "tumble/file.hpp"

namespace fs = std::filesystem;
using namespace tumble::sweep;
using tumble::FileError;
using tumble::TemporaryFolder;
using tumble::test::SmallDisk;

namespace {

const SweepHeader kHeader{1, 1000, 10, "0.2.0", "run\n"};

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

// Whether the error names the file and the reason.
bool has(const std::string& error, const std::string& file, const std::string& reason) {
    const bool found = error.find(file + ": ") != std::string::npos && error.find(reason) != std::string::npos;
    if (!found) MESSAGE(error);
    return found;
}

void write_stored(const fs::path& folder, std::size_t bytes) {
    StoredFileWriter writer(folder, "shard-000000.tar");
    writer.write(std::string(bytes, 'x'));
    writer.commit();
}

void take_lease(const fs::path& folder) {
    Leases leases(folder, std::chrono::milliseconds(1000));
    leases.take("shard-000000");
}

}  // namespace

TEST_CASE("on a full disk each file of a sweep is an error with its name, and none is left in part") {
    const TemporaryFolder folder;
    const SmallDisk disk(folder.path / "disk", 64);
    const fs::path place = folder.path / "disk";
    constexpr const char* kFull = "No space left on device";
    CHECK(has(error_of([&] { write_stored(place, 1 << 20); }), "shard-000000.tar", kFull));
    CHECK(fs::is_empty(place));
    append_header(place, kHeader);
    std::ofstream(place / "ballast") << std::string(1 << 20, 'x');  // as much as there is room for
    Manifest large{.header = kHeader};
    for (std::uint64_t shard = 0; shard < 100; ++shard) large.shards[shard] = {.shard = shard};
    CHECK(has(error_of([&] { write_manifest(place, large); }), "manifest.jsonl", kFull));
    CHECK(read_manifest(place).header == kHeader);  // the old one
    CHECK(has(error_of([&] { take_lease(place); }), "leases/shard-000000", kFull));
}

TEST_CASE("a line of the manifest for which there was no room costs its shard alone") {
    const TemporaryFolder folder;
    const SmallDisk disk(folder.path / "disk", 64);
    const fs::path place = folder.path / "disk";
    append_header(place, kHeader);
    std::ofstream(place / "ballast") << std::string(1 << 20, 'x');
    const auto append = [&](std::uint64_t shard) {
        append_shard(place, {.shard = shard, .table = {shard_file_name(shard, ".csv"), 1, 2}});
    };
    std::uint64_t shard = 0;
    std::string error = "none";
    for (; error == "none" && shard < 100; ++shard) error = error_of([&] { append(shard); });
    CHECK(has(error, "manifest.jsonl", "No space left on device"));
    CHECK(shard > 1);    // the page of the header has room for some
    CHECK(shard < 100);  // but not for all
    fs::remove(place / "ballast");
    append(shard);
    const Manifest manifest = read_manifest(place);
    CHECK(manifest.shards.size() == shard);  // those before, and the last one
    CHECK(manifest.shards.contains(shard));
    CHECK_FALSE(manifest.shards.contains(shard - 1));
    CHECK(manifest.damaged_lines == 1);
}

TEST_CASE("on a read-only disk each file of a sweep is an error with its name, and what is there can be read") {
    const TemporaryFolder folder;
    const SmallDisk disk(folder.path / "disk", 64);
    const fs::path place = folder.path / "disk";
    append_header(place, kHeader);
    write_stored(place, 100);
    disk.make_read_only();
    constexpr const char* kReadOnly = "Read-only file system";
    CHECK(has(error_of([&] { write_stored(place, 100); }), "shard-000000.tar", kReadOnly));
    CHECK(has(error_of([&] { append_header(place, kHeader); }), "manifest.jsonl", kReadOnly));
    CHECK(has(error_of([&] { write_manifest(place, {}); }), "manifest.jsonl", kReadOnly));
    CHECK(has(error_of([&] { take_lease(place); }), "leases", kReadOnly));
    CHECK(read_manifest(place).header == kHeader);
    CHECK(read_stored_file(place, "shard-000000.tar").bytes == 100);
}

TEST_CASE("a file that is missing, a folder or a pipe is an error, and is not waited for") {
    const TemporaryFolder folder;
    CHECK(has(error_of([&] { make_durable(folder.path / "gone"); }), "gone", "No such file"));
    CHECK(has(error_of([&] { append_header(folder.path / "gone", kHeader); }), "manifest.jsonl", "No such file"));
    fs::create_directories(folder.path / "shard-000000.h5");
    CHECK(
        has(error_of([&] { read_stored_file(folder.path, "shard-000000.h5"); }), "shard-000000.h5", "no regular file"));
    REQUIRE(::mkfifo((folder.path / "shard-000001.h5").c_str(), 0600) == 0);
    CHECK(
        has(error_of([&] { read_stored_file(folder.path, "shard-000001.h5"); }), "shard-000001.h5", "no regular file"));
    fs::create_directories(folder.path / "manifest.jsonl");
    CHECK(error_of([&] { read_manifest(folder.path); }) != "none");
}

TEST_CASE("a tar member of 8 GiB is refused, because its size has eleven octal digits") {
    constexpr std::size_t kTooLarge = std::size_t{1} << 33;
    // Addresses without memory, which nothing may read.
    void* const nothing = ::mmap(nullptr, kTooLarge, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    REQUIRE(nothing != MAP_FAILED);
    CHECK_THROWS_AS(tar_member("a", std::string_view(static_cast<const char*>(nothing), kTooLarge)),
                    std::invalid_argument);
    ::munmap(nothing, kTooLarge);
}
