#include "processor.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

// The kernel's own list is the oracle; it spells sse4.2 with an underscore.
TEST_CASE("the processor has the features that the kernel says it has") {
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
        std::string name = tumble::tools::kProcessorFeatureNames[i];
        for (char& character : name)
            if (character == '.') character = '_';
        const bool listed = (line + " ").find(" " + name + " ") != std::string::npos;
        // Found without the underscore too: avx512vbmi is listed so, avx512_vnni is not.
        const bool underscored =
            name.starts_with("avx512") && (line + " ").find(" avx512_" + name.substr(6) + " ") != std::string::npos;
        CAPTURE(name);
        CHECK(((features >> i) & 1u) == ((listed || underscored) ? 1u : 0u));
    }
}

TEST_CASE("this processor has what this build needs") {
    CHECK((tumble::tools::kRequiredProcessorFeatures & ~tumble::tools::find_processor_features()) == 0);
}
