// e^x with the same bits on every machine.
#pragma once

namespace tumble::scene {

// The relative error is below 4e-16 where the result is a normal number; infinite above 709.78, 0 below -745.2, NaN of
// NaN.
double exponential(double x);

}  // namespace tumble::scene
