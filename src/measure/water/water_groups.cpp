#include "measure/water/water_groups.h"

#include <optional>

#include "base/snapshot_lookup.h"
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

/// The water's depth, where a snapshot has it.
const Grid* depth_of(const Snapshot& snapshot) {
    return field_of(snapshot.fields, "water_depth");
}

struct ChannelMeasures {
    Channels channels;
    double sinuosity = undefined;
    ChannelBed bed;
};

std::optional<ChannelMeasures> find_channel_measures(const Snapshot& snapshot) {
    const Grid* depth = depth_of(snapshot);
    if (depth == nullptr || !runs_down_the_map(snapshot)) return std::nullopt;
    const double dx = snapshot.scale.dx;
    ChannelMeasures found;
    found.channels = find_channels(*depth, snapshot.nodata, dx, snapshot.periodic);
    if (snapshot.nodata.empty())
        found.sinuosity =
            mean_sinuosity(*depth, found.channels.sites, dx, snapshot.scale.dy, snapshot.periodic);
    found.bed = channel_bed(snapshot.bed, snapshot.nodata, dx, snapshot.periodic);
    return found;
}

struct ReliefMeasures {
    Unevenness all;   ///< of the depth
    Unevenness line;  ///< of its mean down the slope
    Unevenness bed;   ///< of the bed's
    double invariant_share = undefined;
};

std::optional<ReliefMeasures> find_relief_measures(const Snapshot& snapshot) {
    const Grid* depth = depth_of(snapshot);
    if (depth == nullptr) return std::nullopt;
    ReliefMeasures found;
    found.all = unevenness(*depth, snapshot.nodata);
    if (!runs_down_the_map(snapshot)) return found;
    found.line = downslope_unevenness(*depth, snapshot.nodata);
    found.bed = downslope_unevenness(snapshot.bed, snapshot.nodata);
    found.invariant_share = downslope_invariant_share(*depth, snapshot.nodata);
    return found;
}

std::optional<WaterFlow> find_flow_measures(const Snapshot& snapshot) {
    const Grid* depth = depth_of(snapshot);
    const Grid* u = field_of(snapshot.fields, "velocity_x");
    const Grid* v = field_of(snapshot.fields, "velocity_y");
    if (depth == nullptr || u == nullptr || v == nullptr) return std::nullopt;
    const double gravity = number_of(snapshot, "gravity").value_or(usual_gravity);
    WaterFlow flow = water_flow({*depth, *u, *v}, snapshot.nodata, gravity);
    if (!runs_down_the_map(snapshot)) flow.downslope_flux = undefined;
    return flow;
}

}  // namespace

MeasureGroup channel_group() {
    using Found = ChannelMeasures;
    return group_of<Found>(
        find_channel_measures,
        {{"channel_count", "",
          "maxima of the depth's mean down the slope, of 25 % of its range or more",
          [](const Found& found) { return found.channels.count; }},
         {"channel_spacing", "m", "width of the slope over their number",
          [](const Found& found) { return found.channels.spacing; }},
         {"channel_distance", "m", "mean from a channel to the next",
          [](const Found& found) { return found.channels.mean_distance; }},
         {"channel_distance_variation", "", "standard deviation of these over their mean",
          [](const Found& found) { return found.channels.distance_variation; }},
         {"channel_sinuosity", "", "length of the deepest water's way over the way straight on",
          &Found::sinuosity},
         {"channel_bed_position", "m", "x of the lowest of the bed's mean down the slope",
          [](const Found& found) { return found.bed.position; }},
         {"channel_bed_depth", "m", "of that, below the bed far away (negative: deeper)",
          [](const Found& found) { return found.bed.lowest; }},
         {"channel_rim_height", "m", "the highest beside it, above the bed far away",
          [](const Found& found) { return found.bed.rim; }}});
}

MeasureGroup water_relief_group() {
    using Found = ReliefMeasures;
    return group_of<Found>(
        find_relief_measures,
        {{"mean_depth", "m", "of the water", [](const Found& found) { return found.all.mean; }},
         {"depth_variation", "", "standard deviation of the depth over its mean",
          [](const Found& found) { return found.all.deviation / found.all.mean; }},
         {"depth_range", "", "largest less smallest depth, over the mean",
          [](const Found& found) { return found.all.range / found.all.mean; }},
         {"downslope_depth_variation", "", "the same of the depth's mean down the slope",
          [](const Found& found) { return found.line.deviation / found.line.mean; }},
         {"downslope_depth_range", "", "the same of the depth's mean down the slope",
          [](const Found& found) { return found.line.range / found.line.mean; }},
         {"downslope_bed_deviation", "m", "standard deviation of the bed's mean down the slope",
          [](const Found& found) { return found.bed.deviation; }},
         {"downslope_bed_range", "m", "its highest less its lowest",
          [](const Found& found) { return found.bed.range; }},
         {"downslope_invariant_share", "",
          "share of the depth's variance that its mean down the slope explains",
          &Found::invariant_share}});
}

MeasureGroup water_flow_group() {
    return group_of<WaterFlow>(
        find_flow_measures,
        {{"downslope_flux", "m2/s", "of water through a metre of a cross-section, mean, toward -y",
          &WaterFlow::downslope_flux},
         {"mean_flux", "m2/s", "depth times speed, mean over the cells", &WaterFlow::mean_flux},
         {"largest_flux", "m2/s", "of a cell", &WaterFlow::largest_flux},
         {"mean_speed", "m/s", "of the wet cells (deeper than 0.01 mm)", &WaterFlow::mean_speed},
         {"largest_speed", "m/s", "of the wet cells", &WaterFlow::largest_speed},
         {"mean_froude_number", "", "speed over that of long waves, mean over the wet cells",
          &WaterFlow::mean_froude_number},
         {"largest_froude_number", "", "of the wet cells", &WaterFlow::largest_froude_number},
         {"wet_share", "", "of the cells", &WaterFlow::wet_share},
         {"supercritical_share", "", "of the wet cells: Froude number above 1",
          &WaterFlow::supercritical_share}});
}

}  // namespace fumon
