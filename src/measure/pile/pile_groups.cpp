#include "measure/pile/pile_groups.h"

#include <limits>
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

void carry_counted(Counted& counted, StateCarrier& carrier) {
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
    carrier.list("avalanche_sizes", sizes);
    carrier.list("avalanche_counts", counts);
    carrier.list("last_avalanche", last);
    constexpr std::size_t numbers_of_avalanche = 5;
    if (counts.size() != sizes.size() || (!last.empty() && last.size() != numbers_of_avalanche))
        carrier.refuse("its avalanches do not fit each other");
    counted = {};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] < 1 || sizes[i] > largest_avalanche || counts[i] < 0)
            carrier.refuse("it holds an avalanche of no possible size");
        counted.sizes.add(sizes[i], counts[i]);
    }
    if (!last.empty()) counted.last = Avalanche{last[0], last[1], last[2], last[3], last[4]};
}

}  // namespace

MeasureGroup pile_group() {
    return {{{"resident_grains", "grains", "sum of the heights"},
             {"dropped_grains", "grains", "since the start"},
             {"lost_grains", "grains", "gone over the edge since the start"},
             {"covered_cells", "cells", "cells with a grain on them"},
             {"footprint_axis_ratio", "", "shorter over longer axis of the covered cells"},
             {"drop_cone_r_squared", "", "of the best cone that stands on the first drop site"},
             {"cone_r_squared", "", "of the best cone anywhere"},
             {"cone_height", "heights", "its apex"},
             {"cone_slope", "heights/site", "fall of its sides"},
             {"cone_angle", "degrees", "of its sides, heights taken as tall as cells"},
             {"cone_offset", "sites", "of its apex from the first drop site"},
             {"cone_offset_azimuth", "degrees", "clockwise from north"}},
            [](const Snapshot& snapshot) -> std::vector<double> {
                constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
                const PileShape pile = pile_shape(snapshot.bed, drop_point(snapshot));
                return {pile.resident_grains,
                        number_of(snapshot, "dropped_grains").value_or(unknown),
                        number_of(snapshot, "lost_grains").value_or(unknown),
                        static_cast<double>(pile.covered_cells),
                        pile.axis_ratio,
                        pile.drop_cone.r_squared,
                        pile.cone.r_squared,
                        pile.cone.height,
                        pile.cone.slope,
                        pile.cone.angle,
                        pile.offset,
                        pile.offset_azimuth};
            }};
}

MeasureGroup avalanche_group() {
    const auto counted = std::make_shared<Counted>();
    return {{{"avalanches", "", "since the start"},
             {"last_avalanche_size", "cells", "cells whose height changed"},
             {"last_avalanche_duration", "", "rounds of toppling until rest"},
             {"last_avalanche_topplings", "", "cells that toppled, each as often as it did"},
             {"largest_avalanche_size", "cells", "since the start"},
             {"size_slope_least_squares", "", "log-log slope of A_p over A_s in 10 to 100"},
             {"size_slope_least_squares_r_squared", "", "of that line"},
             {"size_slope_logarithmic_bins", "", "the same through bins that widen by a factor"},
             {"size_slope_likelihood", "", "minus the exponent of largest likelihood, 10 to 100"}},
            [counted](const Snapshot&) -> std::vector<double> {
                constexpr double none = std::numeric_limits<double>::quiet_NaN();
                const auto& last = counted->last;
                const LineFit raw = fit_raw_bins(counted->sizes);
                return {static_cast<double>(counted->sizes.avalanches()),
                        last ? static_cast<double>(last->size) : none,
                        last ? static_cast<double>(last->duration) : none,
                        last ? static_cast<double>(last->topplings) : none,
                        static_cast<double>(counted->sizes.largest()),
                        raw.slope,
                        raw.r_squared,
                        fit_logarithmic_bins(counted->sizes).slope,
                        -fit_likelihood(counted->sizes).exponent};
            },
            [counted](std::span<const Avalanche> avalanches) {
                if (avalanches.empty()) return;
                counted->sizes.add(avalanches);
                counted->last = avalanches.back();
            },
            [counted](StateCarrier& carrier) { carry_counted(*counted, carrier); }};
}

}  // namespace fumon
