#pragma once

#include <string>

#include "measure/pile/avalanche_sizes.h"
#include "measure/pile/power_law.h"

namespace fumon {

/// Power laws fitted to avalanche sizes in three ways, and how likely an exact one is.
struct AvalancheFits {
    SizeWindow window;
    LineFit raw;          ///< least squares, a point a size
    LineFit logarithmic;  ///< least squares, logarithmic bins
    LikelihoodFit likelihood;
    double probability = 0.0;  ///< of a larger Kolmogorov-Smirnov distance by chance
};

AvalancheFits fit_avalanches(const AvalancheSizes& sizes, SizeWindow window);

/// The sizes in logarithmic bins and the fits, as a page to read.
std::string avalanche_text(const AvalancheSizes& sizes, const AvalancheFits& fits);

/// The same as JSON, with every size; `file` is what they were read from.
std::string avalanche_json(const std::string& file, const AvalancheSizes& sizes,
                           const AvalancheFits& fits);

}  // namespace fumon
