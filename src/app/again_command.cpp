#include <fmt/format.h>

#include <utility>

#include "app/commands.h"
#include "app/find_input.h"
#include "app/interrupt.h"
#include "app/picture_text.h"
#include "app/pipeline.h"
#include "app/run_folder.h"
#include "app/workshop.h"
#include "scene/read.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr int status_of_signal = 128;

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

fs::path output_of(const AgainOptions& options, bool movie) {
    if (!options.output.empty()) return options.output;
    return fs::path(options.picture).stem().string() + (movie ? "-again.mp4" : "-again.png");
}

/// What may have changed the pixels of a movie, or the bytes alone.
std::string differences(const PictureOrigin& origin, const PictureOrigin& made) {
    std::string text;
    const auto add = [&text](const char* what, const std::string& then, const std::string& now) {
        if (then != now) text += fmt::format("; {} was {}, is {}", what, then, now);
    };
    add("fumon", origin.version, made.version);
    if (origin.environment && made.environment) {
        const std::string drawing = difference(*origin.environment, *made.environment);
        if (!drawing.empty()) text += "; " + drawing;
    }
    add("encoder", origin.encoder, made.encoder);
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
    Workshop workshop = set_up(std::move(scene), options.work.threads);
    if (!origin.inputs.empty()) workshop.initial.inputs = origin.inputs;
    PipelineOptions how{options.work.backend, options.work.threads};
    how.movie = output_of(options, true);
    how.last_step = origin.step;
    how.resolved = resolved_scene(workshop.scene, workshop.initial.inputs);
    OutputSettings& output = workshop.scene.output;
    const OutputSettings recorded = std::exchange(output, {});
    output.frames = false;
    output.movie = true;
    output.movie_rate = recorded.movie_rate;
    output.movie_quality = recorded.movie_quality;
    output.measurements = false;
    output.avalanches = false;

    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(workshop.initial.bed.size()));
    RunFolder nowhere({}, true);
    const Sha256 before = file_hash(options.picture);
    const RunOutcome outcome =
        run_pipeline(*workshop.model, workshop.scene, workshop.initial.inputs, nowhere, how,
                     progress, [](const DrawingRecord&) {});
    progress.clear();
    if (outcome.error) std::rethrow_exception(outcome.error);
    if (outcome.signal != 0) return status_of_signal + outcome.signal;
    compare_movies(how.movie->string(), before, options, origin, progress);
    return 0;
}

int picture_again(Scene scene, const AgainOptions& options, const PictureOrigin& origin) {
    Workshop workshop = set_up(std::move(scene), options.work.threads);
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(workshop.initial.bed.size()));
    const Snapshot first = workshop.model->snapshot();
    if (const int signal = advance_to(workshop, origin.step, progress); signal != 0)
        return status_of_signal + signal;

    const fs::path output = output_of(options, false);
    const DrawnStill still = draw_still(workshop, first, output.string(), options.work, progress);
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

}  // namespace

int again_command(const AgainOptions& asked) {
    const InterruptGuard guard;
    const PictureOrigin origin = read_origin(asked.picture);
    AgainOptions options = asked;
    options.work.pinned = options.work.pinned || (origin.environment && origin.environment->pinned);
    prepare_drawing(options.work);
    Scene scene = parse_scene(origin.scene, options.picture, "", options.work.settings);
    if (!origin.inputs.empty()) {
        scene.bed.file = find_input(origin.inputs.front(), options.picture,
                                    origin.is_movie ? "movie" : "picture")
                             .string();
    }
    return origin.is_movie ? movie_again(std::move(scene), options, origin)
                           : picture_again(std::move(scene), options, origin);
}

}  // namespace fumon
