#pragma once

#include <utility>

#include "base/state_archive.h"
#include "models/shared/model.h"

namespace fumon {

class KeyTable;

struct StaticParameters {};

/// Shows a bed as it is; steps do not change it. Cells without data are allowed.
class StaticBed : public Model {
  public:
    static constexpr std::string_view model_name = "static";
    static constexpr Landform landform = Landform::terrain;

    StaticBed(const StaticParameters& /*none*/, ModelSetup setup)
        : bed_(std::move(setup.bed)), nodata_(std::move(setup.nodata)), scale_(setup.scale) {}

    [[nodiscard]] std::string_view name() const override { return model_name; }
    void step() override { ++steps_; }
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] Snapshot snapshot() const override {
        Snapshot snapshot{steps_, time(), std::string(time_unit()), bed_, nodata_, scale_};
        snapshot.landform = landform;
        return snapshot;
    }
    [[nodiscard]] std::vector<StateField> state() const override {
        return {{"bed", bed_.values()}};
    }
    void serialise(StateArchive& archive) override { archive.count("steps", steps_); }

  private:
    Grid bed_;
    Mask nodata_;
    WorldScale scale_;
    std::int64_t steps_ = 0;
};

inline void list_keys(StaticParameters& /*none*/, KeyTable& /*table*/) {}

}  // namespace fumon
