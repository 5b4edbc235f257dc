#pragma once

namespace fumon::elementary {

/// Elementary functions whose bits do not depend on the CPU: plain IEEE double arithmetic in a
/// fixed order, never the system library's (whose results change with the presence of FMA). Each is
/// within 2 units in the last place of the true value; tested against long double.
double exp(double x);
double log(double x);
double tanh(double x);
double pow(double base, double exponent);
double sin(double x);
double cos(double x);

}  // namespace fumon::elementary
