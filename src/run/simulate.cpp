#include "run/simulate.h"

#include <vector>

#include "run/step_observers.h"

namespace fumon {

namespace {

/// Counts for those who wait for many runs.
class SharedCounts : public StepObserver {
  public:
    SharedCounts(std::size_t cells, std::int64_t& steps, std::atomic<double>& cell_steps)
        : cells_(static_cast<double>(cells)), steps_(steps), cell_steps_(cell_steps) {}
    void after_step(const Model& model) override {
        steps_ = model.steps_done();
        cell_steps_ += cells_;
    }

  private:
    double cells_;
    std::int64_t& steps_;
    std::atomic<double>& cell_steps_;
};

/// A failing run keeps what it measured before, if that can still be written.
void keep(Recorder& recorder) {
    try {
        recorder.commit();
    } catch (const std::exception&) {
        return;  // the run's own fault is what is told
    }
}

}  // namespace

bool simulate(PreparedRun& prepared, Recorder& recorder, RunRecord& record,
              std::atomic<double>& cell_steps, StepObserver* beside) {
    SharedCounts counted(prepared.initial.bed.size(), record.steps, cell_steps);
    PlausibilityReporter plausibility_warning(
        [&record](const std::string& line) { record.message = "implausible: " + line; });
    std::vector<StepObserver*> observers{&recorder, &counted, &plausibility_warning};
    if (beside != nullptr) observers.push_back(beside);
    Stepper stepper(*prepared.model, observers);
    try {
        if (stepper.advance(at_step(prepared.scene.run.steps)) != 0) return false;
    } catch (...) {
        keep(recorder);
        throw;
    }
    recorder.commit();
    return true;
}

}  // namespace fumon
