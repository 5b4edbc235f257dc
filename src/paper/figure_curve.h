#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numerics/curve_law.h"
#include "paper/figure_plan.h"

namespace fumon {

/// The points of one curve as they are drawn.
struct CurvePoints {
    std::string name;  ///< in the legend; may be empty
    std::string x_name, x_unit;
    std::string y_name, y_unit;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> spread;  ///< of y, as its settings say, not finite for n = 1; empty: none
    std::vector<std::int64_t> counts;  ///< rows behind each point; empty where rows are points
    /// Runs behind each point, or rows of a file; empty where rows are points, or a file's have no
    /// spread.
    std::vector<std::int64_t> runs;
    std::string formula;  ///< whose line it is, with its constants; empty: of data
    std::optional<CurveLaw> law;
    double law_low = 0.0;  ///< x between which it was fitted
    double law_high = 0.0;
};

/// The curves of a table: one, or one for each value of the column group_by in the order in which
/// they come up. Rows without a number in x or y are missing data:
/// points that are not finite, which break a line and count for nothing else. Averaged points are
/// in the order of x; else they stay in the order of the rows. Throws InputError without a place
/// for a wrong condition and where no row is left, Error where a law cannot be fitted.
std::vector<CurvePoints> curve_points(const CurvePlan& curve, const Table& table);

/// The points as CSV, without missing ones: x, y, and where there are any the spread and the rows
/// behind a point; a law's values stand above in lines that begin with '#'.
std::string curve_csv(const CurvePoints& points);

}  // namespace fumon
