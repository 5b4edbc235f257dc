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
#include "measure/bed/bed_findings.h"
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
#include "wind/run_drift.h"

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

/// What all groups share, of a bed without holes: each measure takes of it what it needs.
auto of_shared(const SharedFindings& findings) {
    return of_whole_beds([findings](const Snapshot&) { return findings.get(); });
}

/// The bed of the row before.
struct BedBefore {
    Grid bed;
    std::int64_t step = 0;
    RowSpectra spectra;                        ///< of its rows along a wind
    std::optional<HorizontalDirection> along;  ///< that wind; none: there are no spectra
};

/// The celerity since the bed before, which this bed takes the place of.
Celerity celerity_since(BedBefore& before, BedFindings& on) {
    const Snapshot& snapshot = on.snapshot();
    const std::optional<HorizontalDirection>& wind = on.wind();
    const bool is_later =
        wind && snapshot.periodic && !before.bed.empty() && snapshot.step > before.step;
    Snapshot earlier;
    earlier.step = before.step;
    earlier.bed = std::move(before.bed);
    earlier.scale = snapshot.scale;
    earlier.periodic = true;
    Celerity celerity;
    if (wind && on.along_is_periodic()) {
        RowSpectra& spectra = on.spectra();
        if (is_later) {
            if (!before.along || before.along->x != wind->x || before.along->y != wind->y)
                find_row_spectra(bed_along_wind(earlier, *wind).bed, before.spectra);
            celerity = celerity_of_spectra(before.spectra, spectra, snapshot.step - earlier.step);
        }
        std::swap(before.spectra, spectra);
        before.along = wind;
    } else {
        before.along.reset();
        if (is_later) celerity = celerity_along(earlier, snapshot, *wind);
    }
    before.bed = std::move(earlier.bed);
    before.bed = snapshot.bed;  // into the same memory
    before.step = snapshot.step;
    return celerity;
}

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
    before.along.reset();
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

/// Where the only dune of the row before was, for its speed; step −1 where there was no such.
struct LoneDuneBefore {
    std::int64_t step = -1;
    double place = 0.0;
};

struct MovedDunes {
    IsolatedDunes dunes;
    double sites_per_step = std::numeric_limits<double>::quiet_NaN();
};

MeasureGroup no_columns() {
    return {{}, [](const Snapshot&, const std::vector<bool>&) { return std::vector<double>(); }};
}

}  // namespace

MeasureGroup statistics_group(const Snapshot& first, const SharedFindings& findings) {
    return group_of<BedStatistics>(
        [findings](const Snapshot&) { return findings->statistics(); },
        {{"mean_height", "heights", "mean of the bed", &BedStatistics::mean},
         {"standard_deviation", "heights", "of the heights over all cells",
          &BedStatistics::standard_deviation},
         {"minimum_height", "heights", "lowest cell", &BedStatistics::minimum},
         {"maximum_height", "heights", "highest cell", &BedStatistics::maximum},
         {is_of_sand(first) ? "total_sand" : "bed_volume", "heights x cells", "sum of the heights",
          &BedStatistics::total}});
}

MeasureGroup wave_group(const Snapshot& /*first*/, const SharedFindings& findings) {
    return group_of<BedFindings*>(
        of_shared(findings),
        {{"wavelength_spectrum", "sites", "downwind: centroid of the power spectrum's peak",
          [](BedFindings* on) { return on->wavelength(); }},
         {"wavelength_autocorrelation", "sites", "downwind: first peak of the autocorrelation",
          [](BedFindings* on) {
              return wavelength_of_autocorrelation(on->power(), on->along().nx(),
                                                   on->along_is_periodic());
          }},
         {"wavelength_crossings", "sites",
          "downwind: upward crossings with hysteresis (mean +- sd/2)",
          [](BedFindings* on) { return wavelength_of_crossings(on->waves(), on->along().nx()); }},
         {"top_one_percent_height", "heights", "mean of the highest 1 % of the cells",
          [](BedFindings* on) { return top_one_percent_mean(on->snapshot().bed); }},
         {"crest_to_trough_height", "heights", "mean over the waves downwind",
          [](BedFindings* on) { return crest_to_trough(on->waves()); }}});
}

MeasureGroup celerity_group(const Snapshot& /*first*/, const SharedFindings& findings) {
    const auto before = std::make_shared<BedBefore>();
    MeasureGroup group = group_of<Celerity>(
        of_whole_beds(
            [before, findings](const Snapshot&) { return celerity_since(*before, *findings); }),
        {{"celerity", "sites/step", "downwind, by correlation with the row before",
          &Celerity::sites_per_step},
         {"celerity_correlation", "", "how well the bed before fits when moved so",
          &Celerity::correlation}});
    group.serialise = [before](StateArchive& archive) { serialise_previous_bed(*before, archive); };
    return group;
}

