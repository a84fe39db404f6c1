#include "tools/machine/processor.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace {

// The name of the feature in /proc/cpuinfo, the oracle.
std::string kernel_name(const std::string& name) {
    if (name == "sse4.2") return "sse4_2";
    if (name == "bmi") return "bmi1";
    if (name == "avx512vnni") return "avx512_vnni";
    return name;
}

}  // namespace

TEST_CASE("the detected features are those that the kernel lists") {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line) && !line.starts_with("flags")) {
    }
    if (line.empty()) {
        MESSAGE("not tested: the kernel lists no flags here");
        return;
    }
    const std::uint32_t features = tumble::tools::find_processor_features();
    for (int i = 0; i < tumble::tools::kProcessorFeatureCount; ++i) {
        const std::string name = kernel_name(tumble::tools::kProcessorFeatureNames[i]);
        const bool listed = (line + " ").find(" " + name + " ") != std::string::npos;
        CAPTURE(name);
        CHECK(((features >> i) & 1u) == (listed ? 1u : 0u));
    }
}
