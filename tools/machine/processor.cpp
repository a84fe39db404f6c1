#include "tools/machine/processor.hpp"

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

}  // namespace tumble::tools
