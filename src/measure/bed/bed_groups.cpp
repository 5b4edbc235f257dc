#include "measure/bed/bed_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/elementary_angle.h"
#include "base/limits.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "measure/bed/bed_along_wind.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/celerity.h"
#include "measure/bed/crest_height.h"
#include "measure/bed/crest_lines.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/crest_theory.h"
#include "measure/bed/dunes.h"
#include "measure/bed/isolated_dunes.h"
#include "measure/bed/slip_faces.h"
#include "measure/bed/slopes.h"
#include "measure/bed/wavelength.h"
#include "wind/crest_directions.h"
#include "wind/direction.h"

namespace fumon {

namespace {

/// What a group finds in beds without holes; nothing in others.
template <class Finding>
auto of_whole_beds(Finding find) {
    using Found = decltype(find(std::declval<const Snapshot&>()));
    return [find = std::move(find)](const Snapshot& snapshot) -> std::optional<Found> {
        if (!snapshot.nodata.empty()) return std::nullopt;
        return find(snapshot);
    };
}

/// A bed along the wind; of winds that cancel, along x.
BedAlongWind along_the_wind(const Snapshot& snapshot) {
    return bed_along_wind(snapshot, downwind(snapshot).value_or(HorizontalDirection{}));
}

/// The bed of the row before.
struct BedBefore {
    Grid bed;
    std::int64_t step = 0;
};

void serialise_previous_bed(BedBefore& before, StateArchive& archive) {
    std::vector<std::int64_t> size{before.bed.nx(), before.bed.ny()};
    archive.count("step_measured_before", before.step);
    archive.values("size_measured_before", std::span(size));
    std::vector<double> heights(before.bed.values().begin(), before.bed.values().end());
    archive.list("bed_measured_before", heights);
    constexpr std::int64_t longest = std::int64_t{1} << 30;
    if (size[0] < 0 || size[1] < 0 || size[0] > longest || size[1] > longest ||
        !std::cmp_equal(size[0] * size[1], heights.size()))
        archive.refuse("its bed_measured_before has a different size");
    for (const double height : heights) {
        if (!(std::abs(height) <= largest_field_value))
            archive.refuse(fmt::format("its bed_measured_before has a height of {:g}", height));
    }
    before.bed = Grid(static_cast<int>(size[0]), static_cast<int>(size[1]));
    std::ranges::copy(heights, before.bed.values().begin());
}

/// Whether a bed is sand alone, down to height 0.
bool is_of_sand(const Snapshot& first) {
    const Landform landform = first.landform;
    if (field_of(first.fields, "rock") != nullptr) return false;
    return landform == Landform::bed || landform == Landform::profile || landform == Landform::pile;
}

/// The angle of crests against the normal to a wind toward `direction`, of one against the normal
/// to x.
double turned_against(const HorizontalDirection& direction, double degrees) {
    double turned = degrees - elementary::atan2(direction.y, direction.x) * degrees_per_radian;
    while (turned <= -90.0) turned += 180.0;
    while (turned > 90.0) turned -= 180.0;
    return turned;
}

/// The way of the wind over a snapshot's dunes.
WindOnGrid wind_on_grid(const Snapshot& snapshot) {
    const std::optional<HorizontalDirection> direction = downwind(snapshot);
    return {direction.value_or(HorizontalDirection{}), snapshot.scale.dy / snapshot.scale.dx,
            direction.has_value()};
}

MeasureGroup no_columns() {
    return {{}, [](const Snapshot&) { return std::vector<double>(); }};
}

struct Crests {
    CrestOrientation orientation;
    CrestDefects defects;
};

}  // namespace

MeasureGroup statistics_group(const Snapshot& first) {
    return group_of<BedStatistics>(
        [](const Snapshot& snapshot) { return bed_statistics(snapshot.bed, snapshot.nodata); },
        {{"mean_height", "heights", "mean of the bed", &BedStatistics::mean},
         {"standard_deviation", "heights", "of the heights over all cells",
          &BedStatistics::standard_deviation},
         {"minimum_height", "heights", "lowest cell", &BedStatistics::minimum},
         {"maximum_height", "heights", "highest cell", &BedStatistics::maximum},
         {is_of_sand(first) ? "total_sand" : "bed_volume", "heights x cells", "sum of the heights",
          &BedStatistics::total}});
}

MeasureGroup wave_group() {
    struct Waves {
        BedAlongWind along;
        const Grid* bed;
    };
    return group_of<Waves>(
        of_whole_beds([](const Snapshot& snapshot) {
            return Waves{along_the_wind(snapshot), &snapshot.bed};
        }),
        {{"wavelength_spectrum", "sites", "downwind: centroid of the power spectrum's peak",
          [](const Waves& on) { return wavelength_spectrum(on.along.bed, on.along.periodic); }},
         {"wavelength_autocorrelation", "sites", "downwind: first peak of the autocorrelation",
          [](const Waves& on) {
              return wavelength_autocorrelation(on.along.bed, on.along.periodic);
          }},
         {"wavelength_crossings", "sites",
          "downwind: upward crossings with hysteresis (mean +- sd/2)",
          [](const Waves& on) { return wavelength_crossings(on.along.bed, on.along.periodic); }},
         {"top_one_percent_height", "heights", "mean of the highest 1 % of the cells",
          [](const Waves& on) { return top_one_percent_mean(*on.bed); }},
         {"crest_to_trough_height", "heights", "mean over the waves downwind", [](const Waves& on) {
              return crest_to_trough_height(on.along.bed, on.along.periodic);
          }}});
}

MeasureGroup celerity_group() {
    const auto before = std::make_shared<BedBefore>();
    MeasureGroup group = group_of<Celerity>(
        of_whole_beds([before](const Snapshot& snapshot) {
            Celerity celerity;
            const std::optional<HorizontalDirection> direction = downwind(snapshot);
            if (direction && snapshot.periodic && !before->bed.empty() &&
                snapshot.step > before->step) {
                Snapshot earlier;
                earlier.step = before->step;
                earlier.bed = std::move(before->bed);
                earlier.scale = snapshot.scale;
                earlier.periodic = true;
                celerity = celerity_along(earlier, snapshot, *direction);
            }
            *before = {snapshot.bed, snapshot.step};
            return celerity;
        }),
        {{"celerity", "sites/step", "downwind, by correlation with the row before",
          &Celerity::sites_per_step},
         {"celerity_correlation", "", "how well the bed before fits when moved so",
          &Celerity::correlation}});
    group.serialise = [before](StateArchive& archive) { serialise_previous_bed(*before, archive); };
    return group;
}

MeasureGroup slope_group() {
    return group_of<BedSlopes>(
        [](const Snapshot& snapshot) -> std::optional<BedSlopes> {
            const std::optional<HorizontalDirection> direction = downwind(snapshot);
            if (!direction) return std::nullopt;
            if (direction->is_east())
                return bed_slopes(snapshot.bed, snapshot.periodic, snapshot.nodata);
            if (!snapshot.nodata.empty()) return std::nullopt;
            const BedAlongWind along = bed_along_wind(snapshot, *direction);
            return bed_slopes(along.bed, along.periodic);
        },
        {{"stoss_slope", "heights/site", "mean of the sites that rise downwind (face the wind)",
          &BedSlopes::stoss},
         {"lee_slope", "heights/site", "mean of the sites that fall downwind", &BedSlopes::lee},
         {"steep_stoss_slope", "heights/site", "90th percentile of the rises",
          &BedSlopes::steep_stoss},
         {"steep_lee_slope", "heights/site", "90th percentile of the falls", &BedSlopes::steep_lee},
         {"stoss_to_lee_slope", "", "above 1: the upwind side is the steeper one",
          &BedSlopes::stoss_to_lee}});
}

MeasureGroup slip_face_group(const Snapshot& first) {
    if (field_of(first.fields, "wind_shadow") == nullptr) return no_columns();
    return group_of<SlipFaces>(
        [](const Snapshot& snapshot) -> std::optional<SlipFaces> {
            const Grid* shadow = field_of(snapshot.fields, "wind_shadow");
            if (shadow == nullptr || !snapshot.nodata.empty()) return std::nullopt;
            const WorldScale& scale = snapshot.scale;
            return slip_faces(snapshot.bed, *shadow, snapshot.periodic,
                              scale.dx / scale.height_unit, scale.dy / scale.height_unit);
        },
        {{"slip_face_angle", "degrees", "median steepness of shadowed cells of 20 degrees or more",
          &SlipFaces::angle},
         {"slip_face_cover", "", "share of the cells that are such", &SlipFaces::cover}});
}

MeasureGroup crest_group() {
    return group_of<Crests>(
        of_whole_beds([](const Snapshot& snapshot) {
            const BedAlongWind along = along_the_wind(snapshot);
            Crests crests{crest_orientation(snapshot.bed, snapshot.periodic),
                          crest_defects(along.bed, along.periodic,
                                        wavelength_spectrum(along.bed, along.periodic))};
            const std::optional<HorizontalDirection> direction = downwind(snapshot);
            if (direction && !direction->is_east())
                crests.orientation.degrees = turned_against(*direction, crests.orientation.degrees);
            return crests;
        }),
        {{"crest_orientation", "degrees",
          "of the crests against the normal to the wind, counterclockwise",
          [](const Crests& crests) { return crests.orientation.degrees; }},
         {"crest_coherence", "", "1 where all slopes lie along one line, 0 where none is preferred",
          [](const Crests& crests) { return crests.orientation.coherence; }},
         {"crest_defects", "", "ends of crest lines, Y-junctions among them",
          [](const Crests& crests) { return static_cast<double>(crests.defects.ends); }},
         {"crest_defect_density", "1/site", "pairs of ends over the length of all crests",
          [](const Crests& crests) { return crests.defects.defect_density; }}});
}

MeasureGroup dune_group() {
    return group_of<DuneField>(
        of_whole_beds([](const Snapshot& snapshot) {
            return separate_dunes(snapshot.bed, snapshot.periodic, {}, wind_on_grid(snapshot));
        }),
        {{"dune_count", "", "pieces above 0.3 of the highest cell, of 20 cells or more",
          [](const DuneField& field) { return static_cast<double>(field.dunes.size()); }},
         {"dune_cover", "", "share of the cells above that height", &DuneField::covered_share},
         {"dune_area", "cells", "mean over the dunes", &DuneField::mean_area},
         {"dune_height", "heights", "mean of their highest cells", &DuneField::mean_height},
         {"dune_volume", "heights x cells", "mean over the dunes", &DuneField::mean_volume},
         {"dune_horns_downwind", "", "share of the dunes whose horns point downwind",
          &DuneField::share_horns_downwind},
         {"dune_horn_lag", "sites", "mean way of the two ends downwind of the middle",
          &DuneField::mean_horn_lag}});
}

MeasureGroup isolated_dune_group(const Snapshot& first) {
    if (first.winds.empty() || field_of(first.fields, "sand") == nullptr) return no_columns();
    return group_of<IsolatedDunes>(
        of_whole_beds([](const Snapshot& snapshot) {
            const Grid* sand = field_of(snapshot.fields, "sand");
            return isolated_dunes(sand != nullptr ? *sand : snapshot.bed, snapshot.periodic,
                                  wind_on_grid(snapshot));
        }),
        {{"lone_dune_count", "", "dunes with one summit, which touch no other",
          [](const IsolatedDunes& dunes) { return static_cast<double>(dunes.count); }},
         {"lone_dune_horns_downwind", "", "share of them whose horns point downwind",
          &IsolatedDunes::share_horns_downwind},
         {"lone_dune_height_to_width", "heights/site", "median of their height over their width",
          &IsolatedDunes::height_to_width}});
}

MeasureGroup crest_direction_group(const Snapshot& first) {
    if (first.winds.empty()) return no_columns();
    const CrestDirections predicted = predicted_crests(first, flux_ratio_of_dunes);
    return group_of<CrestTheory>(
        of_whole_beds(
            [predicted](const Snapshot& snapshot) { return crest_theory(snapshot, predicted); }),
        {{"crest_direction", "degrees", "along which crests run, clockwise from north, 0 to 180",
          &CrestTheory::measured},
         {"predicted_crests_gross_transport", "degrees",
          "across which most sand moves (Rubin & Hunter 1987); of equal ones the nearest",
          &CrestTheory::gross_normal_transport},
         {"predicted_crests_bed_instability", "degrees",
          "along which a bed of sand grows fastest (Courrech du Pont et al. 2014), likewise",
          &CrestTheory::bed_instability},
         {"predicted_growth_fingering", "degrees",
          "toward which dunes on bare ground grow longer (the same), likewise",
          &CrestTheory::fingering}});
}

}  // namespace fumon
