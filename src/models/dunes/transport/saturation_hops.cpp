#include "models/dunes/transport/saturation_hops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace fumon {

namespace {

/// A cell of the spread, in cells².
constexpr double spline_variance = 0.25;

/// Of what arrives, what stays on sand at most.
constexpr double most_that_stays = 0.35;

/// Of the sand that is lifted in a step, what is in the air after it at most.
constexpr double most_in_air = 0.28;

/// No saturation length is shorter, in cells: below half a cell nothing can hop.
constexpr double least_cells = 0.6;

constexpr int most_moves = 16;

double longer_side(const DuneGround& ground) {
    return std::max(ground.dx, ground.dy);
}

}  // namespace

bool hops_saturate(const DunesParameters& parameters) {
    return parameters.transport == DuneTransport::continuous &&
           parameters.saturation_length.word != "hops";
}

double saturation_length(const DunesParameters& parameters, const DuneGround& ground) {
    if (!hops_saturate(parameters)) return parameters.hop_length / parameters.deposit_on_sand;
    constexpr double usual = 1.3;  // m
    return parameters.saturation_length.is_word() ? std::max(usual, longer_side(ground))
                                                  : parameters.saturation_length.value;
}

SaturationHops saturation_hops(const DunesParameters& parameters, const DuneGround& ground,
                               double wind_x, double wind_y) {
    const double p = parameters.deposit_on_sand;
    SaturationHops hops;
    if (!hops_saturate(parameters)) {
        hops.length = parameters.hop_length;
        hops.kept = 1.0 - p;
        return hops;
    }
    const double saturation = saturation_length(parameters, ground);
    hops.landing = std::min(1.0, most_that_stays / p);
    const double stays = hops.landing * p;
    double in_air = 1.0 - stays;
    for (; in_air > most_in_air && hops.moves < most_moves; ++hops.moves) in_air *= 1.0 - stays;
    hops.kept = stays * in_air / (1.0 - in_air);
    const double cell = std::sqrt(ground.dx * ground.dx * wind_x * wind_x +
                                  ground.dy * ground.dy * wind_y * wind_y);
    if (saturation * 2.0 * stays >= cell) {
        const double of_hops = (2.0 - stays) / (2.0 * stays);
        const double root = std::sqrt(saturation * saturation - 0.5 * of_hops * cell * cell);
        hops.length = (saturation + root) / (2.0 * of_hops);
    } else {
        hops.length = (saturation - 0.5 * cell) * stays / (1.0 - stays);
        const double variance = hops.length * (cell - hops.length);
        hops.spread_x = std::min(variance / (ground.dx * ground.dx), spline_variance);
        hops.spread_y = std::min(variance / (ground.dy * ground.dy), spline_variance);
    }
    hops.ends = hops.length / (p * saturation);
    return hops;
}

void check_saturation(const DunesParameters& parameters, const DuneGround& ground) {
    if (!hops_saturate(parameters)) {
        if (parameters.transport == DuneTransport::slabs &&
            !parameters.saturation_length.is_word()) {
            throw KeyError("model.saturation_length",
                           "slabs hop by model.hop_length; leave model.saturation_length out, or "
                           "write model.transport = \"continuous\"");
        }
        return;
    }
    if (parameters.hop_length != DunesParameters{}.hop_length) {
        throw KeyError("model.hop_length",
                       "hops follow from model.saturation_length; leave model.hop_length out, or "
                       "write model.saturation_length = \"hops\"");
    }
    const double saturation = saturation_length(parameters, ground);
    const double cell = longer_side(ground);
    if (saturation < least_cells * cell) {
        throw KeyError("model.saturation_length",
                       fmt::format("cells of {:.4g} m cannot resolve a saturation length of {:.4g} "
                                   "m; take {:.4g} m or more, or smaller cells",
                                   cell, saturation, least_cells * cell));
    }
    const double widest = std::max(ground.nx * ground.dx, ground.ny * ground.dy);
    if (saturation > widest) {
        throw KeyError("model.saturation_length",
                       fmt::format("a saturation length of {:.4g} m exceeds the box of {:.4g} m; "
                                   "take a wider grid or a shorter length",
                                   saturation, widest));
    }
}

}  // namespace fumon
