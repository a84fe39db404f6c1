// Tables of any columns: their fields, line ends and errors.
#include "tools/output/csv_table.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"
#include "tools/output/input_error.hpp"
#include "tumble/file.hpp"

using namespace tumble;
using tools::cells_of, tools::CsvTable, tools::InputError;
using Cells = std::vector<std::string>;

namespace {

// What reading all lines of a file with this text throws; empty if nothing.
std::string error_of(const std::string& text, const std::string& column = "a") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "t.csv";
    std::ofstream(file, std::ios::binary) << text;
    try {
        CsvTable table(file);
        table.column(column);
        while (table.next()) continue;
    } catch (const InputError& error) {
        return std::string(error.what()).substr(folder.path.string().size() + 1);
    }
    return {};
}

}  // namespace

TEST_CASE("the fields of a line are those of RFC 4180") {
    CHECK(cells_of("a,b") == Cells{"a", "b"});
    CHECK(cells_of("") == Cells{""});
    CHECK(cells_of(",") == Cells{"", ""});
    CHECK(cells_of(R"(1,"a, b","say ""no""", x )") == Cells{"1", "a, b", "say \"no\"", " x "});
    CHECK(cells_of(R"("","""")") == Cells{"", "\""});
    CHECK(cells_of("1,\"open") == std::nullopt);
}

TEST_CASE("a table that cannot be read is no table without lines") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "t.csv";
    std::filesystem::create_directory(file);  // it opens, and reading it fails
    CHECK_THROWS_WITH_AS(CsvTable{file}, doctest::Contains("t.csv: cannot be read"), FileError);
}

TEST_CASE("a table is read line by line, whatever its line ends are") {
    const TemporaryFolder folder;
    for (const std::string end : {"\n", "\r\n"}) {
        const std::filesystem::path file = folder.path / "t.csv";
        std::ofstream(file, std::ios::binary) << "\xEF\xBB\xBF" + ("a,b" + end) + "1,\"2,5\"" + end + "3,4";
        CsvTable table(file);
        CHECK(table.columns() == Cells{"a", "b"});
        CHECK(table.column("b") == 1);
        REQUIRE(table.next());
        CHECK(table.cell(1) == "2,5");
        REQUIRE(table.next());
        CHECK(table.cell(1) == "4");
        CHECK_FALSE(table.next());
    }
}

TEST_CASE("an error of a table names the file and the line") {
    CHECK(error_of("a,b\n1,2\n") == "");
    CHECK(error_of("a,b\n1,2\n3\n") == "t.csv:3: has not all columns");
    CHECK(error_of("a,b\n1,2,3\n") == "t.csv:2: has not all columns");
    CHECK(error_of("a,b\n1,\"2\n") == "t.csv:2: a quote is not closed");
    CHECK(error_of("alpha,b\n", "alpa") ==
          "t.csv: has no column 'alpa'; did you mean 'alpha'?\n  its columns: alpha, b");
    CHECK(error_of("") == "t.csv:1: has no line of columns");
    CHECK(error_of("a\n" + std::string(std::size_t{1} << 25, 'x')).starts_with("t.csv:"));
}
