// The files of shards: the same bytes each time, and what other programs read in them.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "sweep/store/lease.hpp"
#include "sweep/store/manifest.hpp"
#include "sweep/store/stored_file.hpp"
#include "sweep/store/tar.hpp"
#include "sweep/store/trajectory_array.hpp"
#include "tumble/file.hpp"

namespace fs = std::filesystem;
using namespace tumble::sweep;

namespace {

// A new folder that is removed at the end.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("tumble_store_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

}  // namespace

TEST_CASE("a tar member is a ustar header of 512 bytes without time, the bytes and zeros") {
    const std::string member = tar_member("000000000042.json", "{}\n");
    REQUIRE(member.size() == 1024);
    CHECK(member.substr(0, 18) == std::string("000000000042.json\0", 18));
    CHECK(member.substr(124, 12) == std::string("00000000003\0", 12));
    CHECK(member.substr(136, 12) == std::string("00000000000\0", 12));
    CHECK(member.substr(257, 8) == std::string("ustar\00000", 8));
    CHECK(member.substr(512, 4) == std::string("{}\n\0", 4));
    // The checksum is the sum of the header's bytes, with spaces in its own place.
    unsigned sum = 0;
    for (std::size_t i = 0; i < 512; ++i) sum += i >= 148 && i < 156 ? ' ' : static_cast<unsigned char>(member[i]);
    CHECK(std::stoul(member.substr(148, 6), nullptr, 8) == sum);
    CHECK(tar_member("a", std::string(512, 'x')).size() == 1024);
    CHECK((1024 + tar_end(1024).size()) % 10240 == 0);
    CHECK(tar_end(1024).size() >= 1024);
    CHECK(tar_end(10240 - 512).size() == 10240 + 512);
    CHECK_THROWS_AS(tar_member(std::string(101, 'a'), ""), std::invalid_argument);
}

TEST_CASE("an .npy file has its shape and its numbers") {
    const std::string bytes = to_npy({2, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}, 32);
    CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = static_cast<unsigned char>(bytes[8]);
    CHECK((10 + header) % 64 == 0);
    CHECK(bytes.substr(10, header).find("'descr': '<f4', 'fortran_order': False, 'shape': (2, 1, 6)") !=
          std::string::npos);
    CHECK(bytes[10 + header - 1] == '\n');
    REQUIRE(bytes.size() == 10 + header + std::size_t{48});
    float last = 0;
    std::memcpy(&last, bytes.data() + bytes.size() - 4, 4);
    CHECK(last == 12.0f);
    CHECK(to_npy({2, 1, std::vector<double>(12)}, 64).size() == 10 + header + std::size_t{96});
}

TEST_CASE("a manifest keeps what whole lines say, in the order of the shards") {
    const Folder folder;
    const SweepHeader header{1, 25, 10, "0.2.0", "run\n", "a.plan.json", "OpenGL 3.3"};
    append_header(folder.path, header);
    append_shard(folder.path, {.shard = 2,
                               .outcomes = {{"ok", 5}},
                               .table = {"shard-000002.csv", 3, 4},
                               .files = {{"shard-000002.tar", 5, 6}},
                               .copies = {{"plan/b.json", 7, 8}, {"plan/a.json", 9, 10}}});
    std::ofstream(manifest_file(folder.path), std::ios::app) << R"({"shard": 7, "outc)";  // cut off
    append_shard(folder.path, {.shard = 0, .table = {"shard-000000.csv", 1, 0xffffffffffffffff}});
    Manifest manifest = read_manifest(folder.path);
    CHECK(manifest.header == header);
    CHECK(manifest.damaged_lines == 1);
    REQUIRE(manifest.shards.size() == 2);
    CHECK(manifest.shards.begin()->second.table.hash == 0xffffffffffffffff);
    CHECK(manifest.shards.at(2).outcomes.at("ok") == 5);
    CHECK(manifest.shards.at(2).files[0].bytes == 5);
    REQUIRE(manifest.copies.size() == 2);
    CHECK(manifest.copies[0].name == "plan/a.json");
    CHECK(manifest.copies[0].hash == 10);
    manifest.table = StoredFile{"runs.csv", 1, 2};
    write_manifest(folder.path, manifest);
    CHECK(read_manifest(folder.path).damaged_lines == 0);
    CHECK(read_manifest(folder.path).copies.size() == 2);
    CHECK(read_manifest(folder.path).shards.at(2).copies.empty());  // those of the sweep have a line of their own
    const std::string text = tumble::read_file(manifest_file(folder.path));
    CHECK(text.find("\"shard\":0") < text.find("\"shard\":2"));
    append_header(folder.path, {2, 25, 10, "0.2.0", "run\n"});
    CHECK_THROWS_AS(read_manifest(folder.path), tumble::FileError);
}

