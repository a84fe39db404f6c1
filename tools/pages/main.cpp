// Writes the manual page and the completions of shells into a folder: tumble_pages FOLDER. The build runs it.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "tools/commands/command_line.hpp"
#include "tools/machine/build_info.hpp"
#include "tools/pages/pages.hpp"
#include "tumble/file.hpp"

namespace {

using namespace tumble::tools;

void write(const std::filesystem::path& file, const std::string& text) {
    tumble::OutputFile output(file);
    output.write(text);
    output.commit();
}

void write_pages(const std::filesystem::path& folder) {
    const CommandLine line;
    const std::vector<ListedCommand> commands = list_commands(line.app);
    write(folder / "tumble.1", manual_page(commands, version()));
    write(folder / "tumble.bash", bash_completion(commands));
    write(folder / "_tumble", zsh_completion(commands));
    write(folder / "tumble.fish", fish_completion(commands));
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fputs("usage: tumble_pages FOLDER\n", stderr);
        return 2;
    }
    try {
        write_pages(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tumble_pages: %s\n", error.what());
        return 4;
    }
    return 0;
}
