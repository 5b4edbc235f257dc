#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "figure/canvas/figure_metadata.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "film/beds/stored_still.h"
#include "film/film_again.h"
#include "film/results_again.h"
#include "outputs/output_claims.h"
#include "paper/figure_files.h"
#include "paper/figure_make.h"
#include "paper/figure_page.h"
#include "picture/stills/picture_file.h"
#include "run/drawing.h"
#include "run/inputs/find_input.h"
#include "run/picture_text.h"
#include "run/pipeline.h"
#include "run/prepared_run.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/input_maps.h"
#include "scene/overlay_keys.h"
#include "scene/read.h"
#include "scene/scene_files.h"
#include "scene/trust.h"

namespace fumon {

namespace {

struct AgainOptions {
    std::string picture;
    std::string output;  ///< empty: NAME-again.png (or .jpg, .exr, .mp4 …) in the working folder
    std::string runs;    ///< of a figure: the folder of finished runs; empty: "runs" beside it
    bool force = false;
    bool trust = false;             ///< what the picture asks for, without limits
    std::vector<std::string> from;  ///< files of other models' results to take
    WorkOptions work;
};

void declare(CLI::App& command, AgainOptions& options) {
    command
        .add_option("PICTURE", options.picture,
                    "a PNG, JPEG, WebP, TIFF, OpenEXR, MP4, PDF, EPS or SVG that fumon made, or a "
                    "film of any format")
        ->required();
    command
        .add_option("-o,--output", options.output,
                    "what is made (default: NAME-again and the ending of PICTURE, here)")
        ->type_name("FILE");
    command
        .add_option("--runs", options.runs,
                    "of a figure: where finished runs are kept (default: runs beside it)")
        ->type_name("FOLDER");
    command
        .add_option("--from", options.from,
                    "of a picture of another model's results: their file, as it is now "
                    "(of a film, a file a run)")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    add_force(command, options.force);
    command.add_flag("--trust", options.trust,
                     "lift the limits on what a picture of unknown origin may ask for");
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon again dunes.png", "the same picture from itself: dunes-again.png"},
         {"fumon again dunes.png -o large.png --set image.width=3840", "larger"},
         {"fumon again flood.png --from other.nc", "of another file of results"}},
        fmt::format("A picture may come from anyone. Of files it may name only inputs that its "
                    "metadata lists "
                    "with their\nSHA-256, and without --trust it may ask for at most {} cells, {} "
                    "steps, {:g} cell-steps,\n{} samples of a picture and {} frames.",
                    with_commas(trust_limits.cells), with_commas(trust_limits.steps),
                    trust_limits.cell_steps, with_commas(trust_limits.samples),
                    with_commas(trust_limits.frames)));
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

/// `usual`: the ending of the file unless -o says another.
fs::path output_of(const AgainOptions& options, std::string_view usual) {
    if (!options.output.empty()) return options.output;
    return fs::path(options.picture).stem().string() + "-again" + std::string(usual);
}

/// Claims the file to write; `inputs`: what is read beside the picture.
void claim_output(const AgainOptions& options, const fs::path& output,
                  const std::vector<fs::path>& inputs) {
    OutputClaims claims(options.force);
    claims.reads(options.picture);
    claims.reads(inputs);
    claims.writes(output);
}

/// The texts of a figure's file; none where it is another picture.
FigureMetadata figure_texts(const fs::path& picture) {
    const std::string end = small_ending(picture);
    constexpr std::array<std::string_view, 6> endings{".pdf", ".svg",  ".png",
                                                      ".tif", ".tiff", ".eps"};
    if (std::ranges::find(endings, end) == endings.end()) return {};
    return read_figure_metadata(read_input_file(picture), picture.string());
}

/// All runs of a figure together may ask for as much as one may.
void check_work(const FigureRuns& runs, const std::string& figure) {
    double work = 0.0;
    for (const StoredRun& run : runs.all()) work += run.work;
    if (work <= trust_limits.cell_steps) return;
    throw InputError(
        fmt::format("{}: its runs take {:.3g} cell-steps, more than the {:g} allowed to "
                    "figures of unknown origin; --trust lifts this limit",
                    figure, work, trust_limits.cell_steps));
}

int figure_again(const AgainOptions& options, const FigureOrigin& origin) {
    const fs::path output = output_of(options, small_ending(options.picture));
    const PageFormat format = page_format(output);
    StatusLine status(options.work.verbosity);
    std::vector<fs::path> inputs;
    FigureSources sources(
        origin.texts, origin.inputs,
        [&](const InputFile& input) {
            return inputs.emplace_back(find_input(input, options.picture, "figure"));
        },
        options.trust, origin.defaults);
    std::vector<std::string> settings = origin.settings;
    settings.insert(settings.end(), options.work.settings.begin(), options.work.settings.end());
    FigureRuns runs;
    const fs::path kept = options.runs.empty() ? fs::path(options.picture).parent_path() / "runs"
                                               : fs::path(options.runs);
    const RunStore store(kept);
    const auto plan = plan_figure(origin.scene, settings, sources, runs, &store);
    if (!plan) return report_interrupted(status, {});
    for (const InputFile& input : plan->inputs) inputs.emplace_back(input.path);
    claim_output(options, output, inputs);
    check_output_folder(kept, "the runs");
    if (!options.trust) check_work(runs, options.picture);
    const std::vector<RunRecord> records = make_runs(runs, store, options.work, status);
    if (interrupting_signal() != 0) return report_interrupted(status, records);
    if (const std::string missing = missing_run(*plan, runs, records); !missing.empty())
        throw Error(missing);
    const FigurePage made =
        figure_page(*plan, runs, store, {options.work.backend, options.work.threads});
    const DrawnPage drawn = draw_figure(*plan, made, format, figure_metadata(*plan, sources));
    write_file(output, drawn.bytes);
    if (!drawn.missing_letters.empty()) status.note(drawn.missing_letters);
    const bool other_format = small_ending(output) != small_ending(options.picture);
    if (other_format || !options.work.settings.empty()) {
        status.note(fmt::format("{}: made", output.string()));
    } else if (drawn.bytes == read_input_file(options.picture)) {
        status.note(fmt::format("{}: the same bytes as {}", output.string(), options.picture));
    } else {
        status.note(fmt::format(
            "{}: made, but its bytes differ from {} (made by fumon {}, this is {}; other fonts and "
            "text libraries, for 3-D views another OpenGL driver, and programs that write files "
            "anew, "
            "also change them)",
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
    return text.empty() ? "; the parameters recorded in the movie are the same" : text;
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

/// A run to a step, within what a picture of unknown origin may ask for.
PreparedRun prepare(Scene scene, std::int64_t step, int threads) {
    const ExitOnSignal nothing_is_written;
    PreparedScene prepared = prepare_scene(std::move(scene));
    check_limits(prepared.scene, static_cast<std::int64_t>(prepared.initial.bed.size()), step);
    return prepare_run(std::move(prepared), threads);
}

/// Whether a scene reads a file that the command line names.
bool reads_another_file(Scene& scene) {
    return std::ranges::any_of(input_keys(scene), [&](const InputKey& key) {
        return scene.set_on_command_line(key.path);
    });
}

/// The movie alone, up to the frame with which the first one ended.
int movie_again(Scene scene, const AgainOptions& options, const PictureOrigin& origin) {
    PreparedRun prepared = prepare(std::move(scene), origin.step, options.work.threads);
    if (!prepared.initial.inputs.empty() && !reads_another_file(prepared.scene))
        prepared.initial.inputs = origin.inputs;  // as they were named then
    PipelineOptions how{options.work.backend, options.work.threads};
    how.last_step = origin.step;
    const fs::path output = output_of(options, movie_ending.front());
    claim_output(options, output, scene_files(prepared.scene));
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

bool is_exr_name(const fs::path& file) {
    return small_ending(file) == exr_ending.front();
}

/// Whether pictures of that ending may have other pixels than what was drawn.
bool loses(const std::string& ending) {
    return ending == ".jpg" || ending == ".webp";
}

/// Says what a picture that is drawn again has in common with the first one, of which `before` is
/// the hash.
void compare_stills(const std::string& file, const DrawnStill& still, const Sha256& before,
                    const AgainOptions& options, const PictureOrigin& origin, Progress& progress) {
    const std::string pixels = hex(still.pixels);
    const bool other_format = is_exr_name(file) != origin.is_exr ||
                              picture_format(file) != picture_format("picture" + origin.ending);
    const bool is_another = !options.work.settings.empty() || !options.from.empty();
    if (origin.pixels_hash.empty() || other_format || is_another) {
        progress.note(fmt::format("{}: made", file));
    } else if (pixels == origin.pixels_hash && loses(origin.ending) && file_hash(file) != before) {
        progress.note(fmt::format("{}: drawn with the same pixels as {}, encoded otherwise", file,
                                  options.picture));
    } else if (pixels == origin.pixels_hash) {
        progress.note(fmt::format("{}: the same pixels as {}", file, options.picture));
    } else {
        progress.note(fmt::format("{}: made, but its pixels differ from {} ({})", file,
                                  options.picture, why_different(origin, still.environment)));
    }
}

int picture_again(Scene scene, const AgainOptions& options, const WorkOptions& work,
                  const PictureOrigin& origin) {
    PreparedRun prepared = prepare(std::move(scene), origin.step, work.threads);
    if (!prepared.initial.inputs.empty() && !reads_another_file(prepared.scene))
        prepared.initial.inputs = origin.inputs;  // as they were named then
    const fs::path output = output_of(options, origin.ending);
    check_still(prepared.scene, prepared.model->snapshot(), output.string());
    claim_output(options, output, scene_files(prepared.scene));
    Progress progress(work.verbosity, static_cast<std::int64_t>(prepared.initial.bed.size()));
    const Snapshot first = prepared.model->snapshot();
    if (const int signal = advance_to(prepared, origin.step, progress); signal != 0)
        return exit_status_of_signal(signal);

    const Sha256 before = file_hash(options.picture);
    const DrawnStill still = draw_still(still_subject(prepared), first, prepared.model->snapshot(),
                                        output.string(), work, progress);
    compare_stills(output.string(), still, before, options, origin, progress);
    return 0;
}

/// Makes the files that the scene reads those that its metadata lists, as they lie now; a file
/// given on the command line stays, and so does the bed of other models' results.
void find_listed(Scene& scene, const PictureOrigin& origin, const std::string& picture) {
    const std::vector<InputKey> keys = input_keys(scene);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const InputKey& key = keys[k];
        if (scene.set_on_command_line(key.path)) continue;
        if (key.path == "bed.file" && !origin.results.empty()) continue;
        const InputFile* input = find_by(origin.inputs, &InputFile::path, *key.file);
        if (k < origin.inputs.size() && origin.inputs[k].path == *key.file)
            input = &origin.inputs[k];  // files of two folders may have one name
        if (input == nullptr) {
            throw InputError(fmt::format(
                "{}: its scene starts from {}, which its metadata does not list with its SHA-256; "
                "to start from a file of your own, give it with --set {}=FILE",
                picture, *key.file, key.path));
        }
        try {
            *key.file = find_input(*input, picture, origin.is_movie ? "movie" : "picture").string();
        } catch (const InputError& fault) {
            throw InputError(
                fmt::format("{}; to start from another file, give it with --set {}=FILE",
                            fault.what(), key.path));
        }
    }
}

/// A record of another model's results.
int results_picture_again(Scene scene, const AgainOptions& options, const WorkOptions& work,
                          const PictureOrigin& origin) {
    StatusLine status(work.verbosity);
    RecordedResults results = recorded_results(origin.results, options.picture);
    const LookSettings& look = scene.view.look;
    const bool by_field =
        look.colour_by == Colouring::field || look.colour_by == Colouring::field_change;
    if (std::vector<std::string>& asked = results.query.scalars;
        by_field && std::ranges::count(asked, look.field) == 0)
        asked.push_back(look.field);
    if (options.from.size() > 1)
        throw InputError(fmt::format(
            "{}: --from is given {} times, but a picture shows one run; several files of it are a "
            "pattern of names ('elev_*.asc')",
            options.picture, options.from.size()));
    const std::string from = options.from.empty() ? "" : options.from.front();
    const StoredBeds beds = results_again(
        results, {options.picture, "picture", from, work.threads, options.trust, {}}, status);
    const SharedSnapshot snapshot = beds.snapshot(bed_of_step(beds, origin.step));
    check_limits(scene, static_cast<std::int64_t>(snapshot->bed.size()), 0);
    InitialBed initial;
    initial.bed = beds.first().bed;
    initial.nodata = beds.first().nodata;
    initial.scale = beds.first().scale;
    initial.inputs = {beds.inputs().front()};
    scene.bed.file = initial.inputs.front().path;
    PreparedScene ready = prepare_scene(std::move(scene), std::move(initial));
    check_shown(ready.scene, beds.first());
    std::vector<InputFile>& read = ready.initial.inputs;
    read.insert(read.end(), beds.inputs().begin() + 1, beds.inputs().end());
    const bool is_same =
        std::ranges::equal(read, origin.inputs, {}, &InputFile::hash, &InputFile::hash);
    if (is_same) read = origin.inputs;  // as they were named then
    const fs::path output = output_of(options, origin.ending);
    check_still(ready.scene, *snapshot, output.string());
    std::vector<fs::path> inputs = beds.files();
    for (const fs::path& file : scene_files(ready.scene)) inputs.push_back(file);
    claim_output(options, output, inputs);
    Progress progress(work.verbosity, static_cast<std::int64_t>(snapshot->bed.size()));
    const std::vector<MeasuredRows> rows = beds.measurements(plotted_columns(ready.scene));
    const std::size_t record = bed_of_step(beds, origin.step);
    const Sha256 before = file_hash(options.picture);
    const DrawnStill still =
        draw_still({ready.scene, read, rows[record], is_same ? origin.results : results_text(beds)},
                   beds.first(), *snapshot, output.string(), work, progress);
    compare_stills(output.string(), still, before, options, origin, progress);
    return 0;
}

void refuse_from(const AgainOptions& options) {
    if (options.from.empty()) return;
    throw InputError(fmt::format(
        "{}: --from belongs to pictures and films of other models' results, and this is none",
        options.picture));
}

int perform(const AgainOptions& options) {
    const InterruptGuard guard;
    if (const FigureMetadata texts = figure_texts(options.picture); is_figure(texts)) {
        refuse_from(options);
        return figure_again(options, read_figure_origin(texts, options.picture));
    }
    if (is_made_film(options.picture))
        return make_film_again({options.picture, options.output, options.force, options.trust,
                                options.from, options.work});
    const PictureOrigin origin = read_origin(options.picture);
    if (origin.results.empty() || origin.is_movie) refuse_from(options);
    if (!options.output.empty())
        check_ending(options.output, origin.is_movie ? "a movie" : "a picture",
                     origin.is_movie ? std::span<const std::string_view>(movie_ending)
                                     : std::span<const std::string_view>(picture_endings));
    WorkOptions work = options.work;
    work.pinned = work.pinned || (origin.environment && origin.environment->pinned);
    prepare_drawing(work);
    Scene scene = parse_scene({origin.scene, options.picture, "", options.trust,
                               hashes_of(origin.inputs), origin.version, true},
                              read_settings(options.work.settings));
    check_limits(scene, 1, origin.step);
    find_listed(scene, origin, options.picture);
    if (!origin.results.empty()) {
        if (scene.set_on_command_line("bed.file"))
            throw InputError(fmt::format(
                "{}bed.file: {} shows another model's results; --from FILE takes another file of "
                "them",
                scene.at("bed.file"), options.picture));
        return results_picture_again(std::move(scene), options, work, origin);
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
