#include "run/still.h"

#include <fmt/format.h>

#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"
#include "picture/png.h"
#include "run/drawing.h"
#include "run/picture_text.h"
#include "run/step_observers.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

int advance(Workshop& workshop, const RunEnd& end, Progress& progress) {
    Model& model = *workshop.model;
    const bool gathers = workshop.plotted != nullptr;
    if (!gathers && !plotted_columns(workshop.scene).empty()) {
        Recording plots_alone;
        plots_alone.plots = true;
        workshop.plotted =
            std::make_unique<Recorder>(workshop.scene, model.snapshot(), std::move(plots_alone));
    }
    ShownSteps shown(progress);
    std::vector<StepObserver*> observers{&shown};
    if (workshop.plotted) observers.insert(observers.begin(), workshop.plotted.get());
    const int signal = Stepper(model, std::move(observers), gathers).advance(end);
    if (signal == 0) progress.clear();
    return signal;
}

}  // namespace

int advance_to(Workshop& workshop, std::int64_t step, Progress& progress) {
    progress.expect(step, 0);
    return advance(workshop, at_step(step), progress);
}

int advance_to_time(Workshop& workshop, double time, const std::string& asked, Progress& progress) {
    const std::int64_t last_step = workshop.scene.run.steps;
    progress.expect(last_step, 0);
    const RunEnd end = [&](const Model& model) {
        return model.time() >= time || model.steps_done() >= last_step;
    };
    const int signal = advance(workshop, end, progress);
    if (signal == 0 && workshop.model->time() < time) {
        throw InputError(fmt::format("{} is after the run's end at {} {}; lengthen run.steps",
                                     asked, workshop.model->time(), workshop.model->time_unit()));
    }
    return signal;
}

Drawing draw_present(Workshop& workshop, const Snapshot& first, const WorkOptions& work) {
    WorkerPool pool(work.threads, "fumon-render");
    const auto painter = make_frame_painter(workshop.scene, first, work.backend, pool);
    const MeasuredRows rows = workshop.plotted ? workshop.plotted->rows() : MeasuredRows{};
    return {painter->paint(workshop.model->snapshot(), rows), painter->record()};
}

DrawnStill draw_still(Workshop& workshop, const Snapshot& first, const std::string& file,
                      const WorkOptions& work, Progress& progress) {
    const Scene& scene = workshop.scene;
    const auto [image, drawing] = draw_present(workshop, first, work);
    tell_drawing(drawing, progress);
    const Sha256 pixels = pixel_hash(image);
    const auto texts = picture_text(resolved_scene(scene, workshop.initial.inputs), scene,
                                    workshop.model->steps_done(), workshop.initial.inputs, pixels,
                                    drawing.environment);
    write_file(file, encode_png(image, scene.view.image.dots_per_inch, texts));
    if (drawing.exaggeration != 1.0) {
        progress.note(fmt::format("vertical exaggeration {:g}", drawing.exaggeration));
    }
    return {pixels, drawing.environment};
}

}  // namespace fumon
