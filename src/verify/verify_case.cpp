#include "verify/verify_case.h"

#include <fmt/format.h>

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/scratch_folder.h"
#include "models/shared/state_hash.h"
#include "paper/figure_files.h"
#include "paper/figure_make.h"
#include "paper/figure_page.h"
#include "picture/png.h"
#include "run/prepared_run.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/read.h"
#include "verify/ignored_in_case.h"

namespace fumon {

namespace {

/// SHA-256 of the runs' states, one after another; of one run its own.
std::string state_of(const std::vector<RunRecord>& records) {
    if (records.size() == 1) return records.front().state;
    Sha256Stream all;
    for (const RunRecord& record : records) all.add(record.state.data(), record.state.size());
    return hex(all.finish());
}

/// Makes the figure of a case's scene from runs of its own and draws it as pixels. Its state is
/// that of its runs. Throws InputError where the figure is wrong, Error where a run or a drawing
/// library fails.
DrawnCase draw_figure_case(const Baseline& baseline, const BaselineCase& one,
                           FigureSources& sources, const WorkOptions& work) {
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

/// Whether a line tells of the baseline alone, or of a limit.
bool may_be_reported(const std::string& line) {
    return line.starts_with("settings.") || line.starts_with("step ") ||
           line.starts_with("time ") || line.find("--trust") != std::string::npos;
}

/// Runs work() and locates its InputErrors at the case.
template <class Work>
auto located(const BaselineCase& one, bool trusted, const Work& work) {
    try {
        return work();
    } catch (const InputError& fault) {
        const std::string place = fmt::format("{}: cases.{}: ", one.place, one.name);
        std::vector<std::string> lines = fault.lines();
        if (!trusted) std::erase_if(lines, [](const auto& line) { return !may_be_reported(line); });
        if (lines.empty()) {
            lines.push_back(
                fmt::format("{} does not exist or is invalid; `fumon check` with its path, or "
                            "--trust here, gives details",
                            one.scene));
        }
        throw placed(place, InputError(std::move(lines)));
    }
}

std::int64_t step_of(const BaselineCase& one, const Scene& scene) {
    if (one.step <= scene.run.steps) return one.step < 0 ? scene.run.steps : one.step;
    throw InputError(
        fmt::format("step {} is after the run's end; {} runs {} steps (lengthen it by "
                    "settings = [\"run.steps={}\"])",
                    one.step, one.scene, scene.run.steps, one.step));
}

}  // namespace

std::string version_of(const Baseline& baseline, const BaselineCase& one, CaseDefaults defaults,
                       const std::string& record) {
    if (defaults == CaseDefaults::of_today) return {};
    if (const auto found = baseline.records.find(record); found != baseline.records.end())
        return found->second.fumon;
    for (const std::string& environment : one.environments) {
        const auto found = baseline.records.find(record_name(one.name, environment));
        if (found != baseline.records.end()) return found->second.fumon;
    }
    return {};
}

Scene scene_of(const Baseline& baseline, const BaselineCase& one, bool trusted,
               const std::string& version) {
    return located(one, trusted, [&] {
        std::vector<Override> overrides = read_settings(one.settings);
        for (std::size_t i = 0; i < overrides.size(); ++i)
            overrides[i].place = fmt::format("settings.{}", i + 1);
        SceneText text = read_scene_text(baseline.file.parent_path() / one.scene);
        text.trusted = trusted;
        text.version = version;
        return parse_scene(text, overrides);
    });
}

namespace {

/// As it looks, with nothing ignored yet; `overlays` gets those that stand on it,
/// where one may be ignored.
DrawnCase draw_whole_case(const Baseline& baseline, const BaselineCase& one, bool trusted,
                          const std::string& version, const WorkOptions& work,
                          std::vector<OverlayRectangle>& overlays) {
    if (one.figure) {
        return located(one, trusted, [&] {
            FigureSources sources(trusted, version);
            return draw_figure_case(baseline, one, sources, work);
        });
    }
    Scene scene = scene_of(baseline, one, trusted, version);
    return located(one, trusted, [&] {
        PreparedRun prepared = prepare_run(std::move(scene), work.threads);
        Progress progress(work.verbosity, static_cast<std::int64_t>(prepared.initial.bed.size()));
        const Snapshot first = prepared.model->snapshot();
        DrawnCase drawn;
        drawn.signal =
            one.time >= 0.0
                ? advance_to_time(prepared, one.time, fmt::format("time {}", one.time), progress)
                : advance_to(prepared, step_of(one, prepared.scene), progress);
        if (drawn.signal != 0) return drawn;
        Drawing drawing =
            draw_snapshot(still_subject(prepared), first, prepared.model->snapshot(), work);
        drawn.record = {FUMON_VERSION,
                        drawing.record.environment,
                        hex(state_hash(*prepared.model)),
                        fingerprint_of(drawing.image),
                        {},
                        drawing.record.under_overlays};
        drawn.image = std::move(drawing.image);
        if (!one.ignore.overlays.empty()) overlays = overlay_rectangles(prepared.scene, first);
        return drawn;
    });
}

/// The hash of a picture's pixels but for ignored ones; of one of another size that of all.
Sha256 hash_without(const Image& image, const IgnoredPixels& ignored) {
    const bool fits = image.width == ignored.width && image.height == ignored.height;
    return pixel_hash(fits && ignored.any() ? blanked(image, ignored) : image);
}

}  // namespace

DrawnCase draw_case(const Baseline& baseline, const BaselineCase& one, bool trusted,
                    const std::string& version, const WorkOptions& work) {
    std::vector<OverlayRectangle> overlays;
    DrawnCase drawn = draw_whole_case(baseline, one, trusted, version, work, overlays);
    if (drawn.signal != 0 || !one.ignore.any()) return drawn;
    drawn.ignored = ignored_in_case(baseline, one, trusted, drawn.image, overlays);
    drawn.record.ignored = drawn.ignored.hash();
    drawn.record.fingerprint = fingerprint_of(blanked(drawn.image, drawn.ignored));
    return drawn;
}

std::optional<Image> recorded_picture(const Baseline& baseline, const BaselineCase& one,
                                      const std::string& name, const BaselineRecord& record,
                                      const IgnoredPixels& ignored) {
    const auto file = baseline.picture_of(name);
    if (!one.picture || !std::filesystem::exists(file)) return std::nullopt;
    Image image = read_png(file);
    if (ignored.hash() != record.ignored) return image;  // judge() says so
    if (hash_without(image, ignored) != record.fingerprint.pixels) {
        throw InputError(
            fmt::format("{}: is not the picture that {} recorded for {}; restore it, or accept a "
                        "new one with `fumon verify --update`",
                        file.string(), baseline.lock().string(), name));
    }
    return image;
}

}  // namespace fumon
