#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/grid.h"
#include "models/dunes/plants/growth_law.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class StateArchive;
class WorkerPool;

/// Plants on dunes, after Baas (2002) and Nield & Baas (2008): two species, grass that thrives on
/// burial and shrubs that thrive on ground at rest, each a cover ρ of 0 … 1 in every cell. Once in
/// a period T, each with its growth law g,
///
///     ρ ← ρ + T g((h − h_then) / T)         where it grows, within 0 … 1
///
/// with h_then the surface when plants last grew. Where a species does not grow, it begins with
/// what it would grow by, if that is more than 0 and there is sand to root in, with the probability
///
///     T (a dx dy + b / dx)
///
/// where a is what pioneers there are, and b the spread from a cell beside it with that species (0
/// without one). Covers are whole numbers of 2⁻³², drawn by counter-based random numbers, so no
/// result depends on threads.
///
/// Both species together, up to 1, are the cover that holds sand: where it is ρ, the wind lifts
/// max(1 − ρ / ρ0, 0) of what it would, of sand that lands the share p + ρ (1 − p) stays, where p
/// would, and sand comes to rest at an angle that grows to the plants' one at ρ = 0.3. Where plants
/// slow the wind, it lifts by that instead (see PlantShelter).
class Plants {
  public:
    /// Throws KeyError for balances that do not rise.
    Plants(const DunesParameters& parameters, const DuneGround& ground, const DuneBed& bed,
           std::uint64_t seed, WorkerPool& pool);

    /// Grows if a period has passed at `time` (years, after `step` steps). True where it did.
    bool grow(const DuneBed& bed, double time, std::int64_t step);

    /// Of both species, 0 … 1.
    [[nodiscard]] const Grid& cover() const { return cover_; }
    /// What the wind lifts under that cover, in parts of what it would.
    [[nodiscard]] double lifted(double cover) const {
        return cover < without_lift_ ? 1.0 - cover / without_lift_ : 0.0;
    }
    /// Of repose, degrees.
    [[nodiscard]] Grid angles() const;

    [[nodiscard]] Grid grass() const { return in_parts(species_[0].cover); }
    [[nodiscard]] Grid shrubs() const { return in_parts(species_[1].cover); }
    /// The surface when plants last grew, and when that was, years.
    [[nodiscard]] const FixedPointGrid& surface_at_last_growth() const {
        return surface_at_last_growth_;
    }
    [[nodiscard]] double time_of_last_growth() const { return time_of_last_growth_; }

    void serialise(StateArchive& archive);

  private:
    struct Species {
        FixedPointGrid cover;
        FixedPointGrid before;
        GrowthLaw law;
    };

    static Grid in_parts(const FixedPointGrid& cover);
    void plant(const DuneSpecies& asked, FeatureKind kind, const DunesParameters& parameters,
               std::size_t index, std::uint64_t seed);
    void grow_row(Species& species, const DuneBed& bed, double years, std::int64_t step, int y);
    [[nodiscard]] bool beside(const FixedPointGrid& cover, int x, int y) const;
    void find_cover();

    DuneGround ground_;
    WorkerPool& pool_;
    std::uint64_t seed_;
    bool grows_;
    double period_;
    double pioneers_;  ///< of a cell, 1/yr
    double spread_;    ///< to a cell, 1/yr
    double without_lift_;
    double bare_angle_;
    double plant_angle_;
    std::array<Species, 2> species_;
    FixedPointGrid surface_at_last_growth_;
    double time_of_last_growth_ = 0.0;
    Grid cover_;
};

}  // namespace fumon
