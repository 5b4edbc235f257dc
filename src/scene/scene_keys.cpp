#include "scene/scene_keys.h"

#include "base/limits.h"
#include "files/terrain/terrain_format.h"
#include "keys/keys.h"
#include "models/registry.h"
#include "scene/figure_keys.h"

namespace fumon {

namespace {

void list_run_keys(Scene& scene, KeyTable& table) {
    table.role(KeyRole::label);
    table.text("title", scene.title,
               {.help = "what the run shows; goes into the manifest and the pictures"});
    table.role(KeyRole::run);
    table.integer("seed", scene.seed,
                  {.range = {0, 9223372036854775807.0},
                   .help = "of every random number; same seed, same bytes"});
    table.integer("run.steps", scene.run.steps,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "length of the run (required, except for static)",
                   .required = true});
    table.role(KeyRole::sampling);
    table.integer("frames.every", scene.frames.every,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "a frame at 0, n, 2n, …; 0: a hundredth of the run when no other frames "
                           "key is given"});
    table.integer_list(
        "frames.at", scene.frames.at,
        {.unit = "steps", .range = {0, largest_step}, .help = "frames at these steps"});
    table.integer("frames.logarithmic", scene.frames.logarithmic,
                  {.unit = "frames",
                   .range = {0, 1e6},
                   .help = "a frame at 0 and this many at steps evenly spaced in their logarithm"});
}

void list_bed_keys(Scene& scene, KeyTable& table) {
    table.role(KeyRole::parameter);
    table.integer("grid.nx", scene.grid.nx,
                  {.unit = "cells",
                   .range = {1, largest_grid_side},
                   .help = "cells eastward, along the wind; a terrain file brings its own"});
    table.integer("grid.ny", scene.grid.ny,
                  {.unit = "cells",
                   .range = {1, largest_grid_side},
                   .help = "cells northward, across the wind; a terrain file brings its own"});
    table.real_list("grid.cell_size", scene.grid.cell_size, 0, 2,
                    {.unit = "m",
                     .range = {0, 1e7, true},
                     .help = "one number or [dx, dy]; without it lengths are in sites"});
    table.word_or_real("grid.height_unit", scene.grid.height_unit,
                       {{"auto",
                         "1 m for models in metres (static, gully, airflow), else the cell size dx "
                         "(1 site without one)"}},
                       {.unit = "m", .range = {0, 1e7, true}, .help = "metres per model height"});
    table.choice("bed.kind", scene.bed.kind,
                 {{BedKind::automatic, "auto",
                   "the terrain file if bed.file names one, else flat for the sandpile and noise "
                   "for others"},
                  {BedKind::flat, "flat", "one height everywhere"},
                  {BedKind::noise, "noise", "uniform random heights in [low, high)"},
                  {BedKind::heap, "heap", "a round heap in the middle of bare ground at height 0"},
                  {BedKind::file, "file", "a terrain file"}},
                 {.help = "the initial bed"});
    table.real("bed.height", scene.bed.height,
               {.unit = "model heights", .help = "height of a flat bed, or of a heap's top"});
    table.real("bed.heap_radius", scene.bed.heap_radius,
               {.unit = "m, or sites",
                .range = {0, 1e9},
                .help = "of a heap's foot, in metres where cells have a size; its height falls as "
                        "the squared cosine"});
    table.real("bed.low", scene.bed.low,
               {.unit = "model heights", .help = "lower end of the noise"});
    table.real("bed.high", scene.bed.high,
               {.unit = "model heights", .help = "upper end of the noise; 0.01 for a gully"});
    table.role(KeyRole::run);
    table.text("bed.file", scene.bed.file,
               {.help = terrain_titles() +
                        ", heights in metres; relative to the scene file, or with --set to the "
                        "working folder"});
    table.role(KeyRole::parameter);
    table.real_list("bed.heights", scene.bed.heights, 0, 2,
                    {.unit = "m", .help = "[low, high]: heights of black and white in a PNG bed"});
    table.text("bed.variable", scene.bed.variable,
               {.help = "variable of a NetCDF bed, of which the last record is taken; needed where "
                        "the file has several and no bed_height"});
    table.integer("bed.band", scene.bed.band,
                  {.range = {0, 65535}, .help = "band of a GeoTIFF bed; 0: its only or first one"});
    table.real_list("bed.window", scene.bed.window, 0, 4,
                    {.help = "[west, south, east, north]: the part of a terrain file to read, in "
                             "the file's coordinates, or in cells from its south-west corner where "
                             "it has none; empty: all"});
    table.word_or_real(
        "bed.nodata", scene.bed.nodata,
        {{"mask", "cells without data lie outside the domain"},
         {"fill", "filled smoothly from their rim"}},
        {.unit = "m", .help = "cells without data: masked, filled, or set to a height"});
    table.word_or_real(
        "bed.nodata_value", scene.bed.nodata_value, {{"auto", "what the file itself says"}},
        {.unit = "m", .help = "the height that stands for no data in a terrain file"});
    table.text(
        "bed.crs", scene.bed.crs,
        {.help = "\"utm\", or a reference system in metres as \"EPSG:32613\", onto whose even "
                 "cells a terrain file is brought (with GDAL); empty: its own"});
    table.real("bed.resample", scene.bed.resample,
               {.unit = "m",
                .range = {0, 1e7},
                .help = "size of the cells onto which a terrain file's heights are brought; 0: as "
                        "they are; grid.cell_size is that of the file's own cells"});
    table.choice(
        "bed.resample_method", scene.bed.resample_method,
        {{Resampling::average, "average", "mean over the new cell: for larger cells"},
         {Resampling::bilinear, "bilinear",
          "linear between the four nearest cells: for smaller ones"},
         {Resampling::nearest, "nearest", "of the cell in which the new one's centre lies"}},
        {.help = "how bed.resample finds heights"});
    table.integer("bed.refine", scene.bed.refine,
                  {.range = {1, 64},
                   .help = "splits each cell of a terrain file into n x n, smooth in between "
                           "(bicubic); grid.cell_size is that of the file's own cells"});
}

