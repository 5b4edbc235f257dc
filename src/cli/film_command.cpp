#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "film/beds/film_runs.h"
#include "film/cache/byte_size.h"
#include "film/cache/picture_cache.h"
#include "film/film_read.h"
#include "film/film_texts.h"
#include "film/frame_sequence.h"
#include "film/make_film.h"
#include "film/rule/film_rule.h"
#include "film/script/film_looks.h"
#include "keys/override.h"
#include "outputs/output_claims.h"
#include "run/drawing.h"
#include "run/terminal/interrupt.h"
#include "scene/scene_keys.h"
#include "shards/slurm_script.h"
#include "view/watch/job_server.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct FilmOptions {
    std::vector<std::string> runs;  ///< folders of finished runs and of sweeps
    std::string film;               ///< a film file (TOML)
    std::string output;             ///< empty: by the film's name, here
    std::vector<std::string> formats;
    std::string most_bytes;
    std::string style = "talk";  ///< of a film by rule
    double seconds = 0.0;        ///< likewise; 0: by its style
    std::string colour;
    bool print = false;
    bool draft = false;
    bool resume = false;
    bool no_cache = false;
    bool clear_cache = false;
    bool force = false;
    ForeignQuery foreign;
    WatchOptions watch;
    WorkOptions work;
};

void declare(CLI::App& command, FilmOptions& options) {
    command.add_option(
        "RUN", options.runs,
        "the folder of a finished run that stored beds; or several, or that of a sweep, "
        "side by side; or the results of another model: NetCDF, or 'PATTERN*' of files");
    command.add_option(
        "FILM", options.film,
        "last: a film file (TOML), the name of one that fumon ships, or an MP4 or PNG of a film; "
        "without it the film is made by rule");
    command
        .add_option("-o,--output", options.output,
                    "the file; its ending says the format, and NAME_%05d.png makes one picture of "
                    "each frame (default: FILM.mp4 here)")
        ->type_name("FILE");
    command.add_option("--style", options.style, "of a film by rule: " + film_style_names())
        ->type_name("NAME");
    command
        .add_option("--seconds", options.seconds,
                    "of a film by rule, its length (default: 12 to 18, by its style)")
        ->type_name("S");
    command.add_flag("--print", options.print,
                     "print the film file of a film by rule, as the start of your own, and draw "
                     "nothing");
    auto* formats = command
                        .add_option("--formats", options.formats,
                                    "several files, NAME-talk.mp4 …: " + output_names())
                        ->type_name("NAME,…")
                        ->delimiter(',');
    auto* most_bytes =
        command
            .add_option("--max-size", options.most_bytes,
                        "of each file, such as 8MB; pictures become coarser, then smaller, to fit")
            ->type_name("SIZE");
    command
        .add_flag("--draft", options.draft,
                  "a quarter of each side and a tenth of the frames, and a contact sheet")
        ->excludes(formats)
        ->excludes(most_bytes);
    command.add_flag("--resume", options.resume,
                     "keep the frames in FILE.frames until the film is whole; given again, an "
                     "interrupted film goes on where it stopped");
    command.add_flag("--no-cache", options.no_cache,
                     "draw every picture, and keep none for the next film");
    command.add_flag("--clear-cache", options.clear_cache,
                     "alone: delete the pictures that are kept for the next film");
    add_force(command, options.force);
    add_colour(command, options.colour);
    add_foreign_options(command, options.foreign);
    add_settings(command, options.work.settings,
                 "override a film key: --set film.size=vertical (repeatable)");
    add_watch_options(command, options.watch);
    add_thread_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon film out/run -o film.mp4", "a film by rule, of any run"},
         {"fumon film out/run --print > mine.toml", "its film file, to change"},
         {"fumon film out/run barchans -o film.mp4", "a film that fumon ships, of a run of yours"},
         {"fumon film out/run film.toml --draft", "small and quick"},
         {"fumon film out/wet out/dry film.toml", "two runs side by side, in step"},
         {"fumon film out/one out/two trailer.toml",
          "pieces of several films, one after the other"},
         {"fumon film flood.nc film.toml", "the results of another model"},
         {"fumon film flood.nc --colour tau -o tau.mp4", "coloured by its shear stress"},
         {"fumon film out/run film.toml --formats talk,gif --max-size 8MB", "several files"}},
        "Nothing is simulated: the run stores beds when its scene says output.fields_every=N.\n"
        "`fumon describe film` lists the keys of a film.");
}

struct Arguments {
    std::vector<std::string> runs;
    std::string film;
};

/// A folder of runs, or results of another model; what else there is may be a film.
bool names_a_run(const std::string& argument) {
    constexpr std::array<std::string_view, 8> of_grids{".nc",  ".nc4", ".cdf",  ".sww",
                                                       ".asc", ".tif", ".tiff", ".txt"};
    return is_run_folder(argument) || argument.find_first_of("*?") != std::string::npos ||
           std::ranges::find(of_grids, small_ending(argument)) != of_grids.end();
}

