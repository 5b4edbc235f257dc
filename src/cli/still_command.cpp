#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/error.h"
#include "base/limits.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/terrain/terrain_format.h"
#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "film/beds/stored_still.h"
#include "foreign/file_numbers.h"
#include "foreign/open_run.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "run/drawing.h"
#include "run/inputs/scene_argument.h"
#include "run/inputs/standard_input.h"
#include "run/output_files.h"
#include "run/prepared_run.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/overlay_keys.h"
#include "scene/read.h"
#include "scene/scene_files.h"
#include "scene/scene_keys.h"
#include "scene/terrain_scene.h"

namespace fumon {

namespace {

struct StillOptions {
    std::string input;   ///< a scene (.toml) or a terrain file
    std::string output;  ///< a PNG, JPEG, WebP or OpenEXR file
    std::optional<int> quality;
    bool lossless = false;
    std::optional<std::int64_t> step;
    std::optional<double> time;
    std::string colour;
    std::string heights;  ///< "low:high", metres of black and white of a PNG terrain
    bool force = false;
    ForeignQuery foreign;
    WorkOptions work;
};

void declare(CLI::App& command, StillOptions& options) {
    command
        .add_option("INPUT", options.input,
                    "a scene (.toml), the folder of a run that stored beds, or terrain: " +
                        terrain_titles() +
                        "; a scene or terrain on standard input is -; with --step or --time the "
                        "results of another model (NetCDF, or 'PATTERN*' of files)")
        ->required();
    command
        .add_option("-o,--output", options.output,
                    "the picture: .png, .jpg, .webp or .tif, or linear light and layers as OpenEXR "
                    "(.exr); - is "
                    "standard output (PNG)")
        ->type_name("FILE")
        ->required();
    auto* quality = add_number(command, "--quality", options.quality, 1, 100,
                               "of JPEG and WebP (default: image.quality of the scene, 92)")
                        ->type_name("N");
    command.add_flag("--lossless", options.lossless, "WebP without any loss")->excludes(quality);
    auto* step = add_number(command, "--step", options.step, 0, largest_step,
                            "of which step (default: the run's last)")
                     ->type_name("N");
    add_number(command, "--time", options.time, 0, largest_step,
               "of which time, in the model's unit")
        ->type_name("T")
        ->excludes(step);
    add_heights(command, options.heights);
    add_force(command, options.force);
    add_colour(command, options.colour);
    add_foreign_options(command, options.foreign);
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon still terada-barchans --step 500 -o dunes.png", "a step of a scene"},
         {"fumon still out/run --step 500 -o dunes.png", "of a run that stored it, at once"},
         {"fumon still flood.nc --step 12 -o flood.png", "of another model's results"},
         {"fumon still flood.nc --step 12 --colour tau -o tau.png", "coloured by its shear stress"},
         {"fumon still terrain.asc -o terrain.png", "a terrain file of your own"},
         {"fumon still terada-barchans -o dunes.webp --quality 80", "a small file"},
         {"fumon still terada-barchans -o dunes.exr", "its light, depth and fields"},
         {"fumon still dunes-barchans --step 0 -o - --set camera.projection=map | feh -",
          "to a program"},
         {"fumon still terada-ripples -o low.png --set camera.azimuth=160 --set sun.elevation=15",
          ""}},
        "`fumon describe camera` and the like list what a look is made of.");
}

namespace fs = std::filesystem;

constexpr const char* heights_of_scene =
    "--heights belongs to a PNG terrain; in a scene write bed.heights = [low, high]";

Scene scene_of(const StillOptions& options, const StandardInput* given) {
    if (given != nullptr && given->is_scene()) {
        if (!options.heights.empty()) throw InputError(heights_of_scene);
        return parse_scene(given->scene(), read_settings(options.work.settings));
    }
    if (given != nullptr)
        return terrain_scene(given->terrain().string(), options.heights, options.work.settings);
    if (!is_scene_argument(options.input))
        return terrain_scene(terrain_argument(options.input), options.heights,
                             options.work.settings);
    if (!options.heights.empty()) {
        throw InputError(heights_of_scene);
    }
    return read_scene(scene_argument(options.input), options.work.settings);
}

std::int64_t step_of(const StillOptions& options, const Scene& scene) {
    if (!options.step) return scene.run.steps;
    if (*options.step > scene.run.steps) {
        throw InputError(fmt::format(
            "--step {} is after the run's end; {} runs {} steps (lengthen it with --set "
            "run.steps={})",
            *options.step, options.input, scene.run.steps, *options.step));
    }
    return *options.step;
}

