#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/avalanche/slope_relaxation.h"
#include "models/dunes/plants/plant_shelter.h"
#include "models/dunes/plants/plants.h"
#include "models/dunes/rock_wear.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/transport/continuous_transport.h"
#include "models/dunes/transport/slab_transport.h"
#include "models/dunes/transport/wind_over_bed.h"
#include "models/dunes/wind/relief_shear.h"
#include "models/dunes/wind/wind_bend.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"
#include "models/dunes/wind/windward_bubbles.h"
#include "models/dunes/wind/windward_walls.h"
#include "models/shared/model.h"

namespace fumon {

/// Dunes with slip faces: sand on a hard floor under winds that blow in turn, in metres and years.
/// Each step
///
///     shadow      what keeps the wind off                       see WindShadow
///     speed-up    of the drift over relief, or of hops by height see ReliefShear, hop_factor
///     bend        of the wind by relief                         see ReliefShear, ContourBend
///     transport   continuous, or slabs at random                 see ContinuousTransport,
///                                                                SlabTransport
///     rock        worn where it is bare                          see RockWear
///     avalanches  down to the angle of repose                    see SlopeRelaxation
///     plants      grow, spread, are buried                       see Plants
///
/// Heights are whole numbers of 2⁻³² m: sand at rest + moving sand + outflow − inflow − worn rock
/// is the same number after every step, and results do not depend on the number of threads. The
/// linear shear stress holds for gentle slopes; the separation bubble that it sees behind a crest
/// is a plane at the shadow's angle, and before steep slopes one at model.windward_angle.
class Dunes : public Model {
  public:
    static constexpr std::string_view model_name = "dunes";
    static constexpr Landform landform = Landform::bed;

    /// Throws KeyError for a masked bed, a bed below the rock or with more sand than whole numbers
    /// hold, and parameters that do not fit one another.
    Dunes(const DunesParameters& parameters, const ModelSetup& setup);

    [[nodiscard]] std::string_view name() const override { return model_name; }
    void step() override;
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] double time() const override { return schedule_.time(steps_); }
    [[nodiscard]] std::string_view time_unit() const override { return "yr"; }

    /// The bed, rock and sand; fields "sand", "rock", "moving_sand" (m), "wind_shadow" and
    /// "local_wind" (of the next step's wind), where relief bends it "wind_turn" (degrees), with
    /// plants "cover", "grass" and "shrubs", where they slow the wind "plant_shelter", if asked for
    /// "avalanche_age" (yr; of cells that never slid, since the start); numbers "sand_volume",
    /// "sand_inflow", "sand_outflow" (m³) and "avalanche_passes", with rock that is worn
    /// "rock_worn" (m³), with plants "plant_cover".
    [[nodiscard]] Snapshot snapshot() const override;

    /// Where avalanches of the last step did not come to rest.
    [[nodiscard]] std::string plausibility_warning() const override;

    /// "bed", "rock", "moving_sand" in metres, "flows": inflow and outflow; with rock that is worn
    /// "worn", with plants "grass", "shrubs", "surface_at_growth" and "time_of_growth". The spans
    /// hold until the next call.
    [[nodiscard]] std::vector<StateField> state() const override;

    void serialise(StateArchive& archive) override;

    [[nodiscard]] const DuneBed& bed() const { return bed_; }

  private:
    void blow_continuously(const BlowingWind& wind);
    void find_wind(const BlowingWind& wind) const;
    /// The wind over the bed as it is, of continuous transport: found once a step.
    WindOverBed wind_over_bed(const BlowingWind& wind) const;
    void bend(const BlowingWind& wind) const;
    [[nodiscard]] Grid wind_turn() const;
    void fill_sources();
    void take_plants();
    void add_plants(Snapshot& snapshot) const;
    void note_slides();
    [[nodiscard]] Grid avalanche_age() const;
    [[nodiscard]] Grid local_wind() const;
    /// Sand in the air over flat sand between two steps, m; 0 where a step ends with none.
    [[nodiscard]] double saturated_air() const;

    DunesParameters parameters_;
    WorldScale scale_;
    DuneGround ground_;
    WorkerPool& pool_;
    ShadowTangents shadow_tangents_;
    double slab_height_;  ///< m
    WindSchedule schedule_;
    DuneBed bed_;
    SlopeRelaxation slopes_;
    mutable WindShadow shadow_;
    mutable std::optional<ReliefShear> shear_;
    mutable std::optional<ContourBend> contour_bend_;
    mutable std::optional<WindwardBubbles> bubbles_;
    mutable std::optional<WindwardWalls> walls_;
    std::optional<Plants> plants_;
    mutable std::optional<PlantShelter> shelter_;
    std::optional<RockWear> rock_wear_;
    std::optional<ContinuousTransport> continuous_;
    std::optional<SlabTransport> slabs_;
    FixedPointGrid slid_at_;  ///< step in which each cell last slid, 0 for none, where that is kept
    std::int64_t steps_ = 0;
    std::int64_t passes_ = 0;  ///< of the last step's avalanches
    bool at_rest_ = true;      ///< whether they have ended
    FixedPointGrid sources_;   ///< least thickness of sand; empty where there are none
    mutable std::int64_t wind_found_at_ =
        -1;                ///< step whose wind is known, which a snapshot asked for
    mutable Grid relief_;  ///< working memory of the shear stress
    mutable Grid across_;  ///< likewise
    mutable BentWind bent_;
    mutable Grid state_bed_;
    mutable Grid state_rock_;
    mutable Grid state_moving_;
    mutable std::vector<double> state_flows_;
    mutable std::vector<double> state_worn_;
    mutable Grid state_grass_;
    mutable Grid state_shrubs_;
    mutable Grid state_surface_at_last_growth_;
    mutable std::vector<double> state_time_of_last_growth_;
};

}  // namespace fumon
