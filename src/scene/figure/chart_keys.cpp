#include "scene/figure/chart_keys.h"

#include "base/limits.h"

namespace fumon {

void list_chart_keys(ChartSettings& chart, const std::string& path, KeyTable& table) {
    table.choice(path + ".cell_text", chart.cell_text,
                 {{CellText::none, "none", "nothing"},
                  {CellText::value, "value", "the mean of its runs"},
                  {CellText::count, "n", "how many runs it is the mean of"},
                  {CellText::value_and_count, "value-and-n", "both"}},
                 {.help = "what stands in the cells of a heat map"});
    table.boolean(path + ".even_cells", chart.even_cells,
                  {.help = "heat map: all as wide and high as each other; false: from halfway to "
                           "one value to halfway to the next; words are always even"});
    table.real_list(path + ".levels", chart.levels, 0, 100,
                    {.help = "heat map: lines where the quantity, linear between the middles of "
                             "cells, has these values; with classes, where these part; rising"});
    table.text_list(path + ".classes", chart.classes,
                    {.help = "heat map: names of what lies below, between and above the levels, "
                             "one more than they are; each has one colour"});
    table.integer(path + ".bins", chart.bins,
                  {.range = {0, 1000},
                   .help = "of a histogram; 0: by Freedman & Diaconis, or by Sturges where "
                           "those are fewer (NumPy's \"auto\")"});
    table.word_or_real(path + ".bin_low", chart.bin_low, {{"auto", "the least value"}},
                       {.help = "histogram: where the first bin begins; values below are not "
                                "counted, and the caption says so"});
    table.word_or_real(path + ".bin_high", chart.bin_high, {{"auto", "the greatest value"}},
                       {.help = "histogram: where the last bin ends, which belongs to it"});
    table.choice(path + ".bar_height", chart.bar_height,
                 {{BarHeight::count, "count", "how many values"},
                  {BarHeight::share, "share", "of all values that are counted"},
                  {BarHeight::density, "density", "share over the bin's width"}},
                 {.help = "histogram: what its bars tell"});
    table.choice(path + ".shape", chart.shape,
                 {{DistributionShape::box, "box",
                   "quartiles and median; whiskers to the farthest values within 1.5 times the "
                   "box's length; points beyond"},
                  {DistributionShape::violin, "violin",
                   "density (normal distributions as wide as Scott's rule says), with quartiles "
                   "and median"}},
                 {.help = "box-plot: what stands for the values of one x"});
    table.boolean(path + ".show_values", chart.show_values,
                  {.help = "box-plot: every value as a point too"});
    table.text(path + ".name", chart.name,
               {.help = "difference: what it is of; empty: told by set, or the step"});
    table.text(path + ".minus_name", chart.minus_name,
               {.help = "difference: what is taken away; empty: likewise"});
    table.text(path + ".minus_scene", chart.minus_scene,
               {.help = "difference: the scene of what is taken away; empty: the panel's"});
    table.text_list(path + ".minus_set", chart.minus_set,
                    {.help = "difference: \"key=value\": changes to that scene"});
    table.integer(path + ".minus_step", chart.minus_step,
                  {.unit = "steps",
                   .range = {-1, largest_step},
                   .help = "difference: the step of what is taken away; -1: that of steps"});
    table.boolean(path + ".share_axes", chart.share_axes,
                  {.help = "no numbers along a side on which the panel left of it or below, if it "
                           "says so too, has the same axis (map, difference, heat-map)"});
    table.boolean(path + ".share_colours", chart.share_colours,
                  {.help = "one range of colours, and one bar beside the last, with the other "
                           "panels that say so (map, difference, heat-map, scatter)"});
}

}  // namespace fumon
