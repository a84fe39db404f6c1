// Whether this processor has the instructions that the project was compiled to use.
#pragma once

#include <cstdint>

namespace tumble::tools {

// One bit for each instruction set that a compiler may use for us, in the order of kProcessorFeatureNames.
inline constexpr const char* kProcessorFeatureNames[] = {"sse4.2",   "popcnt",   "avx",        "avx2",      "fma",
                                                         "bmi",      "bmi2",     "avx512f",    "avx512cd",  "avx512dq",
                                                         "avx512bw", "avx512vl", "avx512vbmi", "avx512vnni"};
inline constexpr int kProcessorFeatureCount = sizeof(kProcessorFeatureNames) / sizeof(kProcessorFeatureNames[0]);

// The bits that the project's compiler flags allow the compiler to use.
extern const std::uint32_t kRequiredProcessorFeatures;

// The bits that this processor has. Where it cannot be asked (not x86), all of them.
std::uint32_t find_processor_features() noexcept;

}  // namespace tumble::tools
