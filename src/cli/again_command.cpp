#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "cli/command.h"
#include "cli/shared_options.h"
#include "figure/canvas/figure_metadata.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "paper/figure_files.h"
#include "paper/figure_make.h"
#include "paper/figure_page.h"
#include "run/drawing.h"
#include "run/picture_text.h"
#include "run/pipeline.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/find_input.h"
#include "scene/read.h"

namespace fumon {

namespace {

struct AgainOptions {
    std::string picture;
    std::string output;  ///< empty: NAME-again.png (or .mp4, .pdf, .svg) in the working folder
    std::string runs;    ///< of a figure: the folder of finished runs; empty: "runs" beside it
    WorkOptions work;
};

void declare(CLI::App& command, AgainOptions& options) {
    command.add_option("PICTURE", options.picture, "a PNG, MP4, PDF or SVG that fumon made")
        ->required();
    command
        .add_option("-o,--output", options.output,
                    "what is made (default: NAME-again.png, .mp4, .pdf or .svg here)")
        ->type_name("FILE");
    command
        .add_option("--runs", options.runs,
                    "of a figure: where finished runs are kept (default: runs beside it)")
        ->type_name("FOLDER");
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
}

namespace fs = std::filesystem;

/// What may have changed the pixels, as far as the picture tells.
std::string why_different(const PictureOrigin& origin, const RenderingEnvironment& here) {
    const std::string versions =
        origin.version == FUMON_VERSION
            ? fmt::format("both by fumon {}", FUMON_VERSION)
            : fmt::format("made by fumon {}, this is {}", origin.version, FUMON_VERSION);
    if (!origin.environment)
        return versions + "; another OpenGL driver or processor also changes pixels";
    const std::string reason = why_pixels_may_differ(*origin.environment, here);
    if (reason.empty()) return versions + "; what drew them is the same";
    return versions + "; " + reason;
}

fs::path output_of(const AgainOptions& options) {
    if (!options.output.empty()) return options.output;
    const fs::path picture = options.picture;
    return picture.stem().string() + "-again" + picture.extension().string();
}

/// The texts of a figure's file; none where it is another picture.
FigureMetadata figure_texts(const fs::path& picture) {
    const std::string end = picture.extension().string();
    if (end != ".pdf" && end != ".svg" && end != ".png") return {};
    return read_figure_metadata(read_input_file(picture), picture.string());
}

int figure_again(const AgainOptions& options, const FigureOrigin& origin) {
    const fs::path output = output_of(options);
    const PageFormat format = page_format(output);
    StatusLine status(options.work.verbosity);
    FigureSources sources(origin.texts, origin.inputs, [&](const InputFile& input) {
        return find_input(input, options.picture, "figure");
    });
    std::vector<std::string> settings = origin.settings;
    settings.insert(settings.end(), options.work.settings.begin(), options.work.settings.end());
    FigureRuns runs;
    const RunStore store(options.runs.empty() ? fs::path(options.picture).parent_path() / "runs"
                                              : fs::path(options.runs));
    const auto plan = plan_figure(origin.scene, settings, sources, runs, &store);
    if (!plan) return tell_interrupted(status, {});
    const std::vector<RunRecord> records = make_runs(runs, store, options.work, status);
    if (interrupting_signal() != 0) return tell_interrupted(status, records);
    if (const std::string missing = missing_run(*plan, runs, records); !missing.empty())
        throw Error(missing);
    const FigurePage made =
        figure_page(*plan, runs, store, {options.work.backend, options.work.threads});
    const DrawnPage drawn = draw_figure(*plan, made, format, figure_metadata(*plan, sources));
    write_file(output, drawn.bytes);
    if (!drawn.missing_letters.empty()) status.note(drawn.missing_letters);
    const bool other_format = output.extension() != fs::path(options.picture).extension();
    if (other_format || !options.work.settings.empty()) {
        status.note(fmt::format("{}: made", output.string()));
    } else if (drawn.bytes == read_input_file(options.picture)) {
        status.note(fmt::format("{}: the same bytes as {}", output.string(), options.picture));
    } else {
        status.note(fmt::format(
            "{}: made, but its bytes differ from {} (made by fumon {}, this is {}; other fonts and "
            "text libraries, and for 3-D views another OpenGL driver, also change them)",
            output.string(), options.picture, origin.version, FUMON_VERSION));
    }
    return 0;
}

/// What may have changed the pixels of a movie, or the bytes alone.
std::string differences(const PictureOrigin& origin, const PictureOrigin& made) {
    std::string text;
    const auto add = [&text](const char* what, const std::string& then, const std::string& now) {
        if (then != now) text += fmt::format("; {} was {}, is {}", what, then, now);
    };
    add("fumon", origin.version, made.version);
    add("encoder", origin.encoder, made.encoder);
    if (origin.environment && made.environment) {
        const std::string reason = why_pixels_may_differ(*origin.environment, *made.environment);
        if (!reason.empty()) text += "; " + reason;
    }
    return text.empty() ? "; nothing that the movie tells of its making differs" : text;
}

void compare_movies(const std::string& file, const Sha256& before, const AgainOptions& options,
                    const PictureOrigin& origin, Progress& progress) {
    if (!options.work.settings.empty()) {
        progress.note(fmt::format("{}: made", file));
        return;
    }
    const PictureOrigin made = read_origin(file);
    if (file_hash(file) == before) {
        progress.note(fmt::format("{}: the same bytes as {}", file, options.picture));
    } else if (made.pixels_hash == origin.pixels_hash) {
        progress.note(fmt::format("{}: the same frames as {}, encoded otherwise{}", file,
                                  options.picture, differences(origin, made)));
    } else {
        progress.note(fmt::format("{}: made, but its frames differ from those of {}{}", file,
                                  options.picture, differences(origin, made)));
    }
}

/// The movie alone, up to the frame with which the first one ended.
int movie_again(Scene scene, const AgainOptions& options, const PictureOrigin& origin) {
    PreparedRun prepared = prepare_run(std::move(scene), options.work.threads);
    if (!origin.inputs.empty()) prepared.initial.inputs = origin.inputs;
    PipelineOptions how{options.work.backend, options.work.threads};
    how.last_step = origin.step;
    const fs::path output = output_of(options);
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()));
    const Sha256 before = file_hash(options.picture);
    const RunOutcome outcome =
        run_pipeline(*prepared.model, prepared.scene, prepared.initial.inputs, {nullptr, output},
                     how, progress, [](const DrawingRecord&) {});
    progress.clear();
    if (outcome.error) std::rethrow_exception(outcome.error);
    if (outcome.signal != 0) return exit_status_of_signal(outcome.signal);
    compare_movies(output.string(), before, options, origin, progress);
    const ImageSettings& image = prepared.scene.view.image;
    if (const std::string text = padding_text(output.string(), outcome.movie, image); !text.empty())
        progress.note(text);
    return 0;
}