/// Of a run's folder that is called as a film that fumon ships: whether that film is meant, since
/// the run is named before; else says how to name it.
bool means_the_shipped_film(const std::vector<std::string>& runs) {
    const std::string& last = runs.back();
    if (film_file(last) == fs::path(last)) return false;
    if (std::ranges::find(runs.begin(), runs.end() - 1, last) != runs.end() - 1) return true;
    remark(fmt::format("{}: the run in that folder; {}.toml is the film that fumon ships", last,
                       last));
    return false;
}

/// CLI11 gives all of them to the runs; the last one is the film, unless it is a run itself.
Arguments arguments_of(const FilmOptions& options) {
    Arguments arguments{options.runs, options.film};
    if (!arguments.film.empty() || arguments.runs.size() < 2) return arguments;
    if (names_a_run(arguments.runs.back()) && !means_the_shipped_film(arguments.runs))
        return arguments;
    arguments.film = arguments.runs.back();
    arguments.runs.pop_back();
    return arguments;
}

/// What a film is read from, and its runs.
struct FilmToMake {
    FilmText text;
    Film film;
    fs::path usual;  ///< its file where none is named
    fs::path source{};
    FilmRuns runs;
};

/// What is asked of runs of other models: what --field and the like say, and the maps that colour.
ForeignQuery query_of(const FilmOptions& options, const std::vector<std::string>& fields) {
    ForeignQuery query = options.foreign;
    query.scalars = fields;
    return query;
}

/// What --colour means is said in the picture, unless the film does.
void add_colour_bar(Film& film) {
    if (std::ranges::find(film.overlays, OverlayKind::colour_bar, &OverlaySettings::kind) !=
        film.overlays.end())
        return;
    OverlaySettings bar;
    bar.kind = OverlayKind::colour_bar;
    bar.corner = OverlayCorner::lower_right;
    film.overlays.push_back(bar);
}

FilmToMake film_by_file(const FilmOptions& options, const Arguments& arguments) {
    if (options.print || options.seconds != 0.0 || options.style != "talk") {
        throw InputError(
            fmt::format("{}: --print, --style and --seconds are for a film by rule; leave out FILM",
                        arguments.film));
    }
    const fs::path file = film_file(arguments.film);
    FilmText text = film_text(file);
    const bool again = small_ending(file) != ".toml";
    std::vector<std::string> settings = colour_settings(options.colour);
    settings.insert(settings.end(), options.work.settings.begin(), options.work.settings.end());
    Film film = parse_film(text.text, file.string(), settings, !again);
    if (again) film.found_layers = found_layers(film, filmed_layers(read_film_texts(file)), file);
    if (!options.colour.empty() && options.colour != "natural") add_colour_bar(film);
    const RunArrangement showing = arrangement_of(film);
    fs::path usual = file.stem().string() + (again ? "-again" : "");
    FilmRuns runs(arguments.runs, options.work.threads, showing,
                  query_of(options, coloured_fields(film)));
    return {std::move(text), std::move(film), std::move(usual), file, std::move(runs)};
}

/// What a film by rule is called where no file is named: as its run's folder or file.
std::string name_of_run(const std::string& run) {
    std::error_code fault;
    const fs::path whole = fs::absolute(run, fault).lexically_normal();
    const fs::path last = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    std::string name = fs::is_directory(run, fault) ? last.string() : last.stem().string();
    std::erase_if(name, [](char letter) { return letter == '*' || letter == '?'; });
    while (name.ends_with('_') || name.ends_with('-')) name.pop_back();
    return name.empty() ? "film" : name;
}

/// Of runs without a film: one that is made by rule, as a film file.
FilmToMake film_without_file(const FilmOptions& options, const Arguments& arguments) {
    FilmRule rule{film_style(options.style), options.seconds,
                  read_settings(colour_settings(options.colour))};
    std::vector<std::string> fields;
    for (const auto& settings : {rule.colours, read_settings(options.work.settings)})
        for (const Override& setting : settings)
            if (setting.path == "look.field") fields.push_back(plain_text(setting));
    FilmRuns runs(arguments.runs, options.work.threads, RunArrangement::together,
                  query_of(options, fields));
    FilmText text{film_by_rule(runs, rule, fs::path(arguments.runs.front()).string()),
                  "fumon film RUN"};
    if (options.style != "talk") text.remake += " --style " + options.style;
    if (!options.colour.empty()) text.remake += " --colour " + shell_word(options.colour);
    if (options.seconds != 0.0) text.remake += fmt::format(" --seconds {}", options.seconds);
    Film film = parse_film(text.text, "film by rule", options.work.settings);
    fs::path usual = name_of_run(arguments.runs.front());
    return {std::move(text), std::move(film), std::move(usual), {}, std::move(runs)};
}

/// Where pictures are kept for other films; nothing where none are.
std::unique_ptr<PictureCache> picture_cache(const FilmOptions& options) {
    const std::int64_t most_bytes = picture_cache_bytes();
    const std::optional<fs::path> folder = picture_cache_folder();
    if (options.no_cache || most_bytes == 0 || !folder) return nullptr;
    return std::make_unique<PictureCache>(*folder, most_bytes);
}

