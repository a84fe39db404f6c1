// The output of `tumble` without arguments.
#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scene/data_paths.hpp"

namespace tumble::tools {

ExitCode print_usage() {
    write_output(
        "  tumble run SCENE              simulate and render a scene; see also demo, shot, plot\n"
        "  tumble check SCENE...         evaluate the claims of scenes; see also validate, shrink\n"
        "  tumble init NAME              make a project folder for scenes; see also watch\n"
        "  tumble diff A B               report where two runs first differ; see also compare\n"
        "  tumble import FILE -o SCENE   convert a drawing or an export; see also fmt, schema\n"
        "  tumble distance A B           compute a distance with proof; see also parity, bench\n"
        "  tumble COMMAND --help         list the options of a command\n"
        "Try: " +
        command_to_type() + " demo\n");
    return ExitCode::ok;
}

}  // namespace tumble::tools