void list_view_keys(View& view, KeyTable& table) {
    table.role(KeyRole::look);
    CameraSettings& camera = view.camera;
    table.choice(
        "camera.projection", camera.projection,
        {{Projection::perspective, "perspective", "as the eye sees it"},
         {Projection::orthographic, "orthographic", "oblique, parallel lines stay parallel"},
         {Projection::map, "map", "straight from above, north up"}},
        {.help = "how the block is projected"});
    table.choice(
        "camera.framing", camera.framing,
        {{Framing::block, "block", "around the whole block, or as camera.at says"},
         {Framing::overview, "overview", "over the bed, down on its landforms"},
         {Framing::low, "low", "across the crests, from a little above the highest"},
         {Framing::along_crest, "along-crest", "along the highest crest, from beside it"},
         {Framing::slip_face, "slip-face", "from downwind, up at the highest crest"},
         {Framing::aerial, "aerial", "steeply down, as from an aeroplane"}},
        {.help = "by name where the camera stands, from the bed it first sees and its wind; never "
                 "within 10 degrees of the lattice's own directions"});
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
    const char* place = "east and north of the bed's south-western corner, and above the bed there";
    table.real_list("camera.at", camera.at, 0, 3,
                    {.unit = "m or sites", .range = {-1e9, 1e9}, .help = place});
    table.real_list("camera.look_at", camera.look_at, 0, 3,
                    {.unit = "m or sites", .range = {-1e9, 1e9}, .help = place});
    table.real(
        "camera.turn", camera.turn,
        {.unit = "degrees", .range = {-36000, 36000}, .help = "azimuth added evenly over the run"});

    SunSettings& sun = view.sun;
    table.choice("sun.source", sun.source,
                 {{LightSource::sun, "sun", "daylight"},
                  {LightSource::moon, "moon",
                   "a clear night under a full moon at the sun's place: dark, bluish as eyes see "
                   "it, stars"}},
                 {.help = "what the light comes from"});
    table.real("sun.azimuth", sun.azimuth,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "where the sun stands, clockwise from north"});
    table.real("sun.elevation", sun.elevation,
               {.unit = "degrees", .range = {1, 90}, .help = "above the horizon"});
    table.real("sun.diameter", sun.diameter,
               {.unit = "degrees",
                .range = {0.1, 30},
                .help = "apparent size: the width of the shadows' soft edge"});
    table.real("sun.strength", sun.strength,
               {.range = {0, 10}, .help = "of direct light; 1 is a clear day"});
    table.real("sun.sky_strength", sun.sky_strength,
               {.range = {0, 10}, .help = "of light from the sky; 1 is a clear day"});
    table.real("sun.dust", sun.dust,
               {.range = {0, 100},
                .help = "aerosol of the air, for the sky \"atmosphere\"; 1 is a clear day"});
    table.real("sun.haze", sun.haze,
               {.range = {0, 1}, .help = "aerial perspective at the far edge of the block"});

    table.choice("air.planet", view.air.planet,
                 {{Planet::earth, "earth", "blue sky"},
                  {Planet::mars, "mars",
                   "thin air full of fine dust: butterscotch sky, blue around a low sun"}},
                 {.help = "whose air scatters the light, for the sky \"atmosphere\""});
    table.word_or_real(
        "air.visibility", view.air.visibility,
        {{"auto",
          "40 km over endless ground, 80 km over sun.dust where that is less; around a block on a "
          "table as sun.haze says"}},
        {.unit = "km",
         .range = {1e-4, 1e5},
         .help = "how far dark things are seen: haze by distance (Koschmieder 1924); without "
                 "metres the bed's longer side counts as 1 km"});

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
        {.help = "for the eye or for a paper"});
    table.choice(
        "look.colour_by", look.colour_by,
        {{Colouring::natural, "natural", "as the ground looks"},
         {Colouring::height, "height", "bed height"},
         {Colouring::slope, "slope", "steepness in degrees"},
         {Colouring::change, "change", "height minus that of the first frame"},
         {Colouring::water_depth, "water-depth", "depth of the water in m; dry cells stay sand"},
         {Colouring::speed, "speed", "of the water, m/s"},
         {Colouring::froude, "froude", "Froude number of the water, speed over sqrt(g depth)"}},
        {.help = "what the colours mean"});
    table.text("look.palette", look.palette,
               {.help = "sand, grey, hypsometric, viridis, cividis, magma, inferno, plasma, "
                        "batlow, lapaz, oslo, vik (for "
                        "change), or any NAME of assets/palettes/NAME.txt"});
    table.boolean("look.palette_reversed", look.palette_reversed,
                  {.help = "reversed, such as dark for deep with grey"});
    table.word_or_real("look.low", look.low, {{"auto", "from the frame"}},
                       {.help = "value at the palette's start, in the unit of colour_by"});
    table.word_or_real("look.high", look.high, {{"auto", "from the frame"}},
                       {.help = "value at the palette's end"});
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
          "a periodic bed of sand goes on to the horizon, with wind ripples below its grid"}},
        {.help = "what lies around the bed", .earlier = {"0.2.0", "\"table\""}});
    table.choice(
        "look.sky", look.sky,
        {{SkyModel::automatic, "auto",
          "atmosphere over endless ground, by night and on Mars, else two-colours"},
         {SkyModel::two_colours, "two-colours", "from the horizon's colour to the zenith's"},
         {SkyModel::atmosphere, "atmosphere",
          "sunlight scattered by air, aerosol and ozone (Hillaire 2020)"},
         {SkyModel::overcast, "overcast",
          "an even cover of clouds, next to no sun (the CIE's overcast sky)"}},
        {.help = "how sky, haze and the light from the sky are made"});
    table.choice(
        "look.tone", look.tone,
        {{Tone::automatic, "auto", "agx-punchy over endless ground, else filmic"},
         {Tone::filmic, "filmic", "a curve fitted to the ACES rendering (Narkowicz 2015)"},
         {Tone::agx, "agx", "bright colours turn pale, as on film (AgX, Sobotka)"},
         {Tone::agx_punchy, "agx-punchy", "the same with more contrast and colour"},
         {Tone::neutral, "neutral", "colours stay as they are up to bright ones (Khronos)"}},
        {.help = "from light to display values, in scenic views"});
    table.real("look.exposure", look.exposure,
               {.unit = "stops", .range = {-10, 10}, .help = "brighter by a factor of two each"});
    table.word_or_real(
        "look.contrast", look.contrast, {{"auto", "1.35 over endless ground, else 1"}},
        {.range = {0.2, 4}, .help = "of light before the tone curve: a power around middle grey"});
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
    table.word_or_real("look.room", look.room,
                       {{"auto", "as far as the model's landforms usually grow"}},
                       {.unit = "model heights",
                        .range = {0, 1e7},
                        .help = "space kept free above the first bed"});
    table.choice(
        "look.datum", look.datum,
        {{Datum::automatic, "auto", "mean for models with water, else first"},
         {Datum::first, "first", "the first bed's heights: a bed that sinks is seen to sink"},
         {Datum::mean, "mean",
          "each frame's mean height: a bed that sinks as a whole stays framed"}},
        {.help = "what the drawn heights are counted from"});
    table.real("look.shading", look.shading,
               {.range = {0, 1}, .help = "hill shading of a figure; 0: the colours alone"});
    table.boolean("look.water", look.water,
                  {.help = "draw the water over the bed, where the model has some"});
    table.word_or_real(
        "look.water_clarity", look.water_clarity,
        {{"auto", "from the frame's depths: ponds hide their ground, an even film does not"}},
        {.unit = "m", .range = {0, 1e6, true}, .help = "depth at which the bed is half hidden"});
    table.real("look.turbidity", look.turbidity,
               {.range = {0, 1}, .help = "of the water: 0 clear and blue-green, 1 muddy"});
    table.boolean("look.air", look.air,
                  {.help = "draw the air over a profile, where the model has some (scenic)"});
    table.choice("look.mark", look.mark,
                 {{Marking::none, "none", "the bed alone"},
                  {Marking::last_avalanche, "last-avalanche",
                   "the cells of the pile's last avalanche in blue: toppled ones dark, others "
                   "lighter"},
                  {Marking::ground, "ground",
                   "plants in their green where the dunes have some, and rock without sand"}},
                 {.help = "cells that stand out"});
    table.integer("look.profile_start", look.profile_start,
                  {.unit = "sites",
                   .range = {0, largest_grid_side},
                   .help = "a profile (grid.ny = 1) is drawn as a strip: its first site"});
    table.integer(
        "look.profile_sites", look.profile_sites,
        {.unit = "sites",
         .range = {0, 8192},
         .help = "how many sites of a profile are drawn; 0: 900, or all of a shorter one"});

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
               {.range = {1, 10000}, .help = "physical size, written into the PNG"});
}

