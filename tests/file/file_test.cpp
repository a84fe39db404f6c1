#include "tumble/file.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

namespace fs = std::filesystem;

using tumble::FileError;
using tumble::OutputFile;
using tumble::read_file;

namespace {

struct Folder {
    fs::path path;

    Folder() {
        std::string name = (fs::temp_directory_path() / "tumble_file_XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path = name;
    }
    ~Folder() { fs::remove_all(path); }

    auto entries() const { return std::distance(fs::directory_iterator(path), {}); }
};

// During its lifetime no file may grow beyond `bytes`: for a writer this is a full disk.
class SmallFiles {
public:
    explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit small{bytes, before_.rlim_max};
        REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
    }
    ~SmallFiles() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

void write_whole(const fs::path& file, std::string_view text) {
    OutputFile output(file);
    output.write(text);
    CHECK(output.commit() == text.size());
}

}  // namespace

TEST_CASE("commit replaces the old file by the whole new one") {
    const Folder folder;
    const fs::path file = folder.path / "data.txt";
    write_whole(file, "old");
    {
        OutputFile output(file);
        output.write(std::string(1 << 20, 'x'));
        output.write("end");
        CHECK(read_file(file, 100) == "old");
        CHECK(output.commit() == (1u << 20) + 3);
    }
    CHECK(read_file(file, 1u << 21) == std::string(1 << 20, 'x') + "end");
    CHECK(folder.entries() == 1);
}

TEST_CASE("without commit nothing remains of a file") {
    const Folder folder;
    {
        OutputFile output(folder.path / "data.txt");
        output.write("half");
        OutputFile moved(std::move(output));
        moved.write(std::string(1 << 17, 'x'));
        CHECK(folder.entries() == 1);
    }
    CHECK(folder.entries() == 0);
}

TEST_CASE("a file that another process writes is committed with the bytes of that") {
    const Folder folder;
    OutputFile file(folder.path / "v");
    file.write("of this process");
    std::ofstream(file.temporary()) << "of another";
    file.take_from_others();
    CHECK(file.commit() == 10);
    CHECK(read_file(folder.path / "v") == "of another");
    CHECK(folder.entries() == 1);
}

TEST_CASE("two writers of one file do not mix their bytes") {
    const Folder folder;
    const fs::path file = folder.path / "data.txt";
    OutputFile first(file), second(file);
    first.write("first");
    second.write("second");
    second.commit();
    first.commit();
    CHECK(read_file(file, 100) == "first");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk is an error with its reason, and the old file stays") {
    const Folder folder;
    const fs::path file = folder.path / "data.txt";
    write_whole(file, "old");
    {
        const SmallFiles limit(4096);
        OutputFile output(file);
        CHECK_THROWS_WITH_AS(output.write(std::string(1 << 20, 'x')),
                             (file.string() + ": cannot write: File too large").c_str(), FileError);
        OutputFile at_close(file);
        at_close.write(std::string(8192, 'x'));
        CHECK_THROWS_AS(at_close.commit(), FileError);
    }
    CHECK(read_file(file, 100) == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a file that cannot be created is an error") {
    const Folder folder;
    CHECK_THROWS_AS(OutputFile(folder.path / "no" / "data.txt"), FileError);
    fs::create_directories(folder.path / "occupied" / "inside");
    OutputFile output(folder.path / "occupied");
    CHECK_THROWS_AS(output.commit(), FileError);  // a folder cannot be replaced by a file
    CHECK(fs::is_directory(folder.path / "occupied" / "inside"));
}

TEST_CASE("reading stops one byte after the limit, and an error names the file") {
    const Folder folder;
    write_whole(folder.path / "data.txt", "0123456789");
    CHECK(read_file(folder.path / "data.txt", 10) == "0123456789");
    CHECK(read_file(folder.path / "data.txt", 4) == "01234");
    CHECK_THROWS_WITH_AS(read_file("no/such/file", 10), "no/such/file: No such file or directory", FileError);
    CHECK_THROWS_WITH_AS(read_file("/", 10), "/: Is a directory; name a file in it", FileError);
}

TEST_CASE("a file continues with a part of another, and is an error if that is too short") {
    const Folder folder;
    write_whole(folder.path / "before.csv", "step\n0\n1\n2\n");
    OutputFile output(folder.path / "data.csv");
    output.write("step\n");
    CHECK(output.save_so_far() == 5);
    CHECK(read_file(output.temporary()) == "step\n");
    output.append_from(folder.path / "before.csv", 5, 9);
    CHECK_THROWS_AS(output.append_from(folder.path / "before.csv", 0, 12), FileError);
    CHECK_THROWS_AS(output.append_from(folder.path / "none.csv", 0, 1), FileError);
    OutputFile copy(folder.path / "copy.csv");
    copy.write("step\n");
    copy.append_from(folder.path / "before.csv", 5, 9);
    CHECK(copy.commit() == 9);
    CHECK(read_file(folder.path / "copy.csv") == "step\n0\n1\n");
}

TEST_CASE("a temporary file that is left can be found with its file and its process") {
    const Folder folder;
    fs::path temporary;
    {
        OutputFile output(folder.path / "data.csv");
        output.write("0123");
        output.save_so_far();
        temporary = output.temporary();
        output.leave();
    }
    CHECK(read_file(temporary) == "0123");
    write_whole(folder.path / "data.csv.999999999-0.partial", "");  // more than any process has
    for (const char* const other :
         {"notes.partial", "a.b.partial", "a.1-.partial", "a.1.partial", ".1-0.partial", "a.1-0"})
        write_whole(folder.path / other, "");
    const std::vector<tumble::PartialFile> found = tumble::find_partial_files(folder.path);
    REQUIRE(found.size() == 2);
    for (const tumble::PartialFile& partial : found) {
        CHECK(partial.file == folder.path / "data.csv");
        const bool is_own = partial.path == temporary;
        CHECK_FALSE(partial.is_open);
        CHECK(partial.process == (is_own ? ::getpid() : 999999999));
    }
    CHECK(tumble::find_partial_files(folder.path / "none").empty());
}

TEST_CASE("a temporary file is open while it is written, whatever process has the number in its name") {
    const Folder folder;
    write_whole(folder.path / "data.csv.1-0.partial", "");  // process 1 runs
    write_whole(folder.path / ("data.csv." + std::to_string(::getpid()) + "-0.partial"), "");
    const OutputFile output(folder.path / "data.csv");
    const std::vector<tumble::PartialFile> found = tumble::find_partial_files(folder.path);
    REQUIRE(found.size() == 3);
    for (const tumble::PartialFile& partial : found) CHECK(partial.is_open == (partial.path == output.temporary()));
}

TEST_CASE("a file that a killed process of the same number has left does not block its name") {
    const Folder folder;
    const std::string number = std::to_string(::getpid());
    unsigned serial = 0;
    {
        // The numbers of the files of this process are consecutive.
        const OutputFile last(folder.path / "x");
        const std::string name = last.temporary().string();
        const std::size_t start = name.rfind('-') + 1;
        serial = static_cast<unsigned>(std::stoul(name.substr(start)));
    }
    // write_whole() takes a number itself.
    write_whole(folder.path / ("data.csv." + number + "-" + std::to_string(serial + 3) + ".partial"), "old");
    write_whole(folder.path / ("data.csv." + number + "-" + std::to_string(serial + 4) + ".partial"), "old");
    write_whole(folder.path / "data.csv", "new");
    CHECK(read_file(folder.path / "data.csv") == "new");
    CHECK(folder.entries() == 3);
}
