// The parts of the library that are compiled for several instruction sets in one program do not meet: the linker could
// take a function with AVX-512 for all of them, and a processor without it would end the program.
#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(TUMBLE_BINARY_DIR) / "src" / "dispatch";

std::vector<std::string> lines_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    REQUIRE(pipe != nullptr);
    std::vector<std::string> lines(1);
    for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += static_cast<char>(c);
    }
    lines.pop_back();
    return lines;
}

// The global and weak symbols that the object defines, without the constants that carry the name of the set.
std::vector<std::string> shared_symbols(const std::string& set) {
    std::vector<std::string> symbols;
    for (const std::string& line : lines_of(TUMBLE_NM " -g --defined-only " + (kFolder / (set + ".o")).string())) {
        std::istringstream words(line);
        std::string address, type, symbol;
        words >> address >> type >> symbol;
        if (!(type == "u" && symbol.ends_with("." + set))) symbols.push_back(symbol);
    }
    return symbols;
}

}  // namespace

TEST_CASE("the code of an instruction set shows one symbol to the linker: the table of its functions") {
    if (!fs::exists(kFolder)) return;  // a build for the baseline alone
    for (const char* set : {"baseline", "avx2", "avx512"}) {
        CAPTURE(set);
        CHECK(shared_symbols(set) == std::vector<std::string>{std::string("tumble_entries_") + set});
    }
}

TEST_CASE("no code of an instruction set runs before the choice: nothing there has dynamic initialisation") {
    if (!fs::exists(kFolder)) return;
    for (const char* set : {"baseline", "avx2", "avx512"}) {
        CAPTURE(set);
        for (const std::string& line : lines_of(TUMBLE_NM " " + (kFolder / (std::string(set) + ".o")).string()))
            CHECK_MESSAGE(line.find("_GLOBAL__sub_I_") == std::string::npos, line);
    }
}