void list_section_keys(SectionSettings& section, KeyTable& table) {
    table.role(KeyRole::look);
    table.text_list("section.panels", section.panels,
                    {.help = "panels of a section's figure: velocity, pressure, stress, flights, "
                             "flight-law, paths; empty: the first three, if the model has them"});
    table.choice(
        "section.arrows", section.arrows,
        {{SectionArrows::arrows, "arrows", "at evenly spaced places, with a reference arrow"},
         {SectionArrows::streamlines, "streamlines", "evenly spaced streamlines"},
         {SectionArrows::none, "none", "the colours alone"}},
        {.help = "how the velocity panel shows directions"});
    table.choice("section.colour_by", section.colour_by,
                 {{SectionColour::speed, "speed", "length of the velocity, m/s"},
                  {SectionColour::velocity_x, "velocity-x", "along the wind, m/s"},
                  {SectionColour::velocity_z, "velocity-z", "upward, m/s"},
                  {SectionColour::pressure, "pressure", "Pa"}},
                 {.help = "what the colours of the velocity panel mean"});
    table.word_or_real("section.low", section.low, {{"auto", "from the frame"}},
                       {.help = "value at the palette's start, in the unit of section.colour_by"});
    table.word_or_real("section.high", section.high, {{"auto", "from the frame"}},
                       {.help = "value at the palette's end"});
    table.word_or_real("section.font_size", section.font_size,
                       {{"auto", "a 36th of the picture's shorter side, or what leaves room"}},
                       {.unit = "points",
                        .range = {0, 1000, true},
                        .help = "of the figure's text, at image.dots_per_inch"});
}

