#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// The coefficients of the natural cubic spline through a line of values, in cubic B-splines: of
/// its knots, and of one more beyond each end (Unser 1999, eqs. 12 to 14, with straight ends).
inline std::vector<double> spline_coefficients(const std::vector<double>& values) {
    const std::size_t count = values.size();
    std::vector<double> spline(count + 2);
    const auto at = [&](std::size_t knot) -> double& { return spline[knot + 1]; };
    at(0) = values.front();
    at(count - 1) = values.back();
    if (count > 2) {  // (c₋ + 4c + c₊) / 6 = f inside: Thomas' algorithm
        std::vector<double> upper(count);
        for (std::size_t i = 1; i + 1 < count; ++i) {
            const double pivot = 4.0 - upper[i - 1];
            upper[i] = i + 2 < count ? 1.0 / pivot : 0.0;
            const double known = i + 2 < count ? 0.0 : at(count - 1);
            at(i) = (6.0 * values[i] - known - at(i - 1)) / pivot;
        }
        for (std::size_t i = count - 2; i-- > 1;) at(i) -= upper[i] * at(i + 1);
    }
    const bool alone = count == 1;
    spline.front() = alone ? at(0) : 2.0 * at(0) - at(1);
    spline.back() = alone ? at(0) : 2.0 * at(count - 1) - at(count - 2);
    return spline;
}

/// Resamples values to cells `refinement` times finer, whose centres divide the coarse cells
/// evenly, by the interpolating natural bicubic spline, whose slope and curvature are continuous
/// (C²). Beyond the outermost centres it goes on straight.
inline Grid spline_refined(const Grid& values, int refinement) {
    if (refinement == 1) return values;
    const auto line = [&](const std::vector<double>& coarse) {
        const std::vector<double> spline = spline_coefficients(coarse);
        const auto count = static_cast<int>(coarse.size());
        const auto straight = [&](int knot) {  // beyond its ends the coefficients are on a line
            if (knot < -1) return 2.0 * spline[0] - spline[1];
            if (knot > count) return 2.0 * spline[spline.size() - 1] - spline[spline.size() - 2];
            const int place = knot + 1;
            return spline[static_cast<std::size_t>(place)];
        };
        std::vector<double> fine;
        fine.reserve(coarse.size() * static_cast<std::size_t>(refinement));
        for (int cell = 0; cell < count; ++cell) {
            for (int part = 0; part < refinement; ++part) {
                const double place = (part + 0.5) / refinement - 0.5;
                const int whole = place < 0.0 ? -1 : 0;
                const double t = place - whole;
                const double s = 1.0 - t;
                const std::array<double, 4> weights{
                    s * s * s / 6.0, (4.0 + t * t * (3.0 * t - 6.0)) / 6.0,
                    (4.0 + s * s * (3.0 * s - 6.0)) / 6.0, t * t * t / 6.0};
                double sum = 0.0;
                for (int i = 0; i < 4; ++i)
                    sum += weights[static_cast<std::size_t>(i)] * straight(cell + whole - 1 + i);
                fine.push_back(sum);
            }
        }
        return fine;
    };
    Grid wide(values.nx() * refinement, values.ny());
    std::vector<double> coarse;
    for (int y = 0; y < values.ny(); ++y) {
        const auto row = values.row(y);
        coarse.assign(row.begin(), row.end());
        const std::vector<double> fine = line(coarse);
        for (int x = 0; x < wide.nx(); ++x) wide(x, y) = fine[static_cast<std::size_t>(x)];
    }
    Grid result(wide.nx(), values.ny() * refinement);
    coarse.resize(static_cast<std::size_t>(values.ny()));
    for (int x = 0; x < wide.nx(); ++x) {
        for (int y = 0; y < wide.ny(); ++y) coarse[static_cast<std::size_t>(y)] = wide(x, y);
        const std::vector<double> fine = line(coarse);
        for (int y = 0; y < result.ny(); ++y) result(x, y) = fine[static_cast<std::size_t>(y)];
    }
    return result;
}

}  // namespace fumon