TEST_CASE("a manifest from elsewhere names files of its own folder only, and possible numbers") {
    const Folder folder;
    const std::string header = R"({"plan":"1","runs":25,"shard_runs":10,"version":"1","columns":"run\n"})";
    const std::string hash = R"("bytes":1,"xxh64":"1")", sound = R"({"name":"shard-000001.csv",)" + hash + "}";
    for (const std::string& line : std::vector<std::string>{
             R"({"shard":1,"outcomes":{},"table":{"name":"/tmp/a",)" + hash + R"(},"files":[]})",
             R"({"shard":1,"outcomes":{},"table":)" + sound + R"(,"files":[{"name":"../evil.tar",)" + hash + "}]}",
             R"({"shard":1,"outcomes":{},"table":)" + sound + R"(,"files":[{"name":"shard-000002.tar",)" + hash + "}]}",
             R"({"complete":{"name":"..",)" + hash + "}}",
             R"({"complete":{"name":"runs.csv",)" + hash + R"(},"copies":[{"name":"/tmp/a",)" + hash + "}]}",
             R"({"complete":{"name":"runs.csv",)" + hash + R"(},"copies":[{"name":"plan/../../a",)" + hash + "}]}",
             R"({"shard":1,"outcomes":{},"table":)" + sound + R"(,"files":[],"copies":[{"name":"plan/../a",)" + hash +
                 "}]}",
             R"({"shard":1e300,"outcomes":{},"table":{},"files":[]})",
             R"({"shard":1,"outcomes":{"ok":-1},"table":)" + sound + R"(,"files":[]})",
             R"({"shard":3,"outcomes":{},"table":{"name":"shard-000003.csv",)" + hash + R"(},"files":[]})"}) {
        CAPTURE(line);
        write(manifest_file(folder.path), header + "\n" + line + "\n");
        const Manifest manifest = read_manifest(folder.path);
        CHECK(manifest.damaged_lines == 1);
        CHECK(manifest.shards.empty());
        CHECK_FALSE(manifest.table);
        CHECK(manifest.copies.empty());
    }
    write(manifest_file(folder.path),
          header + "\n" + R"({"shard":1,"outcomes":{},"table":)" + sound + R"(,"files":[]})");
    CHECK(read_manifest(folder.path).shards.size() == 1);
    for (const char* const wrong :
         {R"({"plan":"1","runs":25,"shard_runs":0,"version":"1","columns":"run\n"})",
          R"({"plan":"1","runs":0,"shard_runs":1,"version":"1","columns":"run\n"})",
          R"({"plan":"1","runs":9007199254740993,"shard_runs":1,"version":"1","columns":"run\n"})",  // 2^53 + 1
          R"({"plan":"1","runs":1,"shard_runs":9007199254740993,"version":"1","columns":"run\n"})",
          R"({"plan":"1","runs":1,"shard_runs":1,"version":"1","columns":"","plan_file":"../a"})"}) {
        write(manifest_file(folder.path), wrong);
        CHECK_THROWS_AS(read_manifest(folder.path), tumble::FileError);
    }
    CHECK(SweepHeader{1, 0xffffffffffffffff, 10, "", ""}.shards() == 1844674407370955162u);
}

TEST_CASE("one of several processes has a lease, until it releases it or gives no sign") {
    using std::chrono::milliseconds;
    const Folder folder;
    Leases one(folder.path, milliseconds(400)), other(folder.path, milliseconds(400));
    CHECK(one.take("a"));
    CHECK_FALSE(one.take("a"));
    CHECK_FALSE(other.take("a"));
    CHECK(other.take("b"));
    one.release("a");
    CHECK(other.take("a"));
    // A lease that is renewed is kept beyond its term.
    CHECK_FALSE(one.take("a"));
    std::this_thread::sleep_for(milliseconds(900));
    CHECK_FALSE(one.take("a"));
    CHECK(other.holds("a"));
    // One of another system that is not renewed is taken over.
    write(folder.path / "leases/c", "another-system 1 1\n");
    CHECK_FALSE(one.take("c"));
    std::this_thread::sleep_for(milliseconds(600));
    CHECK(one.take("c"));
    CHECK_FALSE(other.take("c"));
    // One that was taken over is not held any more, and its release leaves it to its new owner.
    const std::string theirs = "another-system 1 1 1\n";
    write(folder.path / "leases/a", theirs);
    CHECK_FALSE(other.holds("a"));
    other.release("a");
    CHECK(tumble::read_file(folder.path / "leases/a") == theirs);
    write(folder.path / "leases/c", theirs);
    one.release("c");
    CHECK(tumble::read_file(folder.path / "leases/c") == theirs);
}

TEST_CASE("a stored file has the checksum that reading it gives") {
    const Folder folder;
    StoredFileWriter writer(folder.path, "f");
    writer.write("abc");
    writer.write("def");
    const StoredFile written = writer.commit(), read = read_stored_file(folder.path, "f");
    CHECK(written.bytes == 6);
    CHECK(written.hash == hash_of("abcdef"));
    CHECK(read.hash == written.hash);
    CHECK(read.bytes == 6);
    CHECK_THROWS_AS(read_stored_file(folder.path, "g"), tumble::FileError);
}