void list_output_keys(OutputSettings& output, KeyTable& table) {
    table.role(KeyRole::file);
    table.boolean("output.frames", output.frames, {.help = "write frames as PNG"});
    table.boolean("output.movie", output.movie, {.help = "write movie.mp4"});
    table.boolean("output.world_files", output.world_files,
                  {.help = "beside each frame of camera.projection = \"map\" a world file (.pgw) "
                           "and the reference system (.png.aux.xml), for GIS"});
    table.role(KeyRole::look);
    table.real("output.movie_rate", output.movie_rate,
               {.unit = "frames/s", .range = {1, 240}, .help = "speed of the movie"});
    table.integer("output.movie_quality", output.movie_quality,
                  {.range = {0, 51}, .help = "H.264 rate factor: 18 looks lossless, 28 is small"});
    table.role(KeyRole::record);
    table.boolean("output.measurements", output.measurements, {.help = "write measurements.csv"});
    table.role(KeyRole::sampling);
    table.integer("output.measure_every", output.measure_every,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "measure every n steps; 0: with every frame"});
    table.role(KeyRole::file);
    table.integer("output.bed_every", output.bed_every,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "write the bed every n steps; 0: not"});
    table.integer_list(
        "output.bed_at", output.bed_at,
        {.unit = "steps", .range = {0, largest_step}, .help = "write the bed at these steps too"});
    table.text_list("output.bed_format", output.bed_format,
                    {.help = "as what beds are written: " + written_terrain_formats()});
    table.role(KeyRole::record);
    table.integer("output.fields_every", output.fields_every,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "record all fields in fields.nc (NetCDF) every n steps; 0: never"});
    table.integer_list("output.fields_at", output.fields_at,
                       {.unit = "steps",
                        .range = {0, largest_step},
                        .help = "record all fields at these steps too"});
    table.boolean("output.avalanches", output.avalanches,
                  {.help = "write avalanches.csv where the model has avalanches"});
}

