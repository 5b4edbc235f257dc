#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "keys/override.h"
#include "models/air/grain_flight.h"
#include "numerics/hop_law.h"

namespace fumon {

/// How a measured hop law is handed to the sand model.
enum class HopForm { exponential, linear, table, slope };

/// The laws of one set of flights, lengths and heights in millimetres (Terada 2025, section 4).
struct HopFits {
    std::size_t flights = 0;
    ExponentialLaw exponential;
    LinearLaw line;
    double reynolds = 0.0;  ///< the largest particle Reynolds number
};

/// What flights over one bed say of hops, and the scale on which sand hops by them, which is that
/// of Terada (2025, eq. 45): one model height is the bed's range 2 h0, and a hop from the crest by
/// the exponential law is N'x/10 sites, N'x = 100.
struct MeasuredHops {
    std::vector<double> angles;  ///< degrees
    std::vector<HopFits> of_angle;
    HopFits pooled;
    std::vector<HopPoint> points;  ///< of all flights: mm, and slopes as they are
    double height = 0.0;           ///< one model height, 2 h0, mm
    double site = 0.0;             ///< one site, mm

    static constexpr double sites_from_crest = 10.0;  ///< N'x/10
};

/// `flights` are angle by angle, as many of each. Throws Error where they determine no law (all
/// from one height) or do not grow with height (a ≤ 1), which no scale can be taken from.
MeasuredHops measure_hops(std::span<const Flight> flights, std::span<const double> angles);

/// The sand model's keys that make it hop by the law, in sites and model heights. Throws Error for
/// the slope law where flights lengthen with the slope (α < 0), since the dune rule of the model
/// shortens them.
std::vector<Override> law_settings(const MeasuredHops& hops, HopForm form);

/// A short table of the fits, a line an angle and one for all.
std::vector<std::string> fit_lines(const MeasuredHops& hops);

/// The law that was chosen, in a line: its numbers and how well it fits.
std::string law_line(const MeasuredHops& hops, HopForm form);

}  // namespace fumon
