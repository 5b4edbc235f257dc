#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keys/keys.h"

namespace fumon {

enum class DuneTransport { continuous, slabs };
enum class DuneSpeedUp { none, height, relief };
enum class DuneBend { none, shear, contours };
enum class DuneShadow { soft, hard };
enum class DuneEdge { periodic, open };
enum class DuneRock { level, bed };
enum class SlabOrder { parallel, sequential };
enum class DunePlants { none, fixed, grow };
enum class DunePlantShelter { none, raupach, okin };
enum class FeatureKind { rock, sand, source, clearing, grass, shrubs };
enum class FeatureShape { block, cone, hill };

/// A wind that blows for a while, or a table of winds, whose place the winds in it take.
struct DuneWind {
    double from = 270.0;         ///< degrees clockwise from north, where it blows from
    double strength = 1.0;       ///< of its drift, in model.flux
    double duration = 1.0;       ///< years; of a table, of all its winds together
    std::string table{};         ///< a file; empty for a wind
    double gust_angle = 0.0;     ///< degrees: standard deviation of gusts' directions about `from`
    double gust_strength = 0.0;  ///< standard deviation of gusts' strengths, in parts of `strength`
    double gust_duration = 0.01;                ///< years
    WordOrReal threshold_ratio{"auto", 0.0};    ///< u* / u*t
    WordOrReal speed{"none", 0.0};              ///< m/s, instead of a strength
    WordOrReal friction_velocity{"none", 0.0};  ///< u*, m/s, instead of a strength
    double speed_height = 10.0;                 ///< m above the ground

    /// Whether its drift follows from a speed or a friction velocity.
    [[nodiscard]] bool is_measured() const {
        return !speed.is_word() || !friction_velocity.is_word();
    }

    friend bool operator==(const DuneWind&, const DuneWind&) = default;
};

/// Something set on the ground before the first step; see ground_features.h.
struct DuneFeature {
    FeatureKind kind = FeatureKind::rock;
    FeatureShape shape = FeatureShape::hill;
    double x = 0.0;        ///< m from the bed's western edge to its middle
    double y = 0.0;        ///< m from the southern edge
    double length = 10.0;  ///< m along its axis
    double width = 0.0;    ///< m across it; 0: as its length
    double height = 2.0;   ///< m, of rock, sand and sources
    double axis = 90.0;    ///< degrees clockwise from north
    double ravines = 0.0;  ///< of rock: how deep at most, in parts of its height there

    friend bool operator==(const DuneFeature&, const DuneFeature&) = default;
};

/// A species of plants: how it begins, and its growth against the balance of sand (see plants.h).
struct DuneSpecies {
    double cover = 0.0;            ///< of the ground that it grows on at first, 0 … 1
    double share = 1.0;            ///< of the cells on which it grows at first
    std::vector<double> balances;  ///< m/yr: five, rising
    double growth = 0.0;           ///< at the third of them, 1/yr
    double height = 0.0;           ///< m, of a whole cover
};

/// The parameters of the dune model, in metres and years.
struct DunesParameters {
    DuneTransport transport = DuneTransport::continuous;
    std::vector<DuneWind> winds;  ///< in turn; none: one from 270 degrees

    double flux = 100.0;  ///< saturated drift over flat sand, m²/yr (m³ per m width and year)
    double grain_diameter = 0.25;               ///< mm, of winds given by speeds
    double roughness = 1e-3;                    ///< m, of the ground under these
    WordOrReal saturation_length{"auto", 0.0};  ///< m; "hops": of hops by hop_length
    double hop_length = 1.0;                    ///< m
    double deposit_on_sand = 0.6;
    double deposit_on_rock = 0.4;
    double slope_drift = 0.3;
    WordOrReal time_step{"auto", 0.0};  ///< years, of continuous transport

    DuneSpeedUp speed_up = DuneSpeedUp::relief;
    DuneBend wind_bend = DuneBend::none;
    double hop_per_height = 0.1;          ///< 1/m
    double hop_per_height_squared = 0.0;  ///< 1/m²
    double shear_in_phase = 3.5;          ///< A
    double shear_ahead = 2.0;             ///< B
    double shear_across = 2.4;            ///< C
    double slope_deflection = 0.0;        ///< D

    DuneShadow shadow = DuneShadow::soft;
    double shadow_angle = 15.0;              ///< degrees
    double shadow_soft_angle = 10.0;         ///< degrees
    WordOrReal windward_angle{"none", 0.0};  ///< degrees

    WordOrReal slab_height{"auto", 0.0};  ///< m
    SlabOrder order = SlabOrder::parallel;
    std::int64_t substeps = 16;

    double repose_angle = 33.0;  ///< degrees, dynamic
    double static_angle = 33.0;  ///< degrees
    std::int64_t avalanche_passes = 2000;

    bool avalanche_age = false;

    DuneEdge edges_x = DuneEdge::periodic;
    DuneEdge edges_y = DuneEdge::periodic;
    double influx = 0.0;  ///< share of the saturated drift

    DuneRock rock = DuneRock::level;
    double rock_level = 0.0;  ///< m
    double sand_cover = 1.0;  ///< m

    double rock_wear = 0.0;                   ///< of the volume of the sand that lands
    double rock_repose_angle = 68.0;          ///< degrees, of rock that is worn
    WordOrReal abrasion_height{"none", 0.0};  ///< m
    double rock_dust = 0.0;                   ///< of the rock that is worn
    WordOrReal wall_angle{"none", 0.0};       ///< degrees
    double wall_drift = 0.0;                  ///< of the wind
    std::vector<DuneFeature> features;

    DunePlants plants = DunePlants::none;
    DuneSpecies grass{0.0, 1.0, {-1.4, 0.2, 0.6, 2.0, 2.2}, 0.2, 0.45};
    DuneSpecies shrubs{0.0, 1.0, {-1.4, -0.65, 0.0, 0.2, 2.8}, 0.05, 1.1};
    double plant_spread = 0.2;         ///< m/yr
    double plant_pioneers = 0.05;      ///< 1/(m² yr)
    double growth_period = 0.1;        ///< years
    double cover_without_lift = 0.5;   ///< at which no sand is lifted
    double plant_repose_angle = 45.0;  ///< degrees
    DunePlantShelter plant_shelter = DunePlantShelter::none;
    double plant_drag = 16.0;     ///< Γ
    double shelter_length = 4.8;  ///< c, in heights of plants
};

/// Lists the keys model.* and wind.* bound to these parameters.
void list_keys(DunesParameters& parameters, KeyTable& table);

}  // namespace fumon
