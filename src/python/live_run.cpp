#include "python/live_run.h"

#include <utility>

#include "models/shared/state_hash.h"
#include "python/signal_polling.h"
#include "run/still.h"

namespace fumon::python {

/// Hands the steps' avalanches to the measures.
class LiveRun::Avalanches : public StepObserver {
  public:
    explicit Avalanches(std::optional<MeasureSuite>& suite) : suite_(suite) {}
    void after_step(const Model& model) override {
        if (suite_) suite_->note(model.avalanches());
    }

  private:
    std::optional<MeasureSuite>& suite_;
};

LiveRun::LiveRun(Scene scene, int threads, bool measures)
    : prepared_(std::make_unique<PreparedRun>(prepare_run(std::move(scene), threads))) {
    const auto first = std::make_shared<const Snapshot>(prepared_->model->snapshot());
    prepared_->initial.bed = Grid();  // the model has its own
    if (measures)
        suite_.emplace(measured_landform(*first), *first, recorded_measures(prepared_->scene));
    drawer_ = std::make_shared<Drawer>(prepared_->scene, prepared_->initial.inputs, first);
    last_step_ = prepared_->scene.run.steps;
    note_ = prepared_->initial.note;
}

LiveRun::~LiveRun() {
    if (!process_.is_this()) static_cast<void>(prepared_.release());  // its threads are not here
}

void LiveRun::advance(std::int64_t step) {
    process_.check();
    const std::lock_guard lock(mutex_);
    Avalanches avalanches(suite_);
    SignalObserver signals;
    fumon::advance(*prepared_, at_step(step), {&avalanches, &signals});
}

Step LiveRun::present() {
    process_.check();
    const std::lock_guard lock(mutex_);
    Step step;
    step.snapshot = std::make_shared<const Snapshot>(prepared_->model->snapshot());
    if (suite_) {
        step.columns = suite_->columns();
        step.values = suite_->row(*step.snapshot);
    }
    if (prepared_->plotted) step.plotted = prepared_->plotted->rows();
    step.drawer = drawer_;
    return step;
}

Step LiveRun::present_as_still() {
    Step step = present();
    const SharedSnapshot first = step.drawer->first();
    if (step.snapshot->step == first->step) return step;
    Scene scene = step.drawer->scene();
    stand_on_drawn_ground(scene.view, *first, *step.snapshot);
    step.drawer = std::make_shared<Drawer>(std::move(scene), step.drawer->inputs(), first);
    return step;
}

std::string LiveRun::state_hash() {
    process_.check();
    const std::lock_guard lock(mutex_);
    return hex(fumon::state_hash(*prepared_->model));
}

std::int64_t LiveRun::steps_done() {
    process_.check();
    const std::lock_guard lock(mutex_);
    return prepared_->model->steps_done();
}

}  // namespace fumon::python
