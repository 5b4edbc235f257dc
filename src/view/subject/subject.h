#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "measure/measured_rows.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A moment of a run that can be shown.
struct ShownMoment {
    std::int64_t step = 0;
    double time = 0.0;
    bool ready = true;  ///< else it is still to be computed
};

/// What is being computed.
struct ViewWork {
    std::string state;  ///< "complete", "running", "computing" …
    std::int64_t step = 0;
    std::int64_t target = 0;
    double cell_steps_per_second = 0.0;  ///< 0: nothing to tell
    std::string fault{};                 ///< why it goes on no more; empty: nothing is wrong
};

/// A column of numbers for plots.
struct ViewColumn {
    std::string name;
    std::string unit;
    std::vector<double> values;  ///< NaN where the measure has no meaning
};

/// What `fumon view` shows: a run with its moments, or a bed alone with one. Any thread may call
/// it.
class ViewSubject {
  public:
    virtual ~ViewSubject() = default;
    ViewSubject() = default;
    ViewSubject(const ViewSubject&) = delete;
    ViewSubject& operator=(const ViewSubject&) = delete;

    [[nodiscard]] virtual std::string name() const = 0;
    /// As it is drawn when nothing is changed.
    [[nodiscard]] virtual const Scene& scene() const = 0;
    [[nodiscard]] virtual const std::vector<InputFile>& inputs() const = 0;
    /// What pictures record of another model's results, see StillSubject.
    [[nodiscard]] virtual std::string results() const { return {}; }
    [[nodiscard]] virtual const Snapshot& first() const = 0;
    /// At least one, in the order of their steps. Of a run that goes on they become more.
    [[nodiscard]] virtual std::vector<ShownMoment> moments() = 0;
    /// The snapshot of a moment by its number. Null where it is not computed yet, which begins by
    /// that. Throws InputError where there is no such moment.
    [[nodiscard]] virtual std::shared_ptr<const Snapshot> snapshot(std::size_t number) = 0;
    /// What plots over the picture of such a moment show.
    [[nodiscard]] virtual MeasuredRows rows(const std::vector<std::string>& columns,
                                            std::size_t number) = 0;
    /// The measurements so far, with "step" and "time"; none where there are none.
    [[nodiscard]] virtual std::vector<ViewColumn> measurements() = 0;
    [[nodiscard]] virtual ViewWork work() = 0;
    /// The files that are read.
    [[nodiscard]] virtual std::vector<std::filesystem::path> files() const = 0;
};

}  // namespace fumon
