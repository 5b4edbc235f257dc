#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "keys/word_or_real.h"
#include "numerics/contour_lines.h"

namespace fumon {

/// Lines of equal height over a snapshot's ground: a plain value.
struct GroundContours {
    /// By level, the lowest first. Cells' middles are whole numbers; lines end at the ground's
    /// edges, half a cell beyond the outermost middles.
    std::vector<ContourLine> lines;
    double interval = 1.0;  ///< metres, or model heights where there are no metres
    int nx = 0;             ///< cells of the ground
    int ny = 0;
};

/// Those at whole multiples of the interval that `asked` gives, "auto" being a round one with up to
/// 16 lines; nothing for "none", and for even ground. Throws InputError where they would be more
/// than 1,000 levels.
std::optional<GroundContours> ground_contours(const WordOrReal& asked, const Snapshot& snapshot);

/// Whether a level has a thick line and labels: every fifth, counted from 0.
bool is_index_contour(double level, double interval);

/// "1,250", with as many decimals as the interval has.
std::string contour_label(double level, double interval);

}  // namespace fumon
