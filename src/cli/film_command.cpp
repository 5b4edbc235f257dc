#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/data_files.h"
#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "film/film_read.h"
#include "film/make_film.h"
#include "film/stored_beds.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "picture/movie_format.h"
#include "run/drawing.h"
#include "run/terminal/interrupt.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct FilmOptions {
    std::string run;     ///< the folder of a finished run
    std::string film;    ///< a film file (TOML)
    std::string output;  ///< empty: by the film's name, here
    std::vector<std::string> formats;
    std::string most_bytes;
    bool draft = false;
    bool force = false;
    WorkOptions work;
};

void declare(CLI::App& command, FilmOptions& options) {
    command.add_option("RUN", options.run, "the folder of a finished run that stored beds")
        ->required();
    command
        .add_option(
            "FILM", options.film,
            "a film file (TOML), the name of one that fumon ships, or an MP4 or PNG of a film")
        ->required();
    command
        .add_option("-o,--output", options.output,
                    "the file; its ending says the format (default: FILM.mp4 here)")
        ->type_name("FILE");
    auto* formats = command
                        .add_option("--formats", options.formats,
                                    "several files, NAME-talk.mp4 …: " + output_names())
                        ->type_name("NAME,…")
                        ->delimiter(',');
    command
        .add_option("--max-size", options.most_bytes,
                    "of each file, such as 8MB; pictures become coarser, then smaller, to fit")
        ->type_name("SIZE");
    command
        .add_flag("--draft", options.draft,
                  "a quarter of each side and a tenth of the frames, and a contact sheet")
        ->excludes(formats);
    add_force(command, options.force);
    add_settings(command, options.work.settings,
                 "override a film key: --set film.size=vertical (repeatable)");
    add_thread_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon film out/run barchans -o film.mp4", "a film that fumon ships, of a run of yours"},
         {"fumon film out/run film.toml --draft", "small and quick"},
         {"fumon film out/run film.toml --formats talk,gif --max-size 8MB", "several files"}},
        "Nothing is simulated: the run stores beds when its scene says output.fields_every=N.\n"
        "`fumon describe film` lists the keys of a film.");
}

/// A film file, or one of scenes/films.
fs::path film_argument(const std::string& film) {
    std::error_code fault;
    if (fs::exists(film, fault) || fs::path(film).has_parent_path()) return film;
    const std::string name = fs::path(film).has_extension() ? film : film + ".toml";
    if (const auto shipped = find_data_file("scenes/films/" + name)) return *shipped;
    return film;
}

/// Whether the sidecar of a file says that fumon made both.
bool is_own_sidecar(const fs::path& sidecar) {
    std::error_code fault;
    if (!fs::is_regular_file(sidecar, fault)) return false;
    try {
        const auto json = parse_json(read_input_file(sidecar));
        return json.value("Software", std::string()).starts_with("fumon ");
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

bool is_own(const fs::path& film) {
    return is_own_sidecar(sidecar_of(film)) || says_that_fumon_made_it(film);
}

/// Captions say nothing of who wrote them: they belong to the film beside them.
bool are_own_captions(fs::path captions) {
    return std::ranges::any_of(movie_formats(), [&](const MovieFormat& format) {
        const fs::path film = captions.replace_extension(format.ending);
        std::error_code fault;
        return fs::exists(film, fault) && is_own(film);
    });
}

void claim(OutputClaims& claims, const FilmOutput& output) {
    const std::string& format = output.film.settings.format;
    const bool movie = format != "sheet" && format != "poster";
    claims.writes(output.file, is_own(output.file));
    if (!movie) return;
    if (!output.film.captions.empty()) {
        const fs::path captions = captions_of(output.file);
        claims.writes(captions, are_own_captions(captions));
    }
    if (small_ending(output.file) != ".mp4")
        claims.writes(sidecar_of(output.file), is_own_sidecar(sidecar_of(output.file)));
}

int perform(const FilmOptions& options) {
    const InterruptGuard guard;
    const fs::path file = film_argument(options.film);
    const FilmText text = film_text(file);
    const Film film = parse_film(text.text, file.string(), options.work.settings);
    const bool again = small_ending(file) != ".toml";
    const fs::path usual =
        file.stem().string() + (again ? "-again" : "") + ending_of(film.settings.format);
    const fs::path named = options.output.empty() ? usual : fs::path(options.output);
    const std::vector<FilmOutput> outputs =
        options.draft
            ? draft_outputs(film, named)
            : film_outputs(film, named, options.formats,
                           options.most_bytes.empty() ? 0 : bytes_of_size(options.most_bytes));
    prepare_drawing(options.work);
    const StoredBeds beds(options.run, options.work.threads);
    OutputClaims claims(options.force);
    claims.reads(file);
    claims.reads(beds.files());
    for (const FilmOutput& output : outputs) claim(claims, output);
    StatusLine status(options.work.verbosity);
    for (const FilmOutput& output : outputs) {
        const MadeFilm made = make_film(output, beds, text.remake, options.work, status);
        if (made.signal != 0) return exit_status_of_signal(made.signal);
        const FilmSize size = film_size(output.film);
        const bool padded = made.width > size.width || made.height > size.height;
        status.note(fmt::format(
            "{}: {} frames of {} x {} pixels{}, {:.4g} s, {} bytes", output.file.string(),
            with_commas(made.frames), made.width, made.height,
            padded ? fmt::format(" (padded from {} x {}: its format needs even sides)", size.width,
                                 size.height)
                   : "",
            made.seconds, with_commas(static_cast<std::int64_t>(fs::file_size(output.file)))));
    }
    return 0;
}

}  // namespace

Command film_command() {
    return make_command<FilmOptions>(
        "film", "cut a film from the beds that a run has stored, without simulating", declare,
        perform);
}

}  // namespace fumon
