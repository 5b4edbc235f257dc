#include "measure/air/air_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/find_named.h"
#include "base/snapshot_lookup.h"
#include "base/undefined.h"
#include "measure/air/air_extremes.h"
#include "measure/air/eddy.h"
#include "measure/air/profile_under_air.h"
#include "measure/air/stress_lead.h"

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

}  // namespace

MeasureGroup stress_group() {
    std::vector<MeasureColumn> columns{
        {"stress_lead", "degrees",
         "of the fitted bed shear stress before the bed, upwind positive"},
        {"stress_lead_length", "m", "the same along x"},
        {"stress_fit_r_squared", "", "of a cosine with the bed's waves"},
        {"stress_maximum_from_crest", "m", "the highest stress, downwind of the nearest crest"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) -> std::vector<double> {
                const auto& section = snapshot.section;
                const SectionCurve* stress =
                    section ? find_named(section->curves, "bed_shear_stress") : nullptr;
                if (stress == nullptr) return std::vector<double>(count, undefined);
                const StressLead lead =
                    stress_lead(stress->values, profile_under_air(snapshot, 0), section->dx);
                return {lead.degrees, lead.length, lead.r_squared, lead.maximum_from_crest};
            }};
}

MeasureGroup air_group() {
    std::vector<MeasureColumn> columns{
        {"largest_speed", "m/s", "of the air"},
        {"largest_divergence", "1/s", "of the air, by central differences"},
        {"eddy_length", "m", "of the longest stretch with air that flows back; 0: none"},
        {"eddy_height", "m", "of its highest backflow above the bed; 0: none"},
        {"highest_bed_pressure", "Pa", "at the lowest nodes above the bed"},
        {"highest_bed_pressure_from_crest", "m", "downwind of the nearest crest: lee positive"},
        {"lowest_bed_pressure", "Pa", "at the lowest nodes above the bed"},
        {"lowest_bed_pressure_from_crest", "m", "downwind of the nearest crest: lee positive"}};
    const std::size_t count = columns.size();
    return {std::move(columns), [count](const Snapshot& snapshot) -> std::vector<double> {
                std::vector<double> values(count, undefined);
                if (!snapshot.section) return values;
                const SnapshotSection& section = *snapshot.section;
                const Grid* u = field_of(section.fields, "velocity_x");
                const Grid* w = field_of(section.fields, "velocity_z");
                const Grid* pressure = field_of(section.fields, "pressure");
                if (u == nullptr || w == nullptr || pressure == nullptr) return values;
                const ProfileUnderAir bed = profile_under_air(snapshot, u->ny());
                const AirExtremes flow = air_extremes(*u, *w, bed, section.dx, section.dz);
                const Eddy eddy = largest_eddy(*u, bed, section.dx, section.dz);
                const BedPressureExtremes on_bed = bed_pressure(*pressure, bed, section.dx);
                return {flow.largest_speed, flow.largest_divergence, eddy.length,
                        eddy.height,        on_bed.highest,          on_bed.highest_from_crest,
                        on_bed.lowest,      on_bed.lowest_from_crest};
            }};
}

MeasureGroup flight_group(const Snapshot& first) {
    std::vector<MeasureColumn> columns;
    std::vector<std::string> curves;
    if (first.section) {
        for (const SectionCurve& curve : first.section->curves) {
            if (!curve.name.starts_with(flight_prefix)) continue;
            curves.push_back(curve.name);
            columns.push_back({"mean_" + curve.name, curve.unit, "over the places of launch"});
            columns.push_back({"longest_" + curve.name, curve.unit, "of any place of launch"});
        }
    }
    return {std::move(columns), [curves = std::move(curves)](const Snapshot& snapshot) {
                std::vector<double> values;
                for (const std::string& name : curves) {
                    const SectionCurve* curve =
                        snapshot.section ? find_named(snapshot.section->curves, name) : nullptr;
                    const FlightLengths lengths =
                        curve == nullptr ? FlightLengths{} : flight_lengths(curve->values);
                    values.push_back(lengths.mean);
                    values.push_back(lengths.longest);
                }
                return values;
            }};
}

}  // namespace fumon
