#include "measure/pile/avalanche_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr int resamples = 200;

std::string number(double value) {
    return std::isnan(value) ? "undefined" : fmt::format("{:.4g}", value);
}

Json line_json(const LineFit& line) {
    return {{"slope", line.slope},
            {"standard_error", line.standard_error},
            {"intercept_log10", line.intercept},
            {"r_squared", line.r_squared},
            {"points", line.points}};
}

}  // namespace

AvalancheFits fit_avalanches(const AvalancheSizes& sizes, SizeWindow window) {
    return {window, fit_raw_bins(sizes, window), fit_logarithmic_bins(sizes, window),
            fit_likelihood(sizes, window), power_law_probability(sizes, window, resamples)};
}

std::string avalanche_text(const AvalancheSizes& sizes, const AvalancheFits& fits) {
    std::string text = fmt::format("{} avalanches, the largest of {} cells\n\n", sizes.avalanches(),
                                   sizes.largest());
    text += "sizes (cells)      count  share of the avalanches per size\n";
    for (const LogarithmicBin& bin : sizes.logarithmic_bins()) {
        const std::string range = bin.low == bin.high ? fmt::format("{}", bin.low)
                                                      : fmt::format("{} to {}", bin.low, bin.high);
        text += fmt::format("{:<16} {:>8}  {}\n", range, bin.count, number(bin.density));
    }
    const LikelihoodFit& law = fits.likelihood;
    text += fmt::format(
        "\nA power law in {} to {} cells?\n"
        "least squares, a point a size      slope {} +- {}   R2 {}\n"
        "least squares, logarithmic bins    slope {} +- {}   R2 {}\n"
        "largest likelihood                 slope {} +- {}   {} avalanches in the window\n"
        "goodness of fit                    Kolmogorov-Smirnov distance {}, probability {} "
        "({} resamples)\n",
        fits.window.low, fits.window.high, number(fits.raw.slope), number(fits.raw.standard_error),
        number(fits.raw.r_squared), number(fits.logarithmic.slope),
        number(fits.logarithmic.standard_error), number(fits.logarithmic.r_squared),
        number(-law.exponent), number(law.standard_error), law.avalanches, number(law.distance),
        number(fits.probability), resamples);
    if (fits.probability < 0.1) {
        text +=
            "A probability below 0.1 says that the sizes are no exact power law there, however "
            "straight the\nline looks: with many avalanches small departures tell.\n";
    }
    return text;
}

std::string avalanche_json(const std::string& file, const AvalancheSizes& sizes,
                           const AvalancheFits& fits) {
    Json json{{"file", file},
              {"avalanches", sizes.avalanches()},
              {"largest_size", sizes.largest()},
              {"window", {fits.window.low, fits.window.high}},
              {"least_squares", line_json(fits.raw)},
              {"least_squares_logarithmic_bins", line_json(fits.logarithmic)},
              {"likelihood",
               {{"exponent", fits.likelihood.exponent},
                {"standard_error", fits.likelihood.standard_error},
                {"avalanches", fits.likelihood.avalanches},
                {"kolmogorov_smirnov_distance", fits.likelihood.distance},
                {"probability", fits.probability},
                {"resamples", resamples}}}};
    for (const SizeBin& bin : sizes.bins())
        json["bins"].push_back({{"size", bin.size}, {"count", bin.count}, {"share", bin.share}});
    for (const LogarithmicBin& bin : sizes.logarithmic_bins()) {
        json["logarithmic_bins"].push_back({{"low", bin.low},
                                            {"high", bin.high},
                                            {"count", bin.count},
                                            {"size", bin.size},
                                            {"density", bin.density}});
    }
    return json.dump(2) + "\n";
}

}  // namespace fumon