void tell_use(PictureCache& cache, StatusLine& status) {
    const CacheUse use = cache.finish();
    if (use.found > 0) {
        status.note(
            fmt::format("{} of {} pictures were drawn before and kept; --no-cache draws them all",
                        with_commas(use.found), with_commas(use.found + use.drawn)));
    }
}

/// Says what becomes of a film that was stopped.
void tell_stop(const FilmOutput& output, const MadeFilm& made, bool keeps, StatusLine& status) {
    const char* rest = made.goes_on ? "the same command goes on there"
                       : keeps      ? "the same command takes over the pictures that were drawn"
                                    : "with --resume the same command would go on there";
    status.note(fmt::format("{}: stopped at frame {} and not written; {}", output.file.string(),
                            with_commas(made.begun_frame + 1), rest));
}

int clear_cache(const FilmOptions& options) {
    if (!options.runs.empty()) throw InputError("--clear-cache stands alone, without RUN and FILM");
    const std::optional<fs::path> folder = picture_cache_folder();
    const std::int64_t bytes = folder ? clear_picture_cache(*folder) : 0;
    StatusLine status(options.work.verbosity);
    status.note(bytes > 0 ? fmt::format("{}: {} bytes of pictures deleted", folder->string(),
                                        with_commas(bytes))
                          : "no pictures are kept");
    return 0;
}

int perform(const FilmOptions& options) {
    if (options.clear_cache) return clear_cache(options);
    if (options.runs.empty())
        throw InputError("fumon film: RUN is missing; try `fumon film --help`");
    const InterruptGuard guard;
    const Arguments arguments = arguments_of(options);
    const FilmToMake made_of = arguments.film.empty() ? film_without_file(options, arguments)
                                                      : film_by_file(options, arguments);
    if (options.print) {
        fmt::print("{}", made_of.text.text);
        return 0;
    }
    const Film& film = made_of.film;
    const FilmRuns& runs = made_of.runs;
    const fs::path usual =
        fmt::format("{}{}", made_of.usual.string(), ending_of(film.settings.format));
    const fs::path named = options.output.empty() ? usual : fs::path(options.output);
    std::vector<FilmOutput> outputs =
        options.draft
            ? std::vector{draft_output(film, named)}
            : film_outputs(film, named, options.formats,
                           options.most_bytes.empty() ? 0 : bytes_of_size(options.most_bytes));
    for (FilmOutput& output : outputs) output.goes_on = options.resume;
    prepare_drawing(options.work);
    OutputClaims claims(options.force);
    if (!made_of.source.empty()) claims.reads(made_of.source);
    claims.reads(runs.files());
    for (const FilmOutput& output : outputs) claim_film(claims, output);
    JobWatch watch;
    StatusLine status(options.work.verbosity, options.watch.on ? &watch : nullptr);
    const std::unique_ptr<PictureCache> cache = picture_cache(options);
    std::optional<JobServer> window;
    if (options.watch.on) {
        window.emplace(
            watch,
            [name = outputs.front().file.string()] { return std::make_unique<WatchPages>(name); },
            options.watch.port);
        std::fputs(window->address_lines().c_str(), stdout);
        std::fflush(stdout);
    }
    for (const FilmOutput& output : outputs) {
        const MadeFilm made =
            make_film(output, runs, made_of.text.remake, options.work, status, cache.get());
        if (made.signal != 0) {
            tell_stop(output, made, cache != nullptr, status);
            if (window) window->end(made.goes_on ? "stopped; the same command goes on" : "stopped");
            return exit_status_of_signal(made.signal);
        }
        const FilmSize size = film_size(output.film);
        const auto say = [&](const fs::path& written, std::int64_t frames, std::int64_t width,
                             std::int64_t height) {
            const bool padded = width > size.width || height > size.height;
            status.note(fmt::format(
                "{}: {} frames of {} x {} pixels{}, {:.4g} s, {} bytes", written.string(),
                with_commas(frames), width, height,
                padded ? fmt::format(" (padded from {} x {}: its format needs even sides)",
                                     size.width, size.height)
                       : "",
                made.seconds, with_commas(static_cast<std::int64_t>(fs::file_size(written)))));
        };
        if (output.film.settings.format == "sequence") {
            status.note(fmt::format("{} to {}: {} pictures of {} x {} pixels, {:.4g} s",
                                    sequence_file(output.file, 0).string(),
                                    sequence_file(output.file, made.frames - 1).string(),
                                    with_commas(made.frames), made.width, made.height,
                                    made.seconds));
            continue;
        }
        say(output.file, made.frames, made.width, made.height);
        if (!output.sheet.empty()) say(output.sheet, made.sheet_frames, size.width, size.height);
    }
    if (cache) tell_use(*cache, status);
    if (window) window->end("complete: " + outputs.back().file.string());
    return 0;
}

}  // namespace

Command film_command() {
    return make_command<FilmOptions>(
        "film", "cut a film from the beds that a run has stored, without simulating", declare,
        perform);
}

}  // namespace fumon
