#include "measure/water/water_groups.h"

#include <limits>

#include "base/snapshot_lookup.h"
#include "base/undefined.h"
#include "measure/water/channel_bed.h"
#include "measure/water/channels.h"
#include "measure/water/thalweg.h"
#include "measure/water/water_flow.h"
#include "measure/water/water_relief.h"

namespace fumon {

namespace {

constexpr double usual_gravity = 9.8;  // m/s², where the model does not say

/// Whether the map is a slope toward −y, along which channels run and means are taken.
bool runs_down_the_map(const Snapshot& snapshot) {
    return number_of(snapshot, "mean_slope").value_or(0.0) > 0.0;
}

}  // namespace

MeasureGroup channel_group() {
    std::vector<MeasureColumn> columns{
        {"channel_count", "",
         "maxima of the depth's mean down the slope, of 25 % of its range or more"},
        {"channel_spacing", "m", "width of the slope over their number"},
        {"channel_distance", "m", "mean from a channel to the next"},
        {"channel_distance_variation", "", "standard deviation of these over their mean"},
        {"channel_sinuosity", "", "length of the deepest water's way over the way straight on"},
        {"channel_bed_position", "m", "x of the lowest of the bed's mean down the slope"},
        {"channel_bed_depth", "m", "of that, below the bed far away (negative: deeper)"},
        {"channel_rim_height", "m", "the highest beside it, above the bed far away"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) -> std::vector<double> {
                const Grid* depth = field_of(snapshot.fields, "water_depth");
                if (depth == nullptr || !runs_down_the_map(snapshot))
                    return std::vector<double>(count, undefined);
                const double dx = snapshot.scale.dx;
                const Channels channels =
                    find_channels(*depth, snapshot.nodata, dx, snapshot.periodic);
                const double sinuosity = snapshot.nodata.empty()
                                             ? mean_sinuosity(*depth, channels.sites, dx,
                                                              snapshot.scale.dy, snapshot.periodic)
                                             : undefined;
                const ChannelBed bed =
                    channel_bed(snapshot.bed, snapshot.nodata, dx, snapshot.periodic);
                return {channels.count,
                        channels.spacing,
                        channels.mean_distance,
                        channels.distance_variation,
                        sinuosity,
                        bed.position,
                        bed.lowest,
                        bed.rim};
            }};
}

MeasureGroup water_relief_group() {
    std::vector<MeasureColumn> columns{
        {"mean_depth", "m", "of the water"},
        {"depth_variation", "", "standard deviation of the depth over its mean"},
        {"depth_range", "", "largest less smallest depth, over the mean"},
        {"downslope_depth_variation", "", "the same of the depth's mean down the slope"},
        {"downslope_depth_range", "", "the same of the depth's mean down the slope"},
        {"downslope_bed_deviation", "m", "standard deviation of the bed's mean down the slope"},
        {"downslope_bed_range", "m", "its highest less its lowest"},
        {"downslope_invariant_share", "",
         "share of the depth's variance that its mean down the slope explains"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) -> std::vector<double> {
                const Grid* depth = field_of(snapshot.fields, "water_depth");
                if (depth == nullptr) return std::vector<double>(count, undefined);
                const Unevenness all = unevenness(*depth, snapshot.nodata);
                Unevenness line;
                Unevenness bed;
                double share = undefined;
                if (runs_down_the_map(snapshot)) {
                    line = downslope_unevenness(*depth, snapshot.nodata);
                    bed = downslope_unevenness(snapshot.bed, snapshot.nodata);
                    share = downslope_invariant_share(*depth, snapshot.nodata);
                }
                return {all.mean,
                        all.deviation / all.mean,
                        all.range / all.mean,
                        line.deviation / line.mean,
                        line.range / line.mean,
                        bed.deviation,
                        bed.range,
                        share};
            }};
}

MeasureGroup water_flow_group() {
    std::vector<MeasureColumn> columns{
        {"downslope_flux", "m2/s", "of water through a metre of a cross-section, mean, toward -y"},
        {"mean_flux", "m2/s", "depth times speed, mean over the cells"},
        {"largest_flux", "m2/s", "of a cell"},
        {"mean_speed", "m/s", "of the wet cells (deeper than 0.01 mm)"},
        {"largest_speed", "m/s", "of the wet cells"},
        {"mean_froude_number", "", "speed over that of long waves, mean over the wet cells"},
        {"largest_froude_number", "", "of the wet cells"},
        {"wet_share", "", "of the cells"},
        {"supercritical_share", "", "of the wet cells: Froude number above 1"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) -> std::vector<double> {
                const Grid* depth = field_of(snapshot.fields, "water_depth");
                const Grid* u = field_of(snapshot.fields, "velocity_x");
                const Grid* v = field_of(snapshot.fields, "velocity_y");
                if (depth == nullptr || u == nullptr || v == nullptr)
                    return std::vector<double>(count, undefined);
                const double gravity = number_of(snapshot, "gravity").value_or(usual_gravity);
                const WaterFlow flow = water_flow({*depth, *u, *v}, snapshot.nodata, gravity);
                return {runs_down_the_map(snapshot) ? flow.downslope_flux : undefined,
                        flow.mean_flux,
                        flow.largest_flux,
                        flow.mean_speed,
                        flow.largest_speed,
                        flow.mean_froude_number,
                        flow.largest_froude_number,
                        flow.wet_share,
                        flow.supercritical_share};
            }};
}

}  // namespace fumon
