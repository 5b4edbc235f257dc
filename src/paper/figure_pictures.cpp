#include "paper/figure_pictures.h"

namespace fumon {

FigurePictures::FigurePictures(const FigurePlan& plan, const FigureRuns& runs,
                               const RunStore& store, const FigureDrawing& drawing)
    : tools_{plan, runs, store, drawing.backend, WorkerPool(drawing.threads), nullptr} {}

std::vector<MadePanel> FigurePictures::make(const PanelPlan& panel, double width) {
    Snapshot first;
    std::vector<Snapshot> snapshots;
    if (panel.picture) {
        const auto at = [&](std::int64_t step) {
            return tools_.store.snapshot(tools_.runs[panel.picture->run], step);
        };
        first = at(0);
        for (const std::int64_t step : panel.picture->steps) snapshots.push_back(at(step));
    }
    const auto make = maker_of(panel.settings.kind).make;
    std::vector<MadePanel> made = make({panel, first, snapshots, width}, tools_);
    const Scene& scene = panel.picture ? panel.picture->scene : tools_.plan.scene;
    for (std::size_t k = 0; k < made.size(); ++k) {
        made[k].title =
            panel_title(panel.settings, scene, snapshots.empty() ? nullptr : &snapshots[k]);
    }
    return made;
}

}  // namespace fumon
