#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

/// Passes over the values of a row, written for vectors. All targets give the same bits.
namespace fumon::row_passes {

constexpr std::size_t lanes = 8;

/// How many doubles past its end an array may be written to where values are kept.
constexpr std::size_t slack = 8;

/// Eight sums side by side that carry what each addition rounds away (Neumaier 1974); value x of a
/// row is added to sum x mod 8.
struct Sums {
    std::array<double, lanes> sum{};
    std::array<double, lanes> lost{};
    std::array<double, lanes> lowest = all(std::numeric_limits<double>::infinity());
    std::array<double, lanes> highest = all(-std::numeric_limits<double>::infinity());

  private:
    static constexpr std::array<double, lanes> all(double value) {
        std::array<double, lanes> values{};
        values.fill(value);
        return values;
    }
};

/// Adds a row's values, and notes the extremes.
void add(std::span<const double> values, Sums& sums);

/// Adds the squares of a row's departures from a mean; no extremes.
void add_squares(std::span<const double> values, double mean, Sums& sums);

/// The highest of some values, and `least` where none is higher.
double highest(std::span<const double> values, double least);

/// The highest magnitude of some values.
double highest_magnitude(std::span<const double> values);

/// out[x] = row[x + 1] − row[x], one less than there are values.
void differences(std::span<const double> row, double* out);

/// The values above `level`, times `sign` ±1, in order; how many they are.
std::size_t keep_above(std::span<const double> values, double sign, double level, double* kept);

struct Kept {
    std::size_t count = 0;
    std::size_t below = 0;
};

/// The values from `low` to `high`, in order; how many they are, and how many are lower.
Kept keep_between(std::span<const double> values, double low, double high, double* kept);

/// Bit x mod 64 of words[x / 64]: whether values[x] > level; the last word's other bits are 0.
void mark_above(std::span<const double> values, double level, std::uint64_t* words);

/// s_x², s_x s_y and s_y² of the sites 2 … nx − 3 of a row, from the five rows about it, the
/// southernmost first; s is the slope by the four neighbours each way.
void slope_products(const std::array<const double*, 5>& rows, std::size_t nx, double* xx,
                    double* xy, double* yy);

}  // namespace fumon::row_passes
