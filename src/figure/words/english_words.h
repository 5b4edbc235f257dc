#pragma once

#include <array>
#include <string_view>

namespace fumon {

/// Every word and phrase that fumon itself writes into pictures and captions, in English; "{}" are
/// places for numbers and names. A table of another language (assets/words) has each of them.
inline constexpr std::array english_words = std::to_array<std::string_view>({
    // arrows and scale bars
    "N",
    "E",
    "S",
    "W",
    "wind",
    "drift",
    "flow",
    "1 site",
    " at the middle",
    // colours
    "height",
    "change of height",
    "slope",
    "depth",
    "water depth",
    "speed",
    "Froude number",
    "drainage area",
    "log10 m²",
    "log10 cells",
    ", ends of this frame",
    // axes and panels
    "x",
    "y",
    "z",
    "t",
    "distance",
    "step",
    "bed",
    "water",
    "stress",
    "cosine fit",
    "flight length",
    "launch height h",
    "Velocity of the air",
    "Pressure",
    "Shear stress over the bed",
    "Flight length over the bed",
    "Flight length and height",
    "Paths of grains",
    // plates and titles
    "heights × {}",
    "t = {}",
    "step {}",
    "step {}, {}",
    "t = {time},  step {step}",
    "step {step}",
    // captions
    "All: ",
    "{}, inset: ",
    "{} to {}: ",
    "model {}",
    "{} steps",
    "initial bed {}",
    "steps {}",
    "{} to {}",
    "seed {}",
    "seeds {} to {}",
    "curve {}: ",
    "Curve {}: {} over {}",
    ", one for each {}",
    ", where {}",
    " and ",
    ", x times {}",
    ", y plus {}",
    ", y times {}",
    "; from {}",
    "; step {}",
    "colours from {} to {}",
    " (values from {} to {})",
    " (values lie beyond)",
    "contours every {} {}",
    "bars are standard deviations",
    "bars are standard errors of the mean",
    "n = {}",
    "n = {} to {}",
    "{} at x = {}, ",
    "else {}",
    " (fewer: hollow)",
    "points of fewer than {} left out",
    "bars with an arrow reach below zero",
    "bars with an arrow go on beyond the axes",
});

/// Units that are words; symbols of the SI stand as they are where a table has none for them.
inline constexpr std::array english_units = std::to_array<std::string_view>(
    {"sites", "model heights", "heights", "cells", "steps", "grains", "yr", "d", "h", "min", "s"});

}  // namespace fumon
