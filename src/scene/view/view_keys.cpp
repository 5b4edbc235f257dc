#include "scene/view/view_keys.h"

#include "base/limits.h"

namespace fumon {

namespace {

void list_person_keys(PersonSettings& person, const std::string& path, KeyTable& table) {
    table.real_list(path + ".at", person.at, 0, 2,
                    {.unit = "m",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = "east and north of the bed's south-western corner"});
    table.word_or_real(
        path + ".facing", person.facing,
        {{"auto", "south for the first person, others each within 120 degrees of that"}},
        {.unit = "degrees",
         .range = {-360, 360},
         .help = "direction in which the person looks, clockwise from north",
         .earlier = {"0.3.0", "180.0"}});
}

void list_track_keys(TrackSettings& track, const std::string& path, KeyTable& table) {
    table.choice(path + ".kind", track.kind,
                 {{TrackKind::foot, "foot", "footprints of a walker, a step of 0.75 m apart"}},
                 {.help = "kind of track"});
    table.real_list(path + ".along", track.along, 0, 2000,
                    {.unit = "m",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = "points of the track's line: east and north of the bed's "
                             "south-western corner, in turn"});
    table.integer(path + ".seed", track.seed,
                  {.range = {0, 1e9}, .help = "seed of small differences between prints"});
}

void list_streamer_keys(StreamerSettings& streamers, KeyTable& table) {
    table.real("streamers.strength", streamers.strength,
               {.range = {0, 1},
                .help = "of sand blown over brinks and in wisps over stoss sides (scenic, "
                        "perspective): how dense it is where the model's wind drives as much as "
                        "over level sand; 0: none"});
    table.word_or_real("streamers.length", streamers.length,
                       {{"auto", "twice as far as the bed's dunes are high"}},
                       {.unit = "m or sites",
                        .range = {0, 1e6, true},
                        .help = "how far plumes reach downwind of a brink"});
    table.real(
        "streamers.travel", streamers.travel,
        {.unit = "m or sites",
         .range = {0, 1e6},
         .help = "distance that blown sand moves downwind in each step, in films in each frame"});
}

void list_image_keys(ImageSettings& image, KeyTable& table) {
    table.integer("image.width", image.width,
                  {.unit = "pixels",
                   .range = {smallest_picture_side, largest_picture_side},
                   .help = "width"});
    table.integer("image.height", image.height,
                  {.unit = "pixels",
                   .range = {smallest_picture_side, largest_picture_side},
                   .help = "height"});
    table.integer("image.supersampling", image.supersampling,
                  {.range = {1, 4}, .help = "1, 2 or 4 samples along each side of a pixel"});
    table.real("image.dots_per_inch", image.dots_per_inch,
               {.range = {1, 10000}, .help = "physical size, written into the picture"});
    table.boolean("image.deep_colour", image.deep_colour,
                  {.help = "PNG of 16 bits a channel, of 3-D views"});
    table.integer(
        "image.quality", image.quality,
        {.range = {1, 100},
         .help =
             "quality of JPEG and WebP pictures: a higher one loses less and makes larger files"});
    table.boolean("image.lossless", image.lossless, {.help = "WebP pictures without any loss"});
    table.text("image.language", image.language,
               {.help = "of the words and units that fumon writes over pictures: en, or a table of "
                        "assets/words (ja)"});
    table.text_list("image.words", image.words,
                    {.help = "words in the place of those: files of such a form that end in .toml, "
                             "or entries, \"words: wind = 風\", \"units: yr = 年\", \"names: "
                             "dune height = 砂丘の高さ\""});
}

}  // namespace

void list_view_keys(View& view, KeyTable& table) {
    table.role(KeyRole::look);
    list_camera_keys(view.camera, table);
    list_sun_keys(view.sun, table);
    list_air_keys(view.air, table);
    list_streamer_keys(view.streamers, table);
    list_look_keys(view.look, table);
    list_image_keys(view.image, table);
    table.tables(
        "person", view.persons,
        "a person who stands on the bed as a scale, the first of 1.75 m (scenic, perspective)",
        list_person_keys);
    table.tables("track", view.tracks, "prints in the sand along a line (scenic, perspective)",
                 list_track_keys);
    list_layers(view.layers, table);
}

}  // namespace fumon
