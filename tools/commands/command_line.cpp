#include "tools/commands/command_line.hpp"

#include "tools/commands/commands.hpp"

namespace tumble::tools {

CommandLine::CommandLine()
    : app("Simulates 2D physics scenes, renders their frames off-screen, computes distances with proof", "tumble") {
    app.add_flag("--version", version, "Print version, compiler and instruction sets; with --json as JSON");
    app.add_flag("--json", command.json)->group("");
    add_init(app, command);
    add_run(app, command);
    add_demo(app, command);
    add_shot(app, command);
    add_check(app, command);
    add_shrink(app, command);
    add_watch(app, command);
    add_plot(app, command);
    add_gallery(app, command);
    add_compare(app, command);
    add_diff(app, command);
    add_validate(app, command);
    add_explain(app, command);
    add_fmt(app, command);
    add_schema(app, command);
    add_distance(app, command);
    add_import(app, command);
    add_parity(app, command);
    add_bench(app, command);
    add_physics(app, command);
    add_sweep(app, command);
    add_doctor(app, command);
    app.require_subcommand(0, 1);
}

}  // namespace tumble::tools
