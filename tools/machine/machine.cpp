#include "tools/machine/machine.hpp"

#include <fstream>
#include <string>
#include <thread>

#include "tools/machine/build_info.hpp"
#include "tumble/instruction_set.hpp"

namespace tumble::tools {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

void write_machine(JsonWriter& json) {
    json.open_object()
        .member("processor", processor_name())
        .member("cores", std::thread::hardware_concurrency())
        .member("compiler", compiler_name())
        .member("build_type", build_type())
        .member("simd", instruction_set())
        .close_object();
}

}  // namespace tumble::tools
