#include "film/film_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "film/film_texts.h"
#include "film/frame_sequence.h"
#include "film/make_film.h"
#include "film/timeline.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "picture/movie_format.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// What a film is made for.
struct Purpose {
    std::string_view name;
    std::string_view format;
    std::string_view size;  ///< empty: the film's own
    double rate;            ///< 0: the film's own
    std::int64_t most_bytes;
    std::int64_t quality;  ///< 0: the film's own
};

constexpr std::int64_t bytes_per_megabyte = 1'000'000;
constexpr std::array<Purpose, 4> purposes{
    {{"talk", "h264", "", 0.0, 0, 0},
     {"social", "h264", "vertical", 0.0, 0, 0},
     {"readme", "webp", "360p", 15.0, 3 * bytes_per_megabyte, 28},
     {"gif", "gif", "small", 12.5, 8 * bytes_per_megabyte, 0}}};

bool is_picture(std::string_view format) {
    return format == "sheet" || format == "poster" || format == "sequence";
}

void set_size(Film& film, std::string_view size) {
    film.settings.size = std::string(size);
    film.settings.width = 0;
    film.settings.height = 0;
}

FilmOutput output_for(const Film& film, const fs::path& base, const std::string& name) {
    FilmOutput output{base, film, 0};
    std::string format = name;
    if (const Purpose* purpose = find_named(purposes, name)) {
        format = purpose->format;
        if (!purpose->size.empty()) set_size(output.film, purpose->size);
        if (purpose->rate > 0.0) output.film.settings.rate = purpose->rate;
        if (purpose->quality > 0) output.film.settings.quality = purpose->quality;
        output.most_bytes = purpose->most_bytes;
    } else if (name == "sequence" || (!is_picture(name) && find_movie_format(name) == nullptr)) {
        std::vector<std::string> known{"sheet", "poster"};
        for (const Purpose& one : purposes) known.emplace_back(one.name);
        for (const MovieFormat& one : movie_formats()) known.emplace_back(one.name);
        throw InputError(
            fmt::format("--formats: unknown format \"{}\"; {}", name, suggestion(name, known)));
    }
    output.film.settings.format = format;
    output.file += fmt::format("-{}{}", name, ending_of(format));
    return output;
}

fs::path without_ending(fs::path file) {
    return file.replace_extension();
}

/// The format of a file by its ending, the film's own where that has it too.
std::string format_of(const Film& film, const fs::path& file) {
    const std::string ending = small_ending(file);
    const std::string& own = film.settings.format;
    if ((ending == ".png" || holds_light(file)) && is_frame_sequence(file)) return "sequence";
    if (holds_light(file)) {
        throw InputError(fmt::format("{}: OpenEXR holds one frame a file; name it {}",
                                     file.string(), without_ending(file).string() + "_%05d.exr"));
    }
    if (ending == ending_of(own)) return own;
    if (ending == ".png") return "poster";
    std::string endings = ".png, _%05d.png or _%05d.exr or / for one picture a frame";
    for (const MovieFormat& format : movie_formats()) {
        if (ending == format.ending) return std::string(format.name);
        if (endings.find(format.ending) == std::string::npos)
            endings += ", " + std::string(format.ending);
    }
    throw InputError(
        fmt::format("{}: the name of a film must end in one of {}", file.string(), endings));
}

/// Makes the folder of a sequence, which may be new.
void make_folder_of(const fs::path& file) {
    std::error_code fault;
    const fs::path folder = resolved_link(file).parent_path();
    if (folder.empty() || fs::exists(folder, fault)) return;
    fs::create_directories(folder, fault);
    if (fault) throw Error(fmt::format("cannot write {}: {}", folder.string(), fault.message()));
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
    return is_own_sidecar(sidecar_of(film)) || is_made_by_fumon(film);
}

