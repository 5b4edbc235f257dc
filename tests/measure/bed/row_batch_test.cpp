#include "measure/bed/row_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "support/measured_beds.h"

namespace fumon {
namespace {

constexpr std::size_t rows = RowBatch::rows;

Grid bed_of_rows(const std::vector<std::vector<double>>& heights) {
    return test::bed_of(
        static_cast<int>(heights.front().size()), static_cast<int>(heights.size()),
        [&](int x, int y) {
            return heights[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        });
}

std::vector<double> row_of(const RowBatch& batch, std::size_t place) {
    std::vector<double> row;
    for (std::size_t x = 0; x < batch.nx(); ++x) row.push_back(batch.values()[x * rows + place]);
    return row;
}

/// A row's departures from its mean or its least-squares line, site after site.
std::vector<double> departures_of(std::span<const double> row, bool periodic) {
    const auto count = static_cast<double>(row.size());
    const double middle = 0.5 * (count - 1.0);
    double mean = 0.0;
    for (const double height : row) mean += height;
    mean /= count;
    double moment = 0.0;
    for (std::size_t x = 0; x < row.size(); ++x)
        moment += (static_cast<double>(x) - middle) * (row[x] - mean);
    const double slope =
        periodic || row.size() < 2 ? 0.0 : 12.0 * moment / (count * (count * count - 1.0));
    std::vector<double> departures;
    for (std::size_t x = 0; x < row.size(); ++x)
        departures.push_back(row[x] - mean - slope * (static_cast<double>(x) - middle));
    return departures;
}

/// Sites above the mean + sd/2 after one below the mean − sd/2, gone twice round a periodic row.
std::vector<int> crossings_of(const std::vector<double>& departures, bool periodic) {
    double squares = 0.0;
    for (const double departure : departures) squares += departure * departure;
    const auto nx = static_cast<int>(departures.size());
    const double threshold = 0.5 * std::sqrt(squares / nx);
    std::vector<int> sites;
    bool armed = false;
    for (int x = periodic ? -nx : 0; x < nx; ++x) {
        const double departure = departures[static_cast<std::size_t>((x + nx) % nx)];
        if (departure < -threshold) armed = true;
        if (!armed || !(departure > threshold)) continue;
        armed = false;
        if (x >= 0) sites.push_back(x);
    }
    return sites;
}

/// Highest minus lowest site of what lies between each crossing and the next.
std::vector<double> reliefs_of(const std::vector<double>& departures, std::vector<int> sites,
                               bool periodic) {
    const auto nx = static_cast<int>(departures.size());
    if (periodic && !sites.empty()) sites.push_back(sites.front() + nx);
    std::vector<double> reliefs;
    for (std::size_t wave = 1; wave < sites.size(); ++wave) {
        double lowest = 1e300;
        double highest = -1e300;
        for (int x = sites[wave - 1]; x < sites[wave]; ++x) {
            lowest = std::min(lowest, departures[static_cast<std::size_t>(x % nx)]);
            highest = std::max(highest, departures[static_cast<std::size_t>(x % nx)]);
        }
        reliefs.push_back(highest - lowest);
    }
    return reliefs;
}

TEST(RowBatch, EachRowIsMeasuredAsByItself) {
    for (const bool periodic : {true, false}) {
        for (const int nx : {3, 5, 7, 64, 101}) {
            const Grid bed = test::sum(test::noise(nx, 8, 5), test::waves(nx, 8, 3.0, 1.0), 0.4);
            RowBatch batch(static_cast<std::size_t>(nx));
            std::array<RowWaves, rows> waves;
            for (const int count : {8, 5}) {
                batch.take(bed, 8 - count, count);
                batch.detrend(periodic);
                find_waves(batch, periodic, waves);
                for (int k = 0; k < count; ++k) {
                    const auto place = static_cast<std::size_t>(k);
                    const auto departures = departures_of(bed.row(8 - count + k), periodic);
                    const auto sites = crossings_of(departures, periodic);
                    EXPECT_EQ(row_of(batch, place), departures);
                    ASSERT_EQ(waves[place].crossings, static_cast<int>(sites.size())) << nx;
                    EXPECT_EQ(waves[place].reliefs, reliefs_of(departures, sites, periodic));
                    if (sites.empty()) continue;
                    EXPECT_EQ(waves[place].first, sites.front());
                    EXPECT_EQ(waves[place].last, sites.back());
                }
                for (auto place = static_cast<std::size_t>(count); place < rows; ++place)
                    EXPECT_EQ(row_of(batch, place), std::vector<double>(batch.nx(), 0.0));
            }
        }
    }
}

TEST(RowBatch, CrossingsAreTheFirstSitesAboveAfterOneBelow) {
    const Grid bed = bed_of_rows({{2, -1, 0.5, -1, 2, 0, 2, -2, -1, -1.5}});  // threshold 0.72
    RowBatch batch(10);
    std::array<RowWaves, rows> waves;
    for (const bool periodic : {true, false}) {
        batch.take(bed, 0, 1);
        batch.detrend(true);
        find_waves(batch, periodic, waves);
        EXPECT_EQ(waves[0].first, periodic ? 0 : 4);  // 0: the row ends below
        EXPECT_EQ(waves[0].last, 4);
        EXPECT_EQ(waves[0].crossings, periodic ? 2 : 1);
        EXPECT_EQ(waves[0].reliefs, periodic ? (std::vector<double>{3, 4}) : std::vector<double>());
    }
}

TEST(RowBatch, DeparturesAreZeroWhereOnlyRoundingIsLeft) {
    std::vector<double> slope(7);
    for (std::size_t x = 0; x < 7; ++x) slope[x] = 0.3 * static_cast<double>(x) - 4.0;
    const Grid bed = bed_of_rows({std::vector<double>(7, 0.1), slope});
    RowBatch batch(7);
    batch.take(bed, 0, 2);
    batch.detrend(false);
    EXPECT_EQ(row_of(batch, 0), std::vector<double>(7, 0.0));
    EXPECT_EQ(row_of(batch, 1), std::vector<double>(7, 0.0));
    batch.take(bed, 0, 2);
    batch.detrend(true);
    EXPECT_EQ(row_of(batch, 0), std::vector<double>(7, 0.0));
    EXPECT_NEAR(row_of(batch, 1)[0], -0.9, 1e-15);
    EXPECT_NEAR(batch.squares()[1], 2.0 * (0.9 * 0.9 + 0.6 * 0.6 + 0.3 * 0.3), 1e-14);
}

TEST(RowBatch, SmoothRowsAreMeansOfTheSitesAround) {
    const Grid bed = test::noise(23, 3, 9);
    RowBatch batch(23);
    Grid smoothed(23, 3);
    for (const bool periodic : {true, false}) {
        batch.take(bed, 0, 3);
        batch.smooth(periodic, 4);
        batch.put(smoothed, 0, 3);
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 23; ++x) {
                double sum = 0.0;
                for (int i = x - 4; i <= x + 4; ++i)
                    sum += bed(periodic ? (i + 23) % 23 : std::clamp(i, 0, 22), y);
                EXPECT_NEAR(smoothed(x, y), sum / 9.0, 1e-14) << x << ' ' << y;
            }
        }
    }
}

}  // namespace
}  // namespace fumon
