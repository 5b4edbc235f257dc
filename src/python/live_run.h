#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "measure/suite.h"
#include "python/drawer.h"
#include "python/process.h"
#include "run/prepared_run.h"

namespace fumon::python {

/// A run between two steps, for Python to keep: its snapshot, what was measured of it and what
/// draws it. It stays as it is when the run continues.
struct Step {
    SharedSnapshot snapshot;
    std::vector<MeasureColumn> columns;  ///< none where the run measures nothing
    std::vector<double> values;          ///< NaN where a measure has no meaning
    MeasuredRows plotted;                ///< what plots over the pictures show
    std::shared_ptr<Drawer> drawer;
};

/// A run that Python steps, on the stepper of all runs. Any thread may call; one works at a time.
/// Callers do not hold the interpreter's lock.
class LiveRun {
  public:
    /// `threads` of the model; 0: one per processor. Throws as prepare_run().
    LiveRun(Scene scene, int threads, bool measures);
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    /// Steps to a step; none where that is done. Throws Error in a fork, what the model throws, and
    /// as check_signals(), between two steps.
    void advance(std::int64_t step);

    /// The present state, measured as rows of measurements.csv are: celerities since the last one.
    [[nodiscard]] Step present();

    /// The same, drawn as `fumon still` draws it: camera.at and camera.look_at count from the
    /// ground of the present state.
    [[nodiscard]] Step present_as_still();

    /// SHA-256 of the model's state, hexadecimal: that of run.json at the same step.
    [[nodiscard]] std::string state_hash();

    [[nodiscard]] std::int64_t steps_done();
    [[nodiscard]] std::int64_t last_step() const { return last_step_; }
    /// One line on what the user should hear of the first bed; or empty.
    [[nodiscard]] const std::string& note() const { return note_; }

  private:
    class Avalanches;

    std::mutex mutex_;
    Process process_;
    std::unique_ptr<PreparedRun> prepared_;
    std::optional<MeasureSuite> suite_;
    std::shared_ptr<Drawer> drawer_;
    std::int64_t last_step_ = 0;
    std::string note_;
};

}  // namespace fumon::python
