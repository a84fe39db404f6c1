#include "tools/sweep/plan_input.hpp"

#include "tools/cli/console.hpp"
#include "tools/output/standard_input.hpp"

namespace tumble::tools {

sweep::Plan read_plan_input(const std::filesystem::path& file, std::uint64_t runs, bool allow_outside,
                            std::vector<Diagnostic>* warnings) {
    if (!is_standard_input(file)) return sweep::read_plan(file, runs, allow_outside, warnings);
    sweep::Plan plan = sweep::parse_plan(standard_input(), "<stdin>", runs, allow_outside, warnings);
    plan.file = "plan.json";  // the name of its copy in the folder of the sweep
    return plan;
}

void narrate_warnings(std::vector<Diagnostic> warnings) {
    for (Diagnostic& warning : warnings) {
        warning.code.clear();  // codes are about scenes
        narrate(to_string(warning) + "\n");
    }
}

}  // namespace tumble::tools
