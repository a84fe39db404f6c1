// What `tumble` says when it is given nothing to do.
#include "tools/cli/command.hpp"
#include "tools/cli/console.hpp"
#include "tools/scene/places.hpp"

namespace tumble::tools {

ExitCode print_usage() {
    write_output(
        "  tumble run SCENE [-o DIR]       simulate and render into DIR; shot SCENE --at T -o F.png: one frame\n"
        "  tumble demo [NAME]              run a shipped scene; demo --list: which there are\n"
        "  tumble check SCENE...           simulate, and test what the scenes claim; validate: every error; diff A B: "
        "two runs\n"
        "  tumble import FILE -o SCENE     a scene from R.U.B.E. or SVG; fmt: tidy a scene; schema: its JSON schema\n"
        "  tumble distance A B             the signed distance of two shapes, with its proof; parity: beside "
        "b2Distance\n"
        "  tumble bench                    queries and world step beside Box2D; COMMAND --help: all options of a "
        "command\n"
        "Try: " +
        command_to_type() + " demo\n");
    return ExitCode::ok;
}

}  // namespace tumble::tools