int picture_again(Scene scene, const AgainOptions& options, const WorkOptions& work,
                  const PictureOrigin& origin) {
    PreparedRun prepared = prepare_run(std::move(scene), work.threads);
    Progress progress(work.verbosity, static_cast<std::int64_t>(prepared.initial.bed.size()));
    const Snapshot first = prepared.model->snapshot();
    if (const int signal = advance_to(prepared, origin.step, progress); signal != 0)
        return exit_status_of_signal(signal);

    const fs::path output = output_of(options);
    const DrawnStill still = draw_still(prepared, first, output.string(), work, progress);
    const std::string pixels = hex(still.pixels);
    if (origin.pixels_hash.empty() || !options.work.settings.empty()) {
        progress.note(fmt::format("{}: made", output.string()));
    } else if (pixels == origin.pixels_hash) {
        progress.note(fmt::format("{}: the same pixels as {}", output.string(), options.picture));
    } else {
        progress.note(fmt::format("{}: made, but its pixels differ from {} ({})", output.string(),
                                  options.picture, why_different(origin, still.environment)));
    }
    return 0;
}

int perform(const AgainOptions& options) {
    const InterruptGuard guard;
    if (const FigureMetadata texts = figure_texts(options.picture); is_figure(texts))
        return figure_again(options, read_figure_origin(texts, options.picture));
    const PictureOrigin origin = read_origin(options.picture);
    WorkOptions work = options.work;
    work.pinned = work.pinned || (origin.environment && origin.environment->pinned);
    prepare_drawing(work);
    Scene scene = parse_scene(origin.scene, options.picture, "", options.work.settings);
    if (!origin.inputs.empty()) {
        scene.bed.file = find_input(origin.inputs.front(), options.picture,
                                    origin.is_movie ? "movie" : "picture")
                             .string();
    }
    return origin.is_movie ? movie_again(std::move(scene), options, origin)
                           : picture_again(std::move(scene), options, work, origin);
}

}  // namespace

Command again_command() {
    return make_command<AgainOptions>(
        "again", "make a picture, movie or figure again from its own metadata", declare, perform);
}

}  // namespace fumon
