// The page of the command line (tools/README.md) lists every command and option, and its examples run.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"

using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;

namespace {

const std::string kPage = tumble::test::read_text(TUMBLE_SOURCE_DIR "/tools/README.md");

// The text below "## `title`" up to the next heading of the same level.
std::string section_of(const std::string& title) {
    const std::size_t start = kPage.find("\n## " + title + "\n");
    REQUIRE_MESSAGE(start != std::string::npos, "no section " << title);
    return kPage.substr(start, kPage.find("\n## ", start + 1) - start);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// The names of the commands in the help text, which begin the lines after "Subcommands:".
std::vector<std::string> commands_of(const std::string& help) {
    std::vector<std::string> commands;
    for (const std::string& line : lines_of(help.substr(help.find("Subcommands:"))))
        if (line.starts_with("  ") && line[2] != ' ') commands.push_back(line.substr(2, line.find(' ', 2) - 2));
    return commands;
}

// The long options that begin lines of a help text: "--fps" of "  --fps N=60".
std::vector<std::string> options_of(const std::string& help) {
    std::vector<std::string> options;
    for (const std::string& line : lines_of(help)) {
        const std::size_t start = line.find("--");
        if (line.starts_with("  -") && start != std::string::npos)
            options.push_back(line.substr(start, line.find_first_of(" ,", start) - start));
    }
    return options;
}

// The lines of the ```sh blocks.
std::vector<std::string> examples() {
    std::vector<std::string> found;
    bool in_block = false;
    for (const std::string& line : lines_of(kPage)) {
        if (line.starts_with("```"))
            in_block = line == "```sh";
        else if (in_block)
            found.push_back(line);
    }
    return found;
}

}  // namespace

TEST_CASE("the page of the command line has a section for each command, with all its options") {
    const std::vector<std::string> commands = commands_of(run_tumble({"--help"}).out);
    CHECK(commands.size() >= 12);
    for (const std::string& command : commands) {
        const std::string section = section_of(command) + section_of("Common rules");
        const std::vector<std::string> options = options_of(run_tumble({command, "--help"}).out);
        CHECK(options.size() >= 2);
        for (const std::string& option : options) {
            CAPTURE(command);
            CHECK_MESSAGE(section.find("`" + option) != std::string::npos, option);
        }
    }
    for (const std::string& option : options_of(run_tumble({"--help"}).out))
        CHECK_MESSAGE(section_of("Common rules").find(option) != std::string::npos, option);
}

TEST_CASE("the page of the command line describes no option that does not exist") {
    for (const std::string& command : commands_of(run_tumble({"--help"}).out)) {
        const std::string help = run_tumble({command, "--help"}).out;
        for (const std::string& line : lines_of(section_of(command))) {
            if (!line.starts_with("| `-")) continue;
            const std::size_t start = line.find("--");
            const std::string option = line.substr(start, line.find_first_of(" `,", start) - start);
            CAPTURE(command);
            CHECK_MESSAGE(help.find(option) != std::string::npos, option);
        }
    }
}

TEST_CASE("the examples on the page of the command line run") {
    const Folder folder;
    std::filesystem::create_directory_symlink(TUMBLE_SOURCE_DIR "/scenes", folder / "scenes");
    const std::string path = "PATH=" + std::filesystem::path(TUMBLE_BINARY).parent_path().string() + ":$PATH; ";
    int run_count = 0;
    for (const std::string& example : examples()) {
        if (example.starts_with("ffmpeg")) continue;  // not a package of the tests
        CAPTURE(example);
        const Answer answer = tumble::test::run({"/bin/sh", "-c", path + example}, folder.path());
        CHECK_MESSAGE(answer.code == (example.ends_with("# exit code 7") ? 7 : 0), answer.err);
        ++run_count;
    }
    CHECK(run_count > 20);
}
