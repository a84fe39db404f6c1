// `tumble --version`: prints the version, its compiler, the instruction set in use, and those of the processor.
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/machine/build_info.hpp"
#include "tools/machine/processor.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/instruction_set.hpp"

namespace tumble::tools {

namespace {

std::vector<std::string> feature_names(std::uint32_t features) {
    std::vector<std::string> names;
    for (int i = 0; i < kProcessorFeatureCount; ++i)
        if ((features & (1u << i)) != 0) names.emplace_back(kProcessorFeatureNames[i]);
    return names;
}

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text.empty() ? "none beyond the baseline" : text;
}

}  // namespace

ExitCode print_version(bool json) {
    const std::vector<std::string> present = feature_names(find_processor_features());
    if (!json) {
        write_output("tumble " + version() + "\n");
        write_output("compiler   " + compiler_name() + ", " + build_type() + "\n");
        write_output("uses       " + instruction_set() + ", of " + join(instruction_sets()) +
                     "; TUMBLE_SIMD in the environment chooses\n");
        write_output("processor  " + join(present) + "\n");
        return ExitCode::ok;
    }
    JsonWriter document;
    document.open_object().member("version", version()).member("compiler", compiler_name());
    document.member("build_type", build_type()).member("simd", instruction_set());
    document.member("instruction_sets", instruction_sets());
    document.member("processor_has", present);
    document.close_object();
    write_output(document.text() + "\n");
    return ExitCode::ok;
}

}  // namespace tumble::tools
