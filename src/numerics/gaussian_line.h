#pragma once

#include <span>
#include <vector>

namespace fumon {

/// A line smoothed by a Gaussian of standard deviation `sigma` sites (above 0), cut off at 4 sigma
/// and of weight 1. Past its ends the line goes on with its other end where it is periodic, else
/// mirrored, its end sites twice (… b a | a b …).
std::vector<double> gaussian_smoothed(std::span<const double> line, double sigma, bool periodic);

}  // namespace fumon
