#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keys/word_or_real.h"

namespace fumon {

enum class CellText { none, value, count, value_and_count };
enum class BarHeight { count, share, density };
enum class DistributionShape { box, violin };

/// What a panel's chart is: a heat map, a histogram, a box plot, a difference of two beds.
struct ChartSettings {
    // heat maps
    CellText cell_text = CellText::none;
    bool even_cells = false;           ///< as wide as each other, whatever their values
    std::vector<double> levels;        ///< lines where the quantity has these values, rising
    std::vector<std::string> classes;  ///< names of what lies between them, one more

    // histograms
    std::int64_t bins = 0;  ///< 0: as many as NumPy's "auto"
    WordOrReal bin_low{"auto", 0.0};
    WordOrReal bin_high{"auto", 0.0};
    BarHeight bar_height = BarHeight::count;

    // box plots
    DistributionShape shape = DistributionShape::box;
    bool show_values = false;  ///< every value as a point

    // differences
    std::string name;  ///< of what is shown; empty: by its changes or its step
    std::string minus_name;
    std::string minus_scene;             ///< of what is taken away; empty: the panel's own
    std::vector<std::string> minus_set;  ///< "key=value": changes to it
    std::int64_t minus_step = -1;        ///< −1: that which is shown

    bool share_axes = false;     ///< with neighbours that say so
    bool share_colours = false;  ///< with the other panels that say so
};

}  // namespace fumon
