#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/state_archive.h"
#include "models/sand/maxima_creep.h"
#include "models/sand/row_hops.h"
#include "models/sand/sand_parameters.h"
#include "models/shared/model.h"

namespace fumon {

/// Wind-blown sand: the family of Nishimori & Ouchi (1993), Sudo (2002) and Terada (2024, 2025).
/// Each step, sand hops along the wind (+x) and then creeps:
///
///     saltation   h(x) → h(x) − q,  h(x + L) → h(x + L) + q      see RowHops
///     creep       every cell, or strict maxima only               see creep.h
///                 or each row a profile of its own                see profile_creep.h
///
/// h: bed in model heights on nx × ny sites, periodic in x and y. In the random-sequential order
/// the nx·ny picks of a step fall on the rows as an exact multinomial, and each row runs its share
/// in its own random sequence, which is the published rule since rows do not interact while
/// hopping. In these rules the steep face is the upwind one; only the outline of a dune is a
/// barchan's.
class Sand : public Model {
  public:
    static constexpr std::string_view model_name = "sand";
    static constexpr Landform landform = Landform::bed;

    /// Throws InputError for a masked bed and for one whose longest first hop exceeds the box,
    /// KeyError for a creep rate that the creep rule does not allow.
    Sand(const SandParameters& parameters, ModelSetup setup);

    [[nodiscard]] std::string_view name() const override { return model_name; }
    void step() override;
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] Snapshot snapshot() const override;
    /// Where the exponential law's hops from the highest sand have come to go round the box.
    [[nodiscard]] std::string plausibility_warning() const override;
    [[nodiscard]] std::vector<StateField> state() const override {
        return {{"bed", bed_.values()}};
    }
    void serialise(StateArchive& archive) override {
        archive.count("steps", steps_);
        archive.values("bed", bed_.values());
    }

  private:
    /// What a thread works with, kept from step to step.
    struct Scratch {
        RowHops hops;
        Picks picks;
        std::array<std::vector<double>, 3> hopped{};  ///< rows that have not yet crept
        std::vector<double> behind{};                 ///< the row before a thread's, hopped
        std::vector<double> ahead{};                  ///< the one after its last, likewise
    };

    void share_picks();
    void hop_rows_and_creep();
    void hop_rows();
    void hop_only_row();
    void hop_row(Scratch& scratch, int y, std::span<double> after) const;
    void for_rows(const std::function<void(int begin, int end, Scratch& scratch)>& body);
    void creep_profiles();

    SandParameters parameters_;
    WorldScale scale_;
    std::uint64_t seed_;
    WorkerPool& pool_;
    std::int64_t steps_ = 0;
    Grid bed_;
    Grid next_;                        ///< empty where every cell creeps, which needs none
    std::vector<Scratch> scratch_;     ///< of each thread
    std::vector<std::int64_t> picks_;  ///< of each row, this step
    Picks drawn_;                      ///< of a single row: this step's …
    Picks drawn_ahead_;                ///< … and the next one's
    MaximaCreep maxima_creep_;
};

}  // namespace fumon
