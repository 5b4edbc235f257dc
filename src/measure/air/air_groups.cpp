#include "measure/air/air_groups.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/find_named.h"
#include "base/snapshot_lookup.h"
#include "measure/air/air_extremes.h"
#include "measure/air/eddy.h"
#include "measure/air/profile_under_air.h"
#include "measure/air/stress_lead.h"
#include "measure/shared/undefined.h"

namespace fumon {

namespace {

constexpr std::string_view flight_prefix = "flight_length_";

struct FlightLengths {
    double mean = undefined;
    double longest = undefined;
};

/// Over the columns from which a grain flies.
FlightLengths flight_lengths(const std::vector<double>& lengths) {
    FlightLengths all;
    double sum = 0.0;
    double count = 0.0;
    for (const double length : lengths) {
        if (!std::isfinite(length)) continue;
        sum += length;
        count += 1.0;
        if (!(length <= all.longest)) all.longest = length;
    }
    all.mean = sum / count;
    return all;
}

std::optional<StressLead> find_stress_lead(const Snapshot& snapshot) {
    if (!snapshot.section) return std::nullopt;
    const SnapshotSection& section = *snapshot.section;
    const SectionCurve* stress = find_named(section.curves, "bed_shear_stress");
    if (stress == nullptr) return std::nullopt;
    return stress_lead(stress->values, profile_under_air(snapshot, 0), section.dx);
}

struct AirMeasures {
    AirExtremes flow;
    Eddy eddy;
    BedPressureExtremes on_bed;
};

std::optional<AirMeasures> find_air_measures(const Snapshot& snapshot) {
    if (!snapshot.section) return std::nullopt;
    const SnapshotSection& section = *snapshot.section;
    const Grid* u = field_of(section.fields, "velocity_x");
    const Grid* w = field_of(section.fields, "velocity_z");
    const Grid* pressure = field_of(section.fields, "pressure");
    if (u == nullptr || w == nullptr || pressure == nullptr) return std::nullopt;
    const ProfileUnderAir bed = profile_under_air(snapshot, u->ny());
    return AirMeasures{air_extremes(*u, *w, bed, section.dx, section.dz),
                       largest_eddy(*u, bed, section.dx, section.dz),
                       bed_pressure(*pressure, bed, section.dx)};
}

}  // namespace

MeasureGroup stress_group() {
    return group_of<StressLead>(
        find_stress_lead,
        {{"stress_lead", "degrees",
          "of the fitted bed shear stress before the bed, upwind positive", &StressLead::degrees},
         {"stress_lead_length", "m", "the same along x", &StressLead::length},
         {"stress_fit_r_squared", "", "of a cosine with the bed's waves", &StressLead::r_squared},
         {"stress_maximum_from_crest", "m", "the highest stress, downwind of the nearest crest",
          &StressLead::maximum_from_crest}});
}

MeasureGroup air_group() {
    using Found = AirMeasures;
    return group_of<Found>(
        find_air_measures,
        {{"largest_speed", "m/s", "of the air",
          [](const Found& found) { return found.flow.largest_speed; }},
         {"largest_divergence", "1/s", "of the air, by central differences",
          [](const Found& found) { return found.flow.largest_divergence; }},
         {"eddy_length", "m", "of the longest stretch with air that flows back; 0: none",
          [](const Found& found) { return found.eddy.length; }},
         {"eddy_height", "m", "of its highest backflow above the bed; 0: none",
          [](const Found& found) { return found.eddy.height; }},
         {"highest_bed_pressure", "Pa", "at the lowest nodes above the bed",
          [](const Found& found) { return found.on_bed.highest; }},
         {"highest_bed_pressure_from_crest", "m", "downwind of the nearest crest: lee positive",
          [](const Found& found) { return found.on_bed.highest_from_crest; }},
         {"lowest_bed_pressure", "Pa", "at the lowest nodes above the bed",
          [](const Found& found) { return found.on_bed.lowest; }},
         {"lowest_bed_pressure_from_crest", "m", "downwind of the nearest crest: lee positive",
          [](const Found& found) { return found.on_bed.lowest_from_crest; }}});
}

MeasureGroup flight_group(const Snapshot& first) {
    using Found = std::vector<FlightLengths>;  // of each curve
    std::vector<std::string> curves;
    std::vector<Measure<Found>> measures;
    if (first.section) {
        for (const SectionCurve& curve : first.section->curves) {
            if (!curve.name.starts_with(flight_prefix)) continue;
            const std::size_t k = curves.size();
            curves.push_back(curve.name);
            measures.push_back({"mean_" + curve.name, curve.unit, "over the places of launch",
                                [k](const Found& found) { return found[k].mean; }});
            measures.push_back({"longest_" + curve.name, curve.unit, "of any place of launch",
                                [k](const Found& found) { return found[k].longest; }});
        }
    }
    return group_of<Found>(
        [curves = std::move(curves)](const Snapshot& snapshot) -> std::optional<Found> {
            if (!snapshot.section) return std::nullopt;
            Found found;
            for (const std::string& name : curves) {
                const SectionCurve* curve = find_named(snapshot.section->curves, name);
                found.push_back(curve == nullptr ? FlightLengths{} : flight_lengths(curve->values));
            }
            return found;
        },
        std::move(measures));
}

}  // namespace fumon