MeasureGroup slope_group(const Snapshot& /*first*/, const SharedFindings& findings) {
    return group_of<BedSlopes>(
        [findings](const Snapshot& snapshot) -> std::optional<BedSlopes> {
            const std::optional<HorizontalDirection>& direction = findings->wind();
            if (!direction) return std::nullopt;
            if (direction->is_east())
                return bed_slopes(snapshot.bed, snapshot.periodic, snapshot.nodata);
            if (!snapshot.nodata.empty()) return std::nullopt;
            return bed_slopes(findings->along(), findings->along_is_periodic());
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

MeasureGroup crest_group(const Snapshot& /*first*/, const SharedFindings& findings) {
    const auto defects = std::make_shared<std::optional<CrestDefects>>();
    const auto defects_of = [defects](BedFindings* on) -> const CrestDefects& {
        if (!*defects)
            *defects = crest_defects(on->along(), on->along_is_periodic(), on->wavelength());
        return **defects;
    };
    return group_of<BedFindings*>(
        of_whole_beds([findings, defects](const Snapshot&) {
            defects->reset();
            return findings.get();
        }),
        {{"crest_orientation", "degrees",
          "of the crests against the normal to the wind, counterclockwise",
          [](BedFindings* on) {
              const double degrees = on->orientation().degrees;
              const auto& direction = on->wind();
              const bool turned = direction && !direction->is_east();
              return turned ? turned_against(*direction, degrees) : degrees;
          }},
         {"crest_coherence", "", "1 where all slopes lie along one line, 0 where none is preferred",
          [](BedFindings* on) { return on->orientation().coherence; }},
         {"crest_defects", "", "ends of crest lines, Y-junctions among them",
          [defects_of](BedFindings* on) { return static_cast<double>(defects_of(on).ends); }},
         {"crest_defect_density", "1/site", "pairs of ends over the length of all crests",
          [defects_of](BedFindings* on) { return defects_of(on).defect_density; }}});
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
    const auto before = std::make_shared<LoneDuneBefore>();
    MeasureGroup group = group_of<MovedDunes>(
        of_whole_beds([before](const Snapshot& snapshot) {
            const Grid* sand = field_of(snapshot.fields, "sand");
            MovedDunes now{isolated_dunes(sand != nullptr ? *sand : snapshot.bed, snapshot.periodic,
                                          wind_on_grid(snapshot))};
            if (!snapshot.periodic && before->step >= 0 && snapshot.step > before->step) {
                now.sites_per_step = (now.dunes.place - before->place) /
                                     static_cast<double>(snapshot.step - before->step);
            }
            *before = {};
            if (now.dunes.count == 1) *before = {snapshot.step, now.dunes.place};
            return now;
        }),
        {{"lone_dune_count", "", "dunes with one summit, which touch no other",
          [](const MovedDunes& now) { return static_cast<double>(now.dunes.count); }},
         {"lone_dune_horns_downwind", "", "share of them whose horns point downwind",
          [](const MovedDunes& now) { return now.dunes.share_horns_downwind; }},
         {"lone_dune_height_to_width", "heights/site", "median of their height over their width",
          [](const MovedDunes& now) { return now.dunes.height_to_width; }},
         {"lone_dune_height", "heights", "median of their height",
          [](const MovedDunes& now) { return now.dunes.height; }},
         {"lone_dune_width", "sites", "median of their width across the wind",
          [](const MovedDunes& now) { return now.dunes.width; }},
         {"lone_dune_length", "sites", "median of their length along the wind, horns and all",
          [](const MovedDunes& now) { return now.dunes.length; }},
         {"lone_dune_volume_ratio", "", "volume of the second largest of them over the largest",
          [](const MovedDunes& now) { return now.dunes.volume_ratio; }},
         {"lone_dune_speed", "sites/step",
          "of the only one over open edges, downwind, since the row before",
          &MovedDunes::sites_per_step}});
    group.serialise = [before](StateArchive& archive) {
        archive.value("step_of_lone_dune_before", before->step);
        archive.value("place_of_lone_dune_before", before->place);
    };
    return group;
}

MeasureGroup crest_direction_group(const Snapshot& first, const SharedFindings& findings) {
    if (first.winds.empty()) return no_columns();
    const CrestDirections predicted = predicted_crests(first, flux_ratio_of_dunes);
    return group_of<CrestTheory>(
        of_whole_beds([predicted, findings](const Snapshot&) {
            return crest_theory(findings->orientation(), predicted);
        }),
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

MeasureGroup drift_group(const Snapshot& first) {
    if (first.winds.empty()) return no_columns();
    return group_of<Drift>(
        [](const Snapshot& snapshot) { return drift_of(fluxes_of(snapshot.winds)); },
        {{"drift_potential", "m2/yr",
          "saturated flux over flat sand of all winds of the run, on the mean over its time: a "
          "sum of fluxes, where Fryberger & Dean (1979) have vector units",
          &Drift::potential},
         {"resultant_drift_potential", "m2/yr", "length of the vector sum of these fluxes",
          &Drift::resultant},
         {"rdp_dp", "", "the latter over the former: 1 for winds from one side",
          [](const Drift& drift) {
              return drift.potential > 0.0 ? drift.resultant / drift.potential : undefined;
          }},
         {"resultant_drift_direction", "degrees",
          "toward which the vector sum points, clockwise from north, 0 to 360", &Drift::toward}});
}

}  // namespace fumon
