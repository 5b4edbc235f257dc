#include "verify/verify_figure.h"

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/scratch_folder.h"
#include "paper/figure_files.h"
#include "paper/figure_make.h"
#include "paper/figure_page.h"
#include "picture/png.h"
#include "run/interrupt.h"

namespace fumon {

namespace {

/// SHA-256 of the runs' states, one after another; of one run its own.
std::string state_of(const std::vector<RunRecord>& records) {
    if (records.size() == 1) return records.front().state;
    Sha256Stream all;
    for (const RunRecord& record : records) all.add(record.state.data(), record.state.size());
    return hex(all.finish());
}

}  // namespace

DrawnCase draw_figure_case(const Baseline& baseline, const BaselineCase& one,
                           const WorkOptions& work) {
    FigureSources sources;
    FigureRuns runs;
    DrawnCase drawn;
    const std::filesystem::path scene = baseline.file.parent_path() / one.scene;
    const auto plan = plan_figure(scene.string(), one.settings, sources, runs, nullptr);
    const ScratchFolder scratch;
    std::vector<RunRecord> records;
    if (plan) {
        StatusLine status(work.verbosity);
        records = make_runs(runs, RunStore(scratch.path()), work, status);
    }
    drawn.signal = interrupting_signal();
    if (drawn.signal != 0) return drawn;
    if (const std::string missing = missing_run(*plan, runs, records); !missing.empty())
        throw Error(missing);
    const FigurePage page =
        figure_page(*plan, runs, RunStore(scratch.path()), {work.backend, work.threads});
    const std::filesystem::path file = scratch.path() / "figure.png";
    write_file(file, draw_figure(*plan, page, PageFormat::png, {}).bytes);
    drawn.image = read_png(file);
    RenderingEnvironment environment;
    environment.backend = "cairo";
    environment.renderer = figure_library();
    drawn.record = {FUMON_VERSION, environment, state_of(records), fingerprint_of(drawn.image)};
    return drawn;
}

}  // namespace fumon
