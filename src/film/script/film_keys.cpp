#include "film/script/film_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/limits.h"
#include "film/script/film_sizes.h"
#include "film/script/moment.h"
#include "keys/describe_key.h"
#include "picture/movie_format.h"
#include "scene/figure/figure_keys.h"

namespace fumon {

namespace {

constexpr double longest_shot_seconds = 3600.0;  // seconds

void list_film(FilmSettings& film, KeyTable& table) {
    table.text("film.title", film.title,
               {.help = "what cards and captions call {title}; empty: the scene's title"});
    table.text("film.size", film.size, {.help = "by name, or as 1920x1080: " + film_size_names()});
    table.integer("film.width", film.width,
                  {.unit = "pixels",
                   .range = {0, largest_film_side},
                   .help = "with film.height instead of a name; 0: by name"});
    table.integer("film.height", film.height,
                  {.unit = "pixels",
                   .range = {0, largest_film_side},
                   .help = "with film.width instead of a name; 0: by name"});
    table.real("film.rate", film.rate,
               {.unit = "frames/s", .range = {1, 120}, .help = "frames a second"});
    table.text("film.format", film.format,
               {.help = "of the file, unless the name after -o says it: " + movie_format_names()});
    table.integer("film.quality", film.quality,
                  {.range = {0, 51}, .help = "rate factor: 18 looks lossless, 28 is small"});
    table.integer(
        "film.supersampling", film.supersampling,
        {.range = {0, 4}, .help = "1, 2 or 4 samples along each side of a pixel; 0: the scene's"});
    table.real("film.cap_height", film.cap_height,
               {.unit = "pixels",
                .range = {10, 200},
                .help = "of a caption's capital letters where the picture's shorter side has 1080 "
                        "pixels; other sizes follow"});
    table.choice(
        "film.plates", film.plates,
        {{Plates::translucent, "translucent", "dark letters on a pale plate (overlay.opacity)"},
         {Plates::none, "none",
          "pale letters with a soft shadow, without a plate; plots and colour bars keep theirs"}},
        {.help = "what overlays stand on"});
    table.choice(
        "film.background", film.background,
        {{FilmBackground::scene, "scene", "as the run's look.background says"},
         {FilmBackground::transparent, "transparent",
          "nothing: the block alone, with alpha where the format has it, elsewhere on white"}},
        {.help = "what stands behind the bed; alpha have poster, sheet, " +
                 transparent_format_names()});
    table.choice("film.between", film.between,
                 {{RecordsBetween::held, "held", "the nearest one, as it was stored"},
                  {RecordsBetween::blend, "blend",
                   "heights, water and colours that change evenly from one to the next, which no "
                   "model computed; the time plate says so"}},
                 {.help = "what is drawn at a time between two stored beds"});
    table.real("film.poster_second", film.poster_second,
               {.unit = "s",
                .range = {-1, 86400},
                .help = "the picture of a poster; below 0: the film's middle"});
    table.boolean("film.draft", film.draft,
                  {.help = "quicker and coarser, as --draft asks for besides a smaller size: "
                           "hardly any ground finer than the run's cells, a larger file"});
}

void list_panes(PaneSettings& panes, KeyTable& table) {
    table.choice(
        "panes.show", panes.show,
        {{PanesShow::grid, "grid", "beside and below each other, up to 3 x 3"},
         {PanesShow::wipe, "wipe",
          "two in one picture, on both sides of a line that wanders across it"},
         {PanesShow::difference, "difference",
          "the first of two, coloured by its height, depth of water or field minus the second's"}},
        {.help = "how several runs stand in one picture, in step"});
    table.integer("panes.columns", panes.columns,
                  {.range = {0, 3}, .help = "of the grid; 0: by the picture's shape"});
    table.text("panes.label", panes.label,
               {.help = "above each run; {title}, {seed}, {key} are filled in; empty: what differs "
                        "between the runs"});
    table.boolean("panes.scale", panes.scale,
                  {.help = "beside the labels, where one number differs between the runs: all its "
                           "values on a line, with the run's own"});
    table.real_list("panes.wipe_places", panes.wipe_places, 2, 2,
                    {.unit = "picture widths",
                     .range = {0, 1},
                     .help = "from where to where the line of a wipe wanders in each shot"});
}

void list_light(const std::string& path, WordOrReal& focal_length, WordOrReal& sun_azimuth,
                WordOrReal& sun_elevation, WordOrReal& exposure, const char* word,
                const char* meaning, KeyTable& table) {
    table.word_or_real(path + ".focal_length", focal_length, {{word, meaning}},
                       {.unit = "mm",
                        .range = {7, 700},
                        .help = "of a lens before 36 x 24 mm, whose 24 mm lie along the picture's "
                                "shorter side"});
    table.word_or_real(path + ".sun_azimuth", sun_azimuth, {{word, meaning}},
                       {.unit = "degrees",
                        .range = {-720, 720},
                        .help = "where the sun stands, clockwise from north"});
    table.word_or_real(
        path + ".sun_elevation", sun_elevation, {{word, meaning}},
        {.unit = "degrees", .range = {1, 90}, .help = "of the sun above the horizon"});
    table.word_or_real(path + ".exposure", exposure, {{word, meaning}},
                       {.unit = "stops", .range = {-10, 10}, .help = "brighter or darker"});
}

/// Distances that what is looked at decides.
std::vector<KeyWord> distance_words() {
    return {{"fit", "the whole bed just fits the picture, whatever its shape"},
            {"fill", "the bed fills two thirds of the picture; no farther than it fits"},
            {"near", "what the camera looks at, by a word, fills about half of the picture"}};
}

/// What a camera may look at by its name, found in the shot's last bed.
std::vector<KeyWord> place_words() {
    return {{"middle", "the bed's middle"},
            {"highest", "the highest landform, half way up"},
            {"lowest", "the lowest cell"},
            {"deepest channel", "the cell that lies deepest below the ground around it"},
            {"flood front", "where the depth of water changes most at once: a front or a bore"},
            {"largest dune", "the isolated dune with most sand; where none is, the highest"},
            {"outlet", "where the stream that drains most leaves the bed"}};
}

void list_key(ShotKey& key, const std::string& path, KeyTable& table) {
    const char* place = "east and north of the bed's south-western corner, and above the bed there";
    table.real_list(path + ".at", key.at, 0, 3,
                    {.unit = "m or sites",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = std::string("where the camera stands: ") + place +
                             "; empty: as .azimuth, .elevation and .distance say"});
    table.word_or_list(
        path + ".look_at", key.look_at.word, key.look_at.at, 0, 3, place_words(),
        {.unit = "m or sites",
         .range = {-largest_coordinate, largest_coordinate},
         .help = "what it looks at, likewise, or what is there; empty: the shot's subject"});
    const KeyWord as_shot{"shot", "as the shot says"};
    table.word_or_real(path + ".azimuth", key.azimuth, {as_shot},
                       {.unit = "degrees",
                        .range = {-720, 720},
                        .help = "without .at: where it stands from what it looks at"});
    table.word_or_real(path + ".elevation", key.elevation, {as_shot},
                       {.unit = "degrees",
                        .range = {1, 89.5},
                        .help = "without .at: above the horizon of what it looks at"});
    std::vector<KeyWord> distances = distance_words();
    distances.insert(distances.begin(), as_shot);
    table.word_or_real(path + ".distance", key.distance, std::move(distances),
                       {.unit = "block lengths",
                        .range = {0.01, 100},
                        .help = "without .at: from what it looks at"});
    list_light(path, key.focal_length, key.sun_azimuth, key.sun_elevation, key.exposure, "shot",
               "as the shot says", table);
}

void list_shot(Shot& shot, const std::string& path, KeyTable& table) {
    table.real(path + ".seconds", shot.seconds,
               {.unit = "s", .range = {0, longest_shot_seconds, true}, .help = "its length"});
    table.real(path + ".hold", shot.hold,
               {.unit = "s",
                .range = {0, longest_shot_seconds},
                .help = "of its seconds the last ones, in which all stands still"});
    const std::vector<KeyWord> ends{{"start", "the first stored bed"},
                                    {"end", "the last stored bed"}};
    const std::vector<WordForm> moments{
        {"40 %", "of the way from the first stored bed to the last", is_written_share},
        {"3 yr", "the model's time, in a unit of UDUNITS", is_written_time}};
    table.word_or_real(path + ".from", shot.from, ends,
                       {.unit = "steps or time",
                        .range = {0, largest_time},
                        .help = "where in the run it begins; the same as .to: a freeze"},
                       moments);
    table.word_or_real(path + ".to", shot.to, ends,
                       {.unit = "steps or time",
                        .range = {0, largest_time},
                        .help = "and where it ends, maybe before"},
                       moments);
    table.choice(path + ".clock", shot.clock,
                 {{FilmClock::step, "step", "steps"},
                  {FilmClock::time, "time", "the model's time, in its unit"}},
                 {.help = "what .from and .to count"});
    table.choice(
        path + ".pace", shot.pace,
        {{Pace::linear, "linear", "evenly"},
         {Pace::logarithmic, "logarithmic", "each second by the same factor"},
         {Pace::eased, "eased", "slowly at both ends"},
         {Pace::change, "change", "the same visible change in every frame"}},
        {.help = "how the run's time passes; film.between says what lies between stored beds"});
    table.choice(
        path + ".move", shot.move,
        {{Move::still, "still", "the camera stands"},
         {Move::keys, "keys", "through the places of [[shot.key]]"},
         {Move::orbit, "orbit", "around the subject by .turn degrees"},
         {Move::push_in, "push-in", "towards the subject, to a third of the distance"},
         {Move::crane, "crane", "up from low over the ground, looking at the subject"},
         {Move::fly_over, "fly-over", "low across the bed, looking ahead"},
         {Move::along_crest, "along-crest", "along the highest crest, from beside it"},
         {Move::map_to_perspective, "map-to-perspective",
          "from above, north up, to where .azimuth "
          "and .elevation say"},
         {Move::morning_to_evening, "morning-to-evening",
          "the camera stands, the sun goes from "
          "east over south to west"},
         {Move::follow_dune, "follow-dune", "beside dune number .dune, whatever way it wanders"},
         {Move::follow_stream, "follow-stream", "down the stream that drains most, low over it"}},
        {.help = "of the camera"});
    table.choice(path + ".speed", shot.speed,
                 {{CameraSpeed::constant, "constant", "the same all along"},
                  {CameraSpeed::eased, "eased", "it starts and stops gently"}},
                 {.help = "of the camera along its path"});
    table.word_or_real(path + ".azimuth", shot.azimuth, {{"scene", "camera.azimuth"}},
                       {.unit = "degrees",
                        .range = {-720, 720},
                        .help = "where the camera stands at first, clockwise from north"});
    table.word_or_real(path + ".elevation", shot.elevation, {{"scene", "camera.elevation"}},
                       {.unit = "degrees", .range = {1, 89.5}, .help = "above the horizon"});
    table.word_or_real(path + ".distance", shot.distance, distance_words(),
                       {.unit = "block lengths",
                        .range = {0.01, 100},
                        .help = "from the subject, in units of the bed's longer side"});
    list_light(path, shot.focal_length, shot.sun_azimuth, shot.sun_elevation, shot.exposure,
               "scene", "as the scene says", table);
    table.word_or_list(
        path + ".subject", shot.subject.word, shot.subject.at, 0, 3, place_words(),
        {.unit = "m or sites",
         .range = {-largest_coordinate, largest_coordinate},
         .help = "what the camera looks at, as camera.look_at, or what is there; empty: the "
                 "bed's middle"});
    table.boolean(path + ".follow", shot.follow,
                  {.help = "of a still, orbit or push-in: whether the camera goes with what "
                           ".subject names, bed by bed"});
    table.real(path + ".turn", shot.turn,
               {.unit = "degrees", .range = {-3600, 3600}, .help = "of an orbit, clockwise"});
    table.integer(path + ".dune", shot.dune,
                  {.range = {1, 1000},
                   .help = "which dune is followed: 1 is the largest of the shot's first bed, 2 "
                           "the next, by volume"});
    table.word_or_real(
        path + ".clearance", shot.clearance,
        {{"auto", "a hundredth of the bed's longer side, or the lowest of the shot's keys"}},
        {.unit = "m or sites",
         .range = {0, 1e9},
         .help = "the camera's least height over all beds that the shot shows"});
    table.choice(path + ".transition", shot.transition,
                 {{Transition::cut, "cut", "at once"},
                  {Transition::cross_fade, "cross-fade", "while the one before it still goes on"}},
                 {.help = "how it follows what is before it"});
    table.real(path + ".transition_seconds", shot.transition_seconds,
               {.unit = "s", .range = {0, 60}, .help = "of a cross-fade; both go on during it"});
    table.tables(path + ".key", shot.keys, "a place of the camera on its way", list_key);
}

void list_excerpt(Excerpt& excerpt, const std::string& path, KeyTable& table) {
    table.text(path + ".film", excerpt.film,
               {.help = "what is cut from: a film file (as seen from this one), the name of one "
                        "that fumon ships, or its text; without its cards and captions"});
    table.integer(path + ".run", excerpt.run,
                  {.range = {1, most_joined_runs},
                   .help = "which of the runs on the command line it shows, counted from 1"});
    table.real(path + ".from", excerpt.from,
               {.unit = "s", .range = {0, 86400}, .help = "of that film's shots, its beginning"});
    table.word_or_real(path + ".to", excerpt.to, {{"end", "their end"}},
                       {.unit = "s", .range = {0, 86400}, .help = "and its end"});
    table.choice(path + ".transition", excerpt.transition,
                 {{Transition::cut, "cut", "at once"},
                  {Transition::cross_fade, "cross-fade", "while the one before it still goes on"}},
                 {.help = "how it follows what comes before"});
    table.real(path + ".transition_seconds", excerpt.transition_seconds,
               {.unit = "s", .range = {0, 60}, .help = "length of a cross-fade"});
}

void list_card(Card& card, const std::string& path, KeyTable& table) {
    table.choice(
        path + ".place", card.place,
        {{CardPosition::start, "start", "of the film"}, {CardPosition::end, "end", "of it"}},
        {.help = "where it stands"});
    table.choice(
        path + ".ground", card.ground,
        {{CardBackground::picture, "picture", "over the first or last seconds of the shots"},
         {CardBackground::dark, "dark", "before or after the shots, on a dark ground"},
         {CardBackground::blurred, "blurred",
          "before or after them, on their first or last picture out of focus"}},
        {.help = "what it stands on"});
    table.real(path + ".seconds", card.seconds,
               {.unit = "s", .range = {0, 600, true}, .help = "its length"});
    table.text(path + ".title", card.title,
               {.help = "in large letters; {title}, {version}, {seed}, {key} are filled in; empty "
                        "at the start: {title}"});
    table.text_list(path + ".lines", card.lines,
                    {.help = "below it, filled in likewise, also {remake}: how the film is made "
                             "again; empty at the end: credits and how to make it again"});
    table.real(path + ".fade", card.fade,
               {.unit = "s", .range = {0, 60}, .help = "in which it comes, and goes"});
}

void list_caption(Caption& caption, const std::string& path, KeyTable& table) {
    table.real(path + ".from", caption.from,
               {.unit = "s", .range = {0, 86400}, .help = "of the film, when it comes"});
    table.real(path + ".to", caption.to,
               {.unit = "s", .range = {0, 86400}, .help = "and when it goes"});
    table.text(path + ".text", caption.text,
               {.help = "its words; {title}, {seed}, {key} are filled in"});
}

}  // namespace

KeyTable film_keys(Film& film) {
    KeyTable table;
    table.role(KeyRole::look);
    list_film(film.settings, table);
    list_panes(film.panes, table);
    table.tables("shot", film.shots, "a part of the film, one after the other", list_shot);
    table.tables("excerpt", film.excerpts, "a piece of another film, instead of shots",
                 list_excerpt);
    table.tables("card", film.cards, "large lettering at the film's start or end", list_card);
    table.tables("caption", film.captions, "a line below the picture for a while", list_caption);
    list_overlay_keys(film.overlays, table);
    return table;
}

namespace {

/// A film with one item in each of its lists.
Film film_of_all_keys() {
    Film film;
    film.shots.resize(1);
    film.shots.front().keys.resize(1);
    film.excerpts.resize(1);
    film.cards.resize(1);
    film.captions.resize(1);
    return film;
}

bool is_part(const Key& key, const std::string& part) {
    const std::string path = without_numbers(key.path);
    return part.empty() || path == part || path.starts_with(part + ".");
}

}  // namespace

std::string describe_film(const std::string& part) {
    Film film = film_of_all_keys();
    const KeyTable table = film_keys(film);
    std::string keys;
    for (const Key& key : table.keys()) {
        if (is_part(key, part)) keys += describe_key(key);
    }
    if (keys.empty()) return {};
    if (!part.empty()) return fmt::format("Keys of a film, {}\n\n{}", part, keys);
    return "Keys of a film, for `fumon film`. N counts its [[shot]], [[shot.key]], [[excerpt]],\n"
           "[[card]] and [[caption]] sections from 0; [[overlay]] takes the keys of `fumon "
           "describe "
           "overlay`.\nThe film, and each shot, may also have a scene's sections [camera] (its "
           "lens), [look], [sun],\n[air], [streamers], [[person]], [[track]] and [[layer]] "
           "([shot.look] for a shot): the keys that\ndiffer from the run's own\n\n" +
           keys;
}

std::string describe_film_json(const std::string& part) {
    Film film = film_of_all_keys();
    const KeyTable table = film_keys(film);
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Key& key : table.keys()) {
        if (is_part(key, part)) all.push_back(key_json(key));
    }
    return all.dump(2) + "\n";
}

namespace {

/// The items of a list with commas, without what stands in brackets behind them.
std::vector<std::string> items_of(const std::string& list) {
    std::vector<std::string> items;
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(", ", begin), list.size());
        const std::string item = list.substr(begin, end - begin);
        items.push_back(item.substr(0, item.find(" (")));
        begin = end + 2;
    }
    return items;
}

}  // namespace

std::vector<KeyWords> film_key_words() {
    Film film = film_of_all_keys();
    const KeyTable table = film_keys(film);
    std::vector<KeyWords> all;
    for (const Key& key : table.keys()) {
        all.push_back(key_words(key));
        if (key.path == "film.format") all.back().words = items_of(movie_format_names());
        if (key.path == "film.size") all.back().words = items_of(film_size_names());
    }
    return all;
}

}  // namespace fumon
