#include "measure/pile/pile_groups.h"

#include <memory>
#include <optional>

#include "base/snapshot_lookup.h"
#include "measure/pile/avalanche_sizes.h"
#include "measure/pile/pile_shape.h"
#include "measure/pile/power_law.h"

namespace fumon {

namespace {

/// The drop site, or the middle of the bed as Higashi & Takamori (2003) have it.
BedPoint drop_point(const Snapshot& snapshot) {
    return {number_of(snapshot, "drop_x").value_or(snapshot.bed.nx() / 2),
            number_of(snapshot, "drop_y").value_or(snapshot.bed.ny() - 1 - snapshot.bed.ny() / 2)};
}

struct Counted {
    AvalancheSizes sizes;
    std::optional<Avalanche> last;
};

void serialise_counted(Counted& counted, StateArchive& archive) {
    std::vector<std::int64_t> sizes;
    std::vector<std::int64_t> counts;
    for (const SizeBin& bin : counted.sizes.bins()) {
        sizes.push_back(bin.size);
        counts.push_back(bin.count);
    }
    std::vector<std::int64_t> last;
    if (counted.last)
        last = {counted.last->grain, counted.last->size, counted.last->duration,
                counted.last->topplings, counted.last->lost};
    archive.list("avalanche_sizes", sizes);
    archive.list("avalanche_counts", counts);
    archive.list("last_avalanche", last);
    constexpr std::size_t numbers_of_avalanche = 5;
    if (counts.size() != sizes.size() || (!last.empty() && last.size() != numbers_of_avalanche))
        archive.refuse("its lists of avalanches are inconsistent");
    counted = {};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] < 1 || sizes[i] > largest_avalanche || counts[i] < 0)
            archive.refuse("it has an avalanche of an impossible size");
        counted.sizes.add(sizes[i], counts[i]);
    }
    if (!last.empty()) counted.last = Avalanche{last[0], last[1], last[2], last[3], last[4]};
}

struct PileMeasures {
    double dropped_grains = undefined;
    double lost_grains = undefined;
    PileShape shape;
};

struct AvalancheMeasures {
    std::optional<Avalanche> last;
    std::int64_t count = 0;
    std::int64_t largest = 0;
    LineFit raw;
    LineFit logarithmic;
    LikelihoodFit likelihood;
};

double of_last(const AvalancheMeasures& all, std::int64_t Avalanche::*count) {
    return all.last ? static_cast<double>(*all.last.*count) : undefined;
}

}  // namespace

MeasureGroup pile_group() {
    return group_of<PileMeasures>(
        [](const Snapshot& snapshot) {
            return PileMeasures{number_of(snapshot, "dropped_grains").value_or(undefined),
                                number_of(snapshot, "lost_grains").value_or(undefined),
                                pile_shape(snapshot.bed, drop_point(snapshot))};
        },
        {{"resident_grains", "grains", "sum of the heights",
          [](const PileMeasures& pile) { return pile.shape.resident_grains; }},
         {"dropped_grains", "grains", "since the start", &PileMeasures::dropped_grains},
         {"lost_grains", "grains", "gone over the edge since the start",
          &PileMeasures::lost_grains},
         {"covered_cells", "cells", "cells with a grain on them",
          [](const PileMeasures& pile) { return static_cast<double>(pile.shape.covered_cells); }},
         {"footprint_axis_ratio", "", "shorter over longer axis of the covered cells",
          [](const PileMeasures& pile) { return pile.shape.axis_ratio; }},
         {"drop_cone_r_squared", "", "of the best cone that stands on the first drop site",
          [](const PileMeasures& pile) { return pile.shape.drop_cone.r_squared; }},
         {"cone_r_squared", "", "of the best cone anywhere",
          [](const PileMeasures& pile) { return pile.shape.cone.r_squared; }},
         {"cone_height", "heights", "its apex",
          [](const PileMeasures& pile) { return pile.shape.cone.height; }},
         {"cone_slope", "heights/site", "fall of its sides",
          [](const PileMeasures& pile) { return pile.shape.cone.slope; }},
         {"cone_angle", "degrees", "of its sides, heights taken as tall as cells",
          [](const PileMeasures& pile) { return pile.shape.cone.angle; }},
         {"cone_offset", "sites", "of its apex from the first drop site",
          [](const PileMeasures& pile) { return pile.shape.offset; }},
         {"cone_offset_azimuth", "degrees", "clockwise from north",
          [](const PileMeasures& pile) { return pile.shape.offset_azimuth; }}});
}

MeasureGroup avalanche_group() {
    const auto counted = std::make_shared<Counted>();
    MeasureGroup group = group_of<AvalancheMeasures>(
        [counted](const Snapshot&) {
            return AvalancheMeasures{counted->last,
                                     counted->sizes.avalanches(),
                                     counted->sizes.largest(),
                                     fit_raw_bins(counted->sizes),
                                     fit_logarithmic_bins(counted->sizes),
                                     fit_likelihood(counted->sizes)};
        },
        {{"avalanches", "", "since the start",
          [](const AvalancheMeasures& all) { return static_cast<double>(all.count); }},
         {"last_avalanche_size", "cells", "cells whose height changed",
          [](const AvalancheMeasures& all) { return of_last(all, &Avalanche::size); }},
         {"last_avalanche_duration", "", "rounds of toppling until rest",
          [](const AvalancheMeasures& all) { return of_last(all, &Avalanche::duration); }},
         {"last_avalanche_topplings", "", "cells that toppled, each as often as it did",
          [](const AvalancheMeasures& all) { return of_last(all, &Avalanche::topplings); }},
         {"largest_avalanche_size", "cells", "since the start",
          [](const AvalancheMeasures& all) { return static_cast<double>(all.largest); }},
         {"size_slope_least_squares", "", "log-log slope of A_p over A_s in 10 to 100",
          [](const AvalancheMeasures& all) { return all.raw.slope; }},
         {"size_slope_least_squares_r_squared", "", "of that line",
          [](const AvalancheMeasures& all) { return all.raw.r_squared; }},
         {"size_slope_logarithmic_bins", "", "the same through bins that widen by a factor",
          [](const AvalancheMeasures& all) { return all.logarithmic.slope; }},
         {"size_slope_likelihood", "", "minus the exponent of largest likelihood, 10 to 100",
          [](const AvalancheMeasures& all) { return -all.likelihood.exponent; }}});
    group.note = [counted](std::span<const Avalanche> avalanches) {
        if (avalanches.empty()) return;
        counted->sizes.add(avalanches);
        counted->last = avalanches.back();
    };
    group.serialise = [counted](StateArchive& archive) { serialise_counted(*counted, archive); };
    return group;
}

}  // namespace fumon
