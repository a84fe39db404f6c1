// The fused multiply-add: a * b + c with a single rounding. Its bits are the same whether the processor has the
// instruction or the C library computes it. All other code is compiled without contraction to fused operations.
#pragma once

#include <cmath>

namespace tumble {

inline float fused_multiply_add(float a, float b, float c) { return std::fma(a, b, c); }
inline double fused_multiply_add(double a, double b, double c) { return std::fma(a, b, c); }

// a * b - c * d within 1.5 ulp, by Kahan's algorithm [Jeannerod, Louvet, Muller 2013].
inline double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    const double rounding = fused_multiply_add(-c, d, cd);
    return fused_multiply_add(a, b, -cd) + rounding;
}

}  // namespace tumble
