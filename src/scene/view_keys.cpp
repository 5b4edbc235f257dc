#include "base/limits.h"
#include "keys/keys.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

void list_person_keys(PersonSettings& person, const std::string& path, KeyTable& table) {
    table.real_list(path + ".at", person.at, 0, 2,
                    {.unit = "m",
                     .range = {-largest_place, largest_place},
                     .help = "east and north of the bed's south-western corner"});
    table.real(path + ".facing", person.facing,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "direction in which the person looks, clockwise from north"});
}

void list_track_keys(TrackSettings& track, const std::string& path, KeyTable& table) {
    table.choice(path + ".kind", track.kind,
                 {{TrackKind::foot, "foot", "footprints of a walker, a step of 0.75 m apart"}},
                 {.help = "kind of track"});
    table.real_list(path + ".along", track.along, 0, 2000,
                    {.unit = "m",
                     .range = {-largest_place, largest_place},
                     .help = "points of the track's line: east and north of the bed's "
                             "south-western corner, in turn"});
    table.integer(path + ".seed", track.seed,
                  {.range = {0, 1e9}, .help = "seed of small differences between prints"});
}

void list_lens_keys(CameraSettings& camera, KeyTable& table) {
    table.word_or_real("camera.f_number", camera.f_number, {{"pinhole", "everything is sharp"}},
                       {.range = {0.5, 1e6},
                        .help = "f-number of the lens (focal length over diameter), which gives "
                                "depth of field; for beds in metres and the perspective camera"});
    table.real("camera.aperture", camera.aperture,
               {.unit = "m or sites",
                .range = {0, 1e6},
                .help = "diameter of the lens, instead of camera.f_number; a large one makes land "
                        "look like a model on a table; 0: a pinhole"});
    table.word_or_real(
        "camera.focus", camera.focus,
        {{"auto",
          "through the point that camera.look_at or camera.framing looks at; else through the "
          "ground in the middle of the picture"}},
        {.unit = "m or sites",
         .range = {0, largest_place, true},
         .help = "distance from the lens to the plane of focus, along the camera's axis"});
    table.word_or_real(
        "camera.lens_samples", camera.lens_samples,
        {{"auto", "16 to 128, as the widest blur of the ground needs"}},
        {.range = {4, 256}, .help = "points of the lens that the picture is drawn from"});
}

}  // namespace

