// Ends the process with a message, not with an illegal instruction, on a processor that lacks instructions of the
// build.
//
// This file is compiled for the baseline of the architecture, and its check runs before any other static initialisation
// of the binary. It includes no header with inline functions: the linker could replace them by copies that other files
// compiled for a newer processor.
#include "tools/machine/processor.hpp"

#include <unistd.h>

namespace tumble::tools {

std::uint32_t find_processor_features() noexcept {
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool has[kProcessorFeatureCount] = {
        __builtin_cpu_supports("sse4.2") != 0,     __builtin_cpu_supports("popcnt") != 0,
        __builtin_cpu_supports("avx") != 0,        __builtin_cpu_supports("avx2") != 0,
        __builtin_cpu_supports("fma") != 0,        __builtin_cpu_supports("bmi") != 0,
        __builtin_cpu_supports("bmi2") != 0,       __builtin_cpu_supports("avx512f") != 0,
        __builtin_cpu_supports("avx512cd") != 0,   __builtin_cpu_supports("avx512dq") != 0,
        __builtin_cpu_supports("avx512bw") != 0,   __builtin_cpu_supports("avx512vl") != 0,
        __builtin_cpu_supports("avx512vbmi") != 0, __builtin_cpu_supports("avx512vnni") != 0,
    };
    std::uint32_t features = 0;
    for (int i = 0; i < kProcessorFeatureCount; ++i)
        if (has[i]) features |= 1u << i;
    return features;
#else
    return ~0u;
#endif
}

namespace {

void write_error(const char* text) {
    unsigned long length = 0;
    while (text[length] != '\0') ++length;
    // A failed write cannot be reported; the comparison silences the warning about the unused result.
    if (write(STDERR_FILENO, text, length) < 0) return;
}

// 101 is the first priority that the compiler leaves to programs.
__attribute__((constructor(101))) void check_processor() {
    const std::uint32_t missing = kRequiredProcessorFeatures & ~find_processor_features();
    if (missing == 0) return;
    write_error("tumble: error: this processor lacks instructions that this build uses:");
    for (int i = 0; i < kProcessorFeatureCount; ++i) {
        if ((missing & (1u << i)) == 0) continue;
        write_error(" ");
        write_error(kProcessorFeatureNames[i]);
    }
    write_error(
        "\n  hint: build tumble for this processor with cmake -DTUMBLE_SIMD=baseline (or avx2); the results are the "
        "same, "
        "bit for bit\n");
    _exit(1);
}

}  // namespace

}  // namespace tumble::tools