void list_sweep_keys(SweepSettings& sweep, KeyTable& table) {
    table.role(KeyRole::sweep);
    table.text_list(
        "sweep.over", sweep.over,
        {.help = "what `fumon sweep` varies, written as for --over: \"key=v1,v2\", "
                 "\"key=low:high:count\", \"key+key=v1,v2\" for keys that go together"});
    table.integer("sweep.seeds", sweep.seeds,
                  {.unit = "seeds",
                   .range = {1, 1e6},
                   .help = "runs of each combination in a sweep: seed, seed + 1 …"});
}

}  // namespace

KeyTable scene_keys(Scene& scene) {
    KeyTable table;
    list_run_keys(scene, table);
    table.role(KeyRole::run);
    table.text("model.name", scene.model.name,
               {.help = "which model (required); see `fumon models`", .required = true});
    table.role(KeyRole::parameter);
    if (const ModelEntry* entry = find_model(scene.model.name))
        entry->list_keys(scene.model.parameters, table);
    list_bed_keys(scene, table);
    list_view_keys(scene.view, table);
    list_section_keys(scene.view.section, table);
    list_output_keys(scene.output, table);
    list_sweep_keys(scene.sweep, table);
    list_figure_keys(scene.figure, table);
    list_overlay_keys(scene.view.overlays, table);
    return table;
}

Scene default_scene(const std::string& model) {
    Scene scene;
    scene.model.name = model;
    if (const ModelEntry* entry = find_model(model)) {
        scene.model.parameters = entry->default_parameters();
        scene.bed.high = entry->home.noise_height;
    }
    return scene;
}

}  // namespace fumon
