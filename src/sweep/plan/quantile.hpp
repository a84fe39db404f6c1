// Quantiles of distributions, with the same bits on every machine.
#pragma once

namespace tumble::sweep {

// The logarithm of a positive number, with a relative error of some 1e-15.
double natural_logarithm(double x);

// The number below which a normal number of mean 0 and deviation 1 lies with the probability `u`, in (0, 1). The
// absolute error of the probability is below 1e-15.
double normal_quantile(double u);

}  // namespace tumble::sweep