/// Captions say nothing of who wrote them: they belong to the film beside them.
bool are_own_captions(fs::path captions) {
    return std::ranges::any_of(movie_formats(), [&](const MovieFormat& format) {
        const fs::path film = captions.replace_extension(format.ending);
        std::error_code fault;
        return fs::exists(film, fault) && is_own(film);
    });
}

}  // namespace

namespace {

/// Whether a movie's file ends so.
bool is_movie_ending(const std::string& ending) {
    return std::ranges::any_of(movie_formats(),
                               [&](const MovieFormat& format) { return format.ending == ending; });
}

/// Throws InputError for a name of one picture a frame where movies are asked for.
void refuse_sequence(const fs::path& file, std::string_view option) {
    if (!is_frame_sequence(file)) return;
    throw InputError(fmt::format("{}: {} makes movies; name a file without the frame's number",
                                 file.string(), option));
}

}  // namespace

std::string_view ending_of(const std::string& format) {
    if (is_picture(format)) return ".png";
    return find_movie_format(format)->ending;
}

std::string output_names() {
    std::string names;
    for (const Purpose& purpose : purposes) names += std::string(purpose.name) + ", ";
    return names + "sheet, poster, " + movie_format_names();
}

std::vector<FilmOutput> film_outputs(const Film& film, const fs::path& file,
                                     const std::vector<std::string>& formats,
                                     std::int64_t most_bytes) {
    std::vector<FilmOutput> outputs;
    if (formats.empty()) {
        outputs.push_back({sequence_name(file), film, most_bytes});
        outputs.back().film.settings.format = format_of(film, outputs.back().file);
        return outputs;
    }
    refuse_sequence(file, "--formats");
    for (const std::string& name : formats) {
        outputs.push_back(output_for(film, without_ending(file), name));
        if (most_bytes > 0) outputs.back().most_bytes = most_bytes;
    }
    return outputs;
}

FilmOutput draft_output(const Film& film, const fs::path& file) {
    refuse_sequence(file, "--draft");
    const std::string ending = small_ending(file);
    if (!ending.empty() && !is_movie_ending(ending)) {
        throw InputError(fmt::format("{}: --draft makes an MP4 and a sheet of pictures; name it {}",
                                     file.string(), without_ending(file).string() + ".mp4"));
    }
    constexpr std::int64_t part_of_side = 4;
    constexpr double part_of_frames = 10.0;
    Film draft = film;
    const FilmSize size = film_size(film);
    draft.settings.width = std::max(smallest_film_side, size.width / part_of_side);
    draft.settings.height = std::max(smallest_film_side, size.height / part_of_side);
    draft.settings.supersampling = 1;
    draft.settings.rate = std::max(1.0, film.settings.rate / part_of_frames);
    draft.settings.format = "h264";
    draft.settings.draft = true;
    draft.settings.frames_for_one = film.settings.rate / draft.settings.rate;
    fs::path base = without_ending(file);
    base += "-draft";
    FilmOutput output{base, draft, 0};
    output.file += ".mp4";
    output.sheet = base += ".png";
    return output;
}

void claim_film(OutputClaims& claims, const FilmOutput& output) {
    const std::string& format = output.film.settings.format;
    if (format == "sequence") {
        make_folder_of(output.file);
        const std::int64_t frames = Timeline(output.film).frames();
        for (std::int64_t frame = 0; frame < frames; ++frame) {
            const fs::path file = sequence_file(output.file, frame);
            claims.writes(file, is_own(file));
        }
        return;
    }
    claims.writes(output.file, is_own(output.file));
    if (!output.sheet.empty()) claims.writes(output.sheet, is_own(output.sheet));
    if (is_picture(format)) return;
    if (!output.film.captions.empty()) {
        const fs::path captions = captions_of(output.file);
        claims.writes(captions, are_own_captions(captions));
    }
    if (small_ending(output.file) != ".mp4")
        claims.writes(sidecar_of(output.file), is_own_sidecar(sidecar_of(output.file)));
}

}  // namespace fumon
