// The instruction sets that this processor has and that the build uses.
#pragma once

#include <cstdint>

namespace tumble::tools {

// One bit for each instruction set that the compiler flags of the project may allow, in the order of
// kProcessorFeatureNames.
inline constexpr const char* kProcessorFeatureNames[] = {"sse4.2",   "popcnt",   "avx",        "avx2",      "fma",
                                                         "bmi",      "bmi2",     "avx512f",    "avx512cd",  "avx512dq",
                                                         "avx512bw", "avx512vl", "avx512vbmi", "avx512vnni"};
inline constexpr int kProcessorFeatureCount = sizeof(kProcessorFeatureNames) / sizeof(kProcessorFeatureNames[0]);

// The bits that the compiler flags of this build allow.
extern const std::uint32_t kRequiredProcessorFeatures;

// The bits that this processor has; all bits on architectures other than x86-64.
std::uint32_t find_processor_features() noexcept;

}  // namespace tumble::tools
