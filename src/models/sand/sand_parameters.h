#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

class KeyTable;

enum class HopOrder { synchronous, random_sequential };
enum class HopLength { linear, slope, exponential, tabulated };
enum class HopAmount { constant, slope };
enum class Landing { truncate, round, split, truncate_terms };
enum class SlopeDifference { central, backward, forward };
enum class Creep { every_cell, maxima_only, profile, none };
enum class Shadow { none, upwind_higher };

/// The parameters of the wind-blown sand family. Heights h and lengths are in model heights and
/// sites; the slope is ∂h/∂x along the wind.
struct SandParameters {
    HopOrder order = HopOrder::synchronous;

    HopLength hop_length = HopLength::linear;
    double hop_base = 5.0;             ///< L0: sites
    double hop_per_height = 2.0;       ///< b: sites per height; linear: L = L0 + b·h
    double hop_slope_factor = 5.0;     ///< α: sites; slope: L = L0 − α·tanh(∂h/∂x)
    double exponential_base = 5.4;     ///< a: per millimetre (Terada 2025, eq. 45)
    double exponential_height = 0.25;  ///< h0: millimetres; one model height is 2·h0
    double exponential_length =
        100.0;  ///< N'x: sites; L = (N'x/10)·(a^(2·h0·h) − 1)/(a^(2·h0) − 1)
    std::vector<double> hop_table_heights;  ///< tabulated: heights, rising
    std::vector<double> hop_table_lengths;  ///< sites, one for each of them
    Landing landing = Landing::round;

    HopAmount hop_amount = HopAmount::constant;
    double amount = 0.1;               ///< q0: heights
    double amount_slope_factor = 0.1;  ///< β: heights; slope: q = q0 + β·tanh(∂h/∂x)
    bool limit_amount = true;          ///< never more than is there

    SlopeDifference slope_difference = SlopeDifference::central;
    Creep creep = Creep::every_cell;
    double creep_rate = 0.15;  ///< D: share per step
    double flank_rate = 0.05;  ///< E: share per step, of the profile's creep
    Shadow shadow = Shadow::none;
};

/// Lists the keys model.* bound to these parameters.
void list_keys(SandParameters& parameters, KeyTable& table);

}  // namespace fumon
