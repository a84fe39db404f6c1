// The instructions that this processor has beyond the baseline.
#pragma once

#include <cstdint>

namespace tumble::tools {

// What find_processor_features() looks for, in the order of its bits.
inline constexpr const char* kProcessorFeatureNames[] = {"sse4.2",   "popcnt",   "avx",        "avx2",      "fma",
                                                         "bmi",      "bmi2",     "avx512f",    "avx512cd",  "avx512dq",
                                                         "avx512bw", "avx512vl", "avx512vbmi", "avx512vnni"};
inline constexpr int kProcessorFeatureCount = sizeof(kProcessorFeatureNames) / sizeof(kProcessorFeatureNames[0]);

// The bits that this processor has; all bits on architectures other than x86-64.
std::uint32_t find_processor_features() noexcept;

}  // namespace tumble::tools