/// Puts the options of a format where the scene's other settings are. Throws InputError where the
/// picture is of another format.
StillOptions with_coding(StillOptions options) {
    if (!options.quality && !options.lossless) return options;
    const PictureFormat format = picture_format(options.output);
    const bool fits =
        format == PictureFormat::webp || (!options.lossless && format == PictureFormat::jpeg);
    if (!fits) {
        throw InputError(options.lossless
                             ? "--lossless belongs to WebP; name the picture FILE.webp"
                             : "--quality belongs to JPEG and WebP; name the picture FILE.jpg or "
                               "FILE.webp");
    }
    options.work.settings.push_back(options.lossless
                                        ? std::string("image.lossless=true")
                                        : fmt::format("image.quality={}", *options.quality));
    return options;
}

PreparedRun prepare(const StillOptions& options, const StandardInput* given) {
    const ExitOnSignal nothing_is_written;
    return prepare_run(scene_of(options, given), options.work.threads);
}

void claim_outputs(OutputClaims& claims, const Scene& scene, const std::string& picture) {
    const bool was_own = is_made_by_fumon(picture);
    claims.writes(picture);
    if (small_ending(picture) == exr_ending.front()) return;
    for (const fs::path& file : map_file_names(scene, picture)) claims.writes(file, was_own);
}

/// A picture of a bed that a run has stored; nothing is computed.
void draw_stored(const StillOptions& options, const std::string& run) {
    if (!options.heights.empty()) throw InputError(heights_of_scene);
    const StoredBeds beds =
        StoredBeds::of_argument(run, options.work.threads, options.work.settings, options.foreign);
    std::size_t number = beds.beds().size() - 1;
    if (options.step) number = bed_of_step(beds, *options.step);
    if (options.time) number = bed_of_time(beds, *options.time);
    const SharedSnapshot snapshot = beds.snapshot(number);
    Scene scene = beds.scene();
    check_still(scene, *snapshot, options.output);
    OutputClaims claims(options.force);
    claims.reads(beds.files());
    if (options.output != standard_output) claim_outputs(claims, scene, options.output);
    Progress progress(options.work.verbosity, static_cast<std::int64_t>(snapshot->bed.size()));
    if (options.time)
        progress.note(fmt::format("step {}, at {:g}, is the nearest to --time {:g} that was stored",
                                  snapshot->step, beds.beds()[number].time, *options.time));
    const std::vector<MeasuredRows> rows = beds.measurements(plotted_columns(scene));
    stand_on_drawn_ground(scene.view, beds.first(), *snapshot);
    draw_still({scene, beds.inputs(), rows[number], results_text(beds)}, beds.first(), *snapshot,
               options.output, options.work, progress);
}

int perform(const StillOptions& asked) {
    const InterruptGuard guard;
    StillOptions options = with_coding(asked);
    const std::vector<std::string> colours = colour_settings(options.colour);
    options.work.settings.insert(options.work.settings.begin(), colours.begin(), colours.end());
    const bool to_standard_output = options.output == standard_output;
    if (to_standard_output) {
        refuse_terminal("the picture is a PNG file", "dunes.png");
    } else {
        check_ending(options.output, "a picture", picture_endings);
    }
    prepare_drawing(options.work);
    const bool asks_step = options.step || options.time;
    const std::optional<fs::path> run = run_folder_of(options.input);
    if (run && (asks_step || fs::is_directory(options.input))) {
        draw_stored(options, run->string());
        return 0;
    }
    const bool is_run = asks_step || !options.colour.empty() || !options.foreign.fields.empty() ||
                        is_pattern(options.input);
    if (is_run && is_foreign_run(options.input)) {
        draw_stored(options, options.input);
        return 0;
    }
    std::optional<StandardInput> given;
    if (is_standard_input(options.input)) given.emplace();
    PreparedRun prepared = prepare(options, given ? &*given : nullptr);
    OutputClaims claims(options.force);
    if (!given) claims.reads(options.input);
    claims.reads(scene_files(prepared.scene));
    check_still(prepared.scene, prepared.model->snapshot(), options.output);
    if (!to_standard_output) claim_outputs(claims, prepared.scene, options.output);
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()));
    prepared.initial.bed = Grid();  // the model has its own, and a large one fills the memory
    if (!prepared.initial.note.empty()) progress.note(prepared.initial.note);
    const bool moves =
        options.time || step_of(options, prepared.scene) > prepared.model->steps_done();
    std::optional<Snapshot> first;
    if (moves) first = prepared.model->snapshot();
    const int signal = options.time
                           ? advance_to_time(prepared, *options.time,
                                             fmt::format("--time {}", *options.time), progress)
                           : advance_to(prepared, step_of(options, prepared.scene), progress);
    if (signal != 0) return exit_status_of_signal(signal);
    const Snapshot present = prepared.model->snapshot();
    if (first) stand_on_drawn_ground(prepared.scene.view, *first, present);
    prepared.model.reset();  // a large bed is then in memory once
    draw_still(still_subject(prepared), first ? *first : present, present, options.output,
               options.work, progress);
    return 0;
}

}  // namespace

Command still_command() {
    return make_command<StillOptions>(
        "still", "draw one picture, of a step of a scene or run, or of a terrain file", declare,
        perform);
}

}  // namespace fumon
