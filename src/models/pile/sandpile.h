#pragma once

#include <cstdint>
#include <vector>

#include "models/pile/pile.h"
#include "models/pile/sandpile_parameters.h"
#include "models/pile/toppling_draws.h"
#include "models/shared/model.h"

namespace fumon {

/// The sandpile of Higashi & Takamori (2003). Grains fall on drop sites one at a time, and after
/// each the pile topples until it is at rest:
///
///     drop      h(P) → h(P) + 1                                    (eq. 1)
///     unstable  h(Q) − h(n) ≥ T for some of the 8 neighbours n     (section 2.2.2; T = 5)
///     topple    h(Q) → h(Q) − g,  h(R) → h(R) + 1                  (eqs. 2, 3; g = 3)
///               for the three cells R around the direction B(Q); a drop site draws B anew each
///               time
///     turn      B(R) → B'(B(R), B_R)                               (eqs. 4, 5, table 2)
///
/// h: whole grains on nx × ny cells; outside is height 0 and swallows what falls there, so
/// initial + dropped = resident + lost, exactly. See toppling.h for B' and the legal g, pile.h for
/// the order. Avalanche sizes A_s are the distinct cells whose height changed in the toppling that
/// one grain set off, the drop site among them; a grain that comes to rest sets off none. Duration:
/// sweeps with a topple in them, or generations of the queue.
///
/// A step is `grains_per_step` grains, and time counts grains: the state depends on how many were
/// dropped, not on how they were shared out over steps. A bed that is not at rest settles before
/// the first grain, in the first step; that is no avalanche, its losses count as lost.
///
/// `topple_toward = toward_direction` counts only the neighbours n that would receive; drop sites,
/// whose direction is not known before they topple, and cells without one count all eight. A cell
/// without a direction that topples (of a given bed) draws one and keeps it.
///
/// Nothing proves that the published rule comes to rest from any bed: it moves grains uphill too,
/// where a cell's direction does not point at what makes it unstable. From an empty bed it always
/// has; with g = 1 and direction = mean, rough beds are known on which grains go round for ever.
/// That is noticed (CycleDetector). With g = 1 and toward_direction each topple lowers Σ h², so it
/// ends.
///
/// The published direction average is biased: on 64 × 64 cells the pile's centroid lies 11 cells
/// off the drop site after 60,000 grains; with `direction = circular_mean` 3 (sweep) or less than 2
/// (first in, first out).
class Sandpile : public Model {
  public:
    static constexpr std::string_view model_name = "sandpile";
    static constexpr Landform landform = Landform::pile;

    /// Throws KeyError for a masked bed, heights that are not whole or below 0, drop sites off the
    /// grid, and grains per topple that the threshold does not admit.
    Sandpile(const SandpileParameters& parameters, const ModelSetup& setup);

    [[nodiscard]] std::string_view name() const override { return model_name; }

    /// Throws Error where the toppling would never end.
    void step() override;
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] double time() const override { return static_cast<double>(dropped_); }
    [[nodiscard]] std::string_view time_unit() const override { return "grains"; }
    [[nodiscard]] std::span<const Avalanche> avalanches() const override { return avalanches_; }

    /// The bed; as field "last_avalanche" what the last avalanche did to each cell (Pile::changes);
    /// as numbers "dropped_grains", "lost_grains" and "avalanches" so far, and the first drop
    /// site "drop_x", "drop_y".
    [[nodiscard]] Snapshot snapshot() const override;

    /// "bed" and "direction" (nx × ny; 0 none yet, 1 … 8, 9 drop site), and "counts": grains
    /// dropped, grains lost, avalanches, directions drawn. The spans hold until the next call.
    [[nodiscard]] std::vector<StateField> state() const override;

    void serialise(StateArchive& archive) override;

  private:
    void drop_grain();
    [[nodiscard]] const Site& site_of_next_grain() const;

    SandpileParameters parameters_;
    WorldScale scale_;
    std::uint64_t seed_;
    std::vector<Site> sites_;
    Pile pile_;
    TopplingDraws draws_;
    std::int64_t steps_ = 0;
    std::int64_t dropped_ = 0;
    std::int64_t avalanche_count_ = 0;
    std::vector<Avalanche> avalanches_;  ///< of the last step
    mutable Grid state_bed_;
    mutable Grid state_direction_;
    mutable std::vector<double> state_counts_;
};

}  // namespace fumon
