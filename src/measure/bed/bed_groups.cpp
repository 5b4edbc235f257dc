#include "measure/bed/bed_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/undefined.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/celerity.h"
#include "measure/bed/crest_height.h"
#include "measure/bed/crest_lines.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/dunes.h"
#include "measure/bed/slopes.h"
#include "measure/bed/wavelength.h"

namespace fumon {

namespace {

/// All but the statistics need a bed without holes.
std::vector<double> of_whole_beds(const Snapshot& snapshot, std::size_t columns,
                                  const std::function<std::vector<double>()>& values) {
    return snapshot.nodata.empty() ? values() : std::vector<double>(columns, undefined);
}

}  // namespace

MeasureGroup statistics_group() {
    return {{{"mean_height", "heights", "mean of the bed"},
             {"standard_deviation", "heights", "of the heights over all cells"},
             {"minimum_height", "heights", "lowest cell"},
             {"maximum_height", "heights", "highest cell"},
             {"total_sand", "heights x cells", "sum of the heights"}},
            [](const Snapshot& snapshot) -> std::vector<double> {
                const BedStatistics bed = bed_statistics(snapshot.bed, snapshot.nodata);
                return {bed.mean, bed.standard_deviation, bed.minimum, bed.maximum, bed.total};
            }};
}

MeasureGroup wave_group() {
    std::vector<MeasureColumn> columns{
        {"wavelength_spectrum", "sites", "along x: centroid of the power spectrum's peak"},
        {"wavelength_autocorrelation", "sites", "along x: first peak of the autocorrelation"},
        {"wavelength_crossings", "sites",
         "along x: upward crossings with hysteresis (mean +- sd/2)"},
        {"top_one_percent_height", "heights", "mean of the highest 1 % of the cells"},
        {"crest_to_trough_height", "heights", "mean over the waves along x"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) {
                return of_whole_beds(snapshot, count, [&]() -> std::vector<double> {
                    const Grid& bed = snapshot.bed;
                    const bool periodic = snapshot.periodic;
                    return {wavelength_spectrum(bed, periodic),
                            wavelength_autocorrelation(bed, periodic),
                            wavelength_crossings(bed, periodic), top_one_percent_mean(bed),
                            crest_to_trough_height(bed, periodic)};
                });
            }};
}

MeasureGroup celerity_group() {
    std::vector<MeasureColumn> columns{
        {"celerity", "sites/step", "downwind, by correlation with the row before"},
        {"celerity_correlation", "", "how well the bed before fits when moved so"}};
    const std::size_t count = columns.size();
    struct Before {
        Grid bed;
        std::int64_t step = 0;
    };
    const auto before = std::make_shared<Before>();
    return {std::move(columns),
            [count, before](const Snapshot& snapshot) {
                return of_whole_beds(snapshot, count, [&]() -> std::vector<double> {
                    Celerity celerity;
                    const std::int64_t steps = snapshot.step - before->step;
                    if (snapshot.periodic && !before->bed.empty() && steps > 0)
                        celerity = celerity_along_x(before->bed, snapshot.bed, steps);
                    *before = {snapshot.bed, snapshot.step};
                    return {celerity.sites_per_step, celerity.correlation};
                });
            },
            {},
            [before](StateCarrier& carrier) {
                std::vector<std::int64_t> size{before->bed.nx(), before->bed.ny()};
                carrier.count("step_measured_before", before->step);
                carrier.values("size_measured_before", std::span(size));
                std::vector<double> heights(before->bed.values().begin(),
                                            before->bed.values().end());
                carrier.list("bed_measured_before", heights);
                constexpr std::int64_t longest = std::int64_t{1} << 30;
                if (size[0] < 0 || size[1] < 0 || size[0] > longest || size[1] > longest ||
                    !std::cmp_equal(size[0] * size[1], heights.size()))
                    carrier.refuse("its bed_measured_before has another size");
                before->bed = Grid(static_cast<int>(size[0]), static_cast<int>(size[1]));
                std::ranges::copy(heights, before->bed.values().begin());
            }};
}

MeasureGroup slope_group() {
    std::vector<MeasureColumn> columns{
        {"stoss_slope", "heights/site", "mean of the sites that rise downwind (face the wind)"},
        {"lee_slope", "heights/site", "mean of the sites that fall downwind"},
        {"steep_stoss_slope", "heights/site", "90th percentile of the rises"},
        {"steep_lee_slope", "heights/site", "90th percentile of the falls"},
        {"stoss_to_lee_slope", "", "above 1: the upwind side is the steeper one"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) {
                return of_whole_beds(snapshot, count, [&]() -> std::vector<double> {
                    const BedSlopes slopes = bed_slopes(snapshot.bed, snapshot.periodic);
                    return {slopes.stoss, slopes.lee, slopes.steep_stoss, slopes.steep_lee,
                            slopes.stoss_to_lee};
                });
            }};
}

MeasureGroup crest_group() {
    std::vector<MeasureColumn> columns{
        {"crest_orientation", "degrees",
         "of the crests against the normal to the wind, counterclockwise"},
        {"crest_coherence", "", "1 where all slopes lie along one line, 0 where none is preferred"},
        {"crest_defects", "", "ends of crest lines, Y-junctions among them"},
        {"crest_defect_density", "1/site", "pairs of ends over the length of all crests"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) {
                return of_whole_beds(snapshot, count, [&]() -> std::vector<double> {
                    const Grid& bed = snapshot.bed;
                    const CrestOrientation crests = crest_orientation(bed, snapshot.periodic);
                    const CrestDefects defects = crest_defects(
                        bed, snapshot.periodic, wavelength_spectrum(bed, snapshot.periodic));
                    return {crests.degrees, crests.coherence, static_cast<double>(defects.ends),
                            defects.defect_density};
                });
            }};
}

MeasureGroup dune_group() {
    std::vector<MeasureColumn> columns{
        {"dune_count", "", "pieces above 0.3 of the highest cell, of 20 cells or more"},
        {"dune_cover", "", "share of the cells above that height"},
        {"dune_area", "cells", "mean over the dunes"},
        {"dune_height", "heights", "mean of their highest cells"},
        {"dune_volume", "heights x cells", "mean over the dunes"},
        {"dune_horns_downwind", "", "share of the dunes whose horns point downwind"},
        {"dune_horn_lag", "sites", "mean way of the two ends downwind of the middle"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) {
                return of_whole_beds(snapshot, count, [&]() -> std::vector<double> {
                    const DuneField field = separate_dunes(snapshot.bed, snapshot.periodic);
                    return {static_cast<double>(field.dunes.size()),
                            field.covered_share,
                            field.mean_area,
                            field.mean_height,
                            field.mean_volume,
                            field.share_horns_downwind,
                            field.mean_horn_lag};
                });
            }};
}

}  // namespace fumon