void list_view_keys(View& view, KeyTable& table) {
    table.role(KeyRole::look);
    CameraSettings& camera = view.camera;
    table.choice(
        "camera.projection", camera.projection,
        {{Projection::perspective, "perspective", "as the eye sees it"},
         {Projection::orthographic, "orthographic", "oblique, parallel lines stay parallel"},
         {Projection::map, "map", "straight from above, north up"}},
        {.help = "how the block is projected"});
    table.choice("camera.framing", camera.framing,
                 {{Framing::block, "block", "around the whole block, or as camera.at says"},
                  {Framing::overview, "overview", "over the bed, down on its landforms"},
                  {Framing::low, "low", "across the crests, from a little above the highest"},
                  {Framing::along_crest, "along-crest", "along the highest crest, from beside it"},
                  {Framing::slip_face, "slip-face", "from downwind, up at the highest crest"},
                  {Framing::aerial, "aerial", "steeply down, as from an aeroplane"}},
                 {.help = "camera position by name, found from the first bed and its wind; views "
                          "stay 10 degrees off the grid's own directions"});
    table.real("camera.azimuth", camera.azimuth,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "where the camera stands, clockwise from north"});
    table.real("camera.elevation", camera.elevation,
               {.unit = "degrees", .range = {1, 89.9}, .help = "above the horizon"});
    table.word_or_real("camera.distance", camera.distance,
                       {{"fit", "the whole block just fits the picture"}},
                       {.unit = "block lengths",
                        .range = {0.05, 100},
                        .help = "from the block's centre, in units of its longer side"});
    table.real(
        "camera.field_of_view", camera.field_of_view,
        {.unit = "degrees", .range = {2, 120}, .help = "vertical, for the perspective camera"});
    table.word_or_real(
        "camera.focal_length", camera.focal_length, {{"auto", "as camera.field_of_view says"}},
        {.unit = "mm",
         .range = {7, 700},
         .help = "of a lens whose picture is 24 mm high, for the perspective camera"});
    table.real("camera.roll", camera.roll,
               {.unit = "degrees",
                .range = {-180, 180},
                .help = "of the camera to the right, for the perspective camera"});
    table.real(
        "camera.margin", camera.margin,
        {.range = {0, 0.4}, .help = "free border around the fitted block, share of the picture"});
    const char* place =
        "east and north of the bed's south-western corner, and above the bed there: in `fumon "
        "still` that of its step, elsewhere that of the first frame";
    table.real_list(
        "camera.at", camera.at, 0, 3,
        {.unit = "m or sites", .range = {-largest_place, largest_place}, .help = place});
    table.real_list(
        "camera.look_at", camera.look_at, 0, 3,
        {.unit = "m or sites", .range = {-largest_place, largest_place}, .help = place});
    table.real(
        "camera.turn", camera.turn,
        {.unit = "degrees", .range = {-36000, 36000}, .help = "azimuth added evenly over the run"});
    list_lens_keys(camera, table);

    SunSettings& sun = view.sun;
    table.choice("sun.source", sun.source,
                 {{LightSource::sun, "sun", "daylight"},
                  {LightSource::moon, "moon",
                   "a clear night under a full moon at the sun's place: dark, bluish as eyes see "
                   "it, stars"}},
                 {.help = "source of the light"});
    table.real("sun.azimuth", sun.azimuth,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "where the sun stands, clockwise from north"});
    table.real("sun.elevation", sun.elevation,
               {.unit = "degrees", .range = {1, 90}, .help = "above the horizon"});
    table.real_list(
        "sun.place", sun.place, 0, 2,
        {.unit = "degrees",
         .range = {-180, 180},
         .help = "latitude and longitude (north and east positive) that place the sun, with "
                 "sun.time, instead of sun.azimuth and sun.elevation; the bed's y is true north"});
    table.text("sun.time", sun.time,
               {.unit = iso_time,
                .help = "when, with its offset from UTC: \"2026-03-20T06:40+00:00\" or "
                        "\"2026-03-20T06:40Z\"; the run's start where sun.hours pass"});
    table.real(
        "sun.hours", sun.hours,
        {.range = {-8784, 8784},
         .help = "hours that pass during the run, evenly with its steps, so that the sun moves"});
    table.real("sun.diameter", sun.diameter,
               {.unit = "degrees",
                .range = {0.1, 30},
                .help = "apparent size: the width of the shadows' soft edge"});
    table.real("sun.strength", sun.strength,
               {.range = {0, 10}, .help = "factor of direct sunlight; 1 is a clear day"});
    table.real("sun.sky_strength", sun.sky_strength,
               {.range = {0, 10}, .help = "factor of light from the sky; 1 is a clear day"});
    table.real("sun.dust", sun.dust,
               {.range = {0, 100},
                .help = "aerosol of the air, for the sky \"atmosphere\"; 1 is a clear day"});
    table.real("sun.haze", sun.haze,
               {.range = {0, 1},
                .help = "aerial perspective at the far edge of the block",
                .earlier = {"0.3.0", "0.35"}});

    table.choice("air.planet", view.air.planet,
                 {{Planet::earth, "earth", "blue sky"},
                  {Planet::mars, "mars",
                   "thin air full of fine dust: butterscotch sky, blue around a low sun"}},
                 {.help = "planet whose air scatters the light, for look.sky = \"atmosphere\""});
    table.choice(
        "air.aerosol", view.air.aerosol,
        {{Aerosol::automatic, "auto", "desert over endless ground on Earth, else thin"},
         {Aerosol::thin, "thin",
          "almost none in the sky, and haze that dims all colours alike, as before version 0.3"},
         {Aerosol::desert, "desert",
          "a clear day in a desert: hides far dunes and whitens the sky above them"}},
        {.help = "aerosol in the lowest air", .earlier = {"0.3.0", "\"thin\""}});
    table.choice(
        "air.clouds", view.air.clouds,
        {{Clouds::none, "none", "a clear sky, or the even cover of look.sky = \"overcast\""},
         {Clouds::cumulus, "cumulus", "of fair weather: flat bases, heads like cauliflowers"},
         {Clouds::cirrus, "cirrus", "high ice, drawn out into threads"}},
        {.help = "kind of clouds, for look.sky = \"atmosphere\" in scenic views"});
    table.real("air.cloud_cover", view.air.cloud_cover,
               {.range = {0, 1}, .help = "approximate share of the ground under clouds"});
    table.integer("air.cloud_seed", view.air.cloud_seed,
                  {.range = {0, 1e9}, .help = "seed of the clouds' places"});
    table.word_or_real("air.cloud_height", view.air.cloud_height,
                       {{"auto", "1800 of cumulus, 8500 of cirrus"}},
                       {.unit = "m",
                        .range = {300, 15000},
                        .help = "height of the clouds' base above the ground"});
    table.real("air.cloud_wind", view.air.cloud_wind,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "direction from which the wind at the clouds' height blows, clockwise from "
                        "north; cirrus stretches along it"});
    table.real(
        "air.cloud_drift", view.air.cloud_drift,
        {.unit = "km",
         .range = {-1e4, 1e4},
         .help =
             "distance that clouds drift with that wind during the run, evenly with its steps"});
    table.word_or_real(
        "air.visibility", view.air.visibility,
        {{"auto",
          "over endless ground 30 km on a clear day in a desert, less with sun.dust over 1 (in "
          "thin "
          "air 40 km, and no more than 80 km over sun.dust); where the bed ends in a plain, eight "
          "times its longer side if that is more; around a block on a table as sun.haze says"}},
        {.unit = "km",
         .range = {1e-4, 1e5},
         .help = "distance at which dark objects near the ground vanish in haze (Koschmieder "
                 "1924); without metres the bed's longer side counts as 1 km"});

    StreamerSettings& streamers = view.streamers;
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

    LookSettings& look = view.look;
    table.text(
        "look.preset", look.preset,
        {.help = "a look for all keys of light, sky and colour that the scene leaves out: NAME "
                 "of assets/looks/NAME.toml (golden-hour, noon, overcast, paper, …); empty in "
                 "resolved scenes, which say them all"});
    table.choice(
        "look.mode", look.mode,
        {{ViewMode::scenic, "scenic", "sunlight, sky and haze"},
         {ViewMode::figure, "figure", "white ground, no haze, colours true to the colour bar"}},
        {.help = "purpose of the picture"});
    table.choice(
        "look.colour_by", look.colour_by,
        {{Colouring::natural, "natural", "natural colours of the ground"},
         {Colouring::height, "height", "bed height"},
         {Colouring::slope, "slope", "steepness in degrees"},
         {Colouring::change, "change", "height minus that of the first frame"},
         {Colouring::water_depth, "water-depth", "depth of the water in m; dry cells stay sand"},
         {Colouring::speed, "speed", "of the water, m/s"},
         {Colouring::froude, "froude", "Froude number of the water, speed over sqrt(g depth)"},
         {Colouring::drainage, "drainage",
          "decimal logarithm of the area that drains through a cell, m2"}},
        {.help = "quantity shown by the colours"});
    table.text("look.palette", look.palette,
               {.help = "sand, grey, hypsometric, viridis, cividis, magma, inferno, plasma, "
                        "batlow, lapaz, oslo, vik (for "
                        "change), or any NAME of assets/palettes/NAME.txt"});
    table.boolean("look.palette_reversed", look.palette_reversed,
                  {.help = "reverses the palette: with grey, dark is deep"});
    table.word_or_real("look.low", look.low, {{"auto", "see look.range"}},
                       {.range = {-largest_colour_value, largest_colour_value},
                        .help = "value at the palette's start, in the unit of colour_by"});
    table.word_or_real("look.high", look.high, {{"auto", "see look.range"}},
                       {.range = {-largest_colour_value, largest_colour_value},
                        .help = "value at the palette's end"});
    table.choice(
        "look.range", look.range,
        {{ColourSpan::run, "run",
          "for all frames: films, and frames that `fumon render` draws, take all that they show; a "
          "run that draws while it computes takes its first frame whose values differ, and a "
          "colour bar has a triangle at an end beyond which a frame's values lie; a still takes "
          "its own"},
         {ColourSpan::frame, "frame", "each frame its own, as its colour bar says"}},
        {.help = "frames whose values set look.low and look.high where those are \"auto\"",
         .earlier = {"0.3.0", "\"frame\""}});
    table.word_or_real("look.exaggeration", look.exaggeration,
                       {{"auto",
                         "a round number that shows the relief and keeps 99 % of real terrain "
                         "below 45°; 1 without metres"},
                        {"relief", "a round number that shows the relief; 1 without metres"}},
                       {.range = {0, 1e4, true},
                        .help = "vertical exaggeration",
                        .earlier = {"0.2.0", "\"relief\""}});
    table.choice(
        "look.ground", look.ground,
        {{Ground::automatic, "auto",
          "endless in perspective for a whole periodic bed without water, as the sand models "
          "have; else table"},
         {Ground::table, "table", "the bed is a block on a pale table"},
         {Ground::endless, "endless",
          "the ground goes on to the horizon, with wind ripples below the grid: a periodic bed "
          "repeats, and where a bed ends it runs out into a plain with relief of its own kind"}},
        {.help = "what lies around the bed", .earlier = {"0.2.0", "\"table\""}});
    table.choice("look.far_copies", look.far_copies,
                 {{FarGround::varied, "varied",
                   "each wider or narrower than the bed, shifted, and lower; beyond 0.7 of the "
                   "bed's sides around what the first picture looks at"},
                  {FarGround::alike, "alike", "the bed as it is, again and again"}},
                 {.help = "repetitions of a periodic bed far from the camera, on endless ground",
                  .earlier = {"0.3.0", "\"alike\""}});
    table.choice("look.background", look.background,
                 {{Background::surroundings, "surroundings", "table, sky or the figure's paper"},
                  {Background::transparent, "transparent",
                   "nothing: the block alone, in a PNG with alpha; movies without alpha stand on "
                   "white"}},
                 {.help = "what stands behind the block"});
    table.choice(
        "look.sky", look.sky,
        {{SkyModel::automatic, "auto", "atmosphere"},
         {SkyModel::automatic_0_2, "auto-0.2",
          "what auto was in version 0.2: atmosphere over endless ground, by night and on Mars, "
          "else two-colours"},
         {SkyModel::two_colours, "two-colours", "from the horizon's colour to the zenith's"},
         {SkyModel::atmosphere, "atmosphere",
          "sunlight scattered by air, aerosol and ozone (Hillaire 2020)"},
         {SkyModel::overcast, "overcast",
          "an even cover of clouds, next to no sun (the CIE's overcast sky)"}},
        {.help = "how sky, haze and the light from the sky are made in scenic views",
         .earlier = {"0.3.0", "\"auto-0.2\""}});
    table.choice(
        "look.tone", look.tone,
        {{Tone::automatic, "auto",
          "agx-punchy over endless ground and, with 0.35 stops more light, under the sky "
          "\"atmosphere\", else filmic"},
         {Tone::automatic_0_2, "auto-0.2",
          "what auto was in version 0.2: agx-punchy over endless ground, else filmic"},
         {Tone::filmic, "filmic", "a curve fitted to the ACES rendering (Narkowicz 2015)"},
         {Tone::agx, "agx", "bright colours turn pale, as on film (AgX, Sobotka)"},
         {Tone::agx_punchy, "agx-punchy", "the same with more contrast and colour"},
         {Tone::neutral, "neutral", "colours stay as they are up to bright ones (Khronos)"}},
        {.help = "from light to display values, in scenic views",
         .earlier = {"0.3.0", "\"auto-0.2\""}});
    table.real(
        "look.exposure", look.exposure,
        {.unit = "stops", .range = {-10, 10}, .help = "stops of brightness: each doubles it"});
    table.word_or_real(
        "look.contrast", look.contrast,
        {{"auto",
          "over endless ground 1.35, up to 1.8 with half a stop less light under a low sun, "
          "but not of red sand; else 1"}},
        {.range = {0.2, 4},
         .help = "contrast of light before the tone curve: a power around middle grey"});
    table.boolean("look.block_sides", look.block_sides,
                  {.help = "draw the cut sides of the block"});
    table.choice("look.sides", look.sides,
                 {{BlockSides::soil, "soil",
                   "as a spade cuts it: damp sand under a dry skin, earth with stones"},
                  {BlockSides::layers, "layers", "sets of cross-beds, as in a dune's trench"}},
                 {.help = "what the block's sides show in a scenic view",
                  .earlier = {"0.2.0", "\"layers\""}});
    table.choice("look.sand", look.sand,
                 {{SandKind::quartz, "quartz", "golden, as most dunes are"},
                  {SandKind::iron_red, "iron-red", "coated with iron oxide: Namib, Simpson Desert"},
                  {SandKind::gypsum, "gypsum", "white: White Sands"},
                  {SandKind::carbonate, "carbonate", "pale cream, of shells and corals"},
                  {SandKind::basalt, "basalt", "black: Iceland, Hawaii"},
                  {SandKind::martian, "mars", "basalt with a veil of red dust"}},
                 {.help = "colour of sand that is coloured \"natural\""});
    table.real("look.grain", look.grain, {.range = {0, 1}, .help = "visible grain of the sand"});
    table.real("look.ripples", look.ripples,
               {.range = {0, 1},
                .help = "steepness of the wind ripples, too fine for the grid, on endless ground"});
    table.real(
        "look.plants", look.plants,
        {.range = {0, 1},
         .help = "share of the plants (model dunes) drawn one by one; 0: only tint the ground",
         .earlier = {"0.2.0", "0.0"}});
    table.word_or_real("look.contours", look.contours,
                       {{"none", "no lines"}, {"auto", "a round interval: up to 16 lines"}},
                       {.unit = "m",
                        .range = {0, 1e6, true},
                        .help = "interval of contour lines, every fifth labelled; in model heights "
                                "where there are no metres"});
    table.word_or_real("look.room", look.room,
                       {{"auto", "as far as the model's landforms usually grow"}},
                       {.unit = "model heights",
                        .range = {0, 1e7},
                        .help = "space kept free above the first bed"});
    table.word_or_real("look.footing", look.footing,
                       {{"auto", "5.5 % of the longer side, and below what the bed may sink to"}},
                       {.unit = "model heights",
                        .range = {0, 1e7},
                        .help = "thickness of the block under the first bed's lowest place"});
    table.choice(
        "look.datum", look.datum,
        {{Datum::automatic, "auto", "mean for models with water, else first"},
         {Datum::first, "first", "the first bed's heights: a bed that sinks is seen to sink"},
         {Datum::mean, "mean",
          "each frame's mean height: a bed that sinks as a whole stays framed"}},
        {.help = "reference level for drawn heights"});
    table.choice("look.relief", look.relief,
                 {{FigureRelief::soft, "soft", "gentle shade, shadows, grey layered sides"},
                  {FigureRelief::clear, "clear",
                   "as a block diagram is drawn: deep shade and bright slopes, faint shadows, "
                   "plain light sides with a thin outline"}},
                 {.help = "of a figure's hill shading"});
    table.real("look.shading", look.shading,
               {.range = {0, 1}, .help = "hill shading of a figure; 0: the colours alone"});
    table.boolean("look.water", look.water,
                  {.help = "draw the water over the bed, where the model has some"});
    table.word_or_real(
        "look.water_clarity", look.water_clarity,
        {{"auto", "from the frame's depths: ponds hide their ground, an even film does not"}},
        {.unit = "m", .range = {0, 1e6, true}, .help = "depth at which the bed is half hidden"});
    table.real(
        "look.turbidity", look.turbidity,
        {.range = {0, 1}, .help = "turbidity of the water: 0 clear and blue-green, 1 muddy"});
    table.boolean("look.air", look.air,
                  {.help = "draw the air over a profile, where the model has some (scenic)"});
    table.choice("look.mark", look.mark,
                 {{Marking::none, "none", "the bed alone"},
                  {Marking::last_avalanche, "last-avalanche",
                   "the cells of the pile's last avalanche in blue: toppled ones dark, others "
                   "lighter"},
                  {Marking::ground, "ground",
                   "plants in their green where the dunes have some, and rock without sand"}},
                 {.help = "cells that are marked"});
    table.integer("look.profile_start", look.profile_start,
                  {.unit = "sites",
                   .range = {0, largest_grid_side},
                   .help = "first site of a profile (grid.ny = 1) that is drawn, as a strip"});
    table.integer(
        "look.profile_sites", look.profile_sites,
        {.unit = "sites",
         .range = {0, 8192},
         .help = "number of sites of a profile that are drawn; 0: 900, or all of a shorter one"});

    ImageSettings& image = view.image;
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
    table.tables("person", view.persons,
                 "a person of 1.75 m who stands on the bed as a scale (scenic, perspective)",
                 list_person_keys);
    table.tables("track", view.tracks, "prints in the sand along a line (scenic, perspective)",
                 list_track_keys);
}

}  // namespace fumon
