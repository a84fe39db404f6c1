// The output of `tumble` without arguments.
#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scene/data_paths.hpp"

namespace tumble::tools {

ExitCode print_usage() {
    write_output(
        "  tumble run SCENE              simulate and render a scene (shot: one frame, demo: a shipped scene)\n"
        "  tumble check SCENE...         simulate scenes and evaluate their claims (validate: errors and warnings "
        "only)\n"
        "  tumble diff A B               report where two runs first differ\n"
        "  tumble import FILE -o SCENE   convert a R.U.B.E. export or an SVG drawing (fmt, schema: the scene format)\n"
        "  tumble distance A B           compute a distance with proof (parity, bench: compare with Box2D)\n"
        "  tumble COMMAND --help         list the options of a command\n"
        "Try: " +
        command_to_type() + " demo\n");
    return ExitCode::ok;
}

}  // namespace tumble::tools
