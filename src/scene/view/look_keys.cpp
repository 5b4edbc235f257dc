#include "base/limits.h"
#include "keys/keys.h"
#include "scene/view/view_keys.h"

namespace fumon {

namespace {

void list_colour_keys(LookSettings& look, KeyTable& table) {
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
          "decimal logarithm of the area that drains through a cell, m2"},
         {Colouring::field, "field",
          "a field of the run, look.field; cells without a value stay sand"},
         {Colouring::field_change, "field-change", "that field minus that of the first frame"}},
        {.help = "quantity shown by the colours"});
    table.text(
        "look.field", look.field,
        {.help = "of look.colour_by = \"field\": a field of the model as fields.nc names it, or "
                 "a variable of another model's file"});
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
}

void list_surroundings_keys(LookSettings& look, KeyTable& table) {
    table.choice(
        "look.ground", look.ground,
        {{Ground::automatic, "auto",
          "endless in perspective for a whole periodic bed without water, as the sand models "
          "have; else table"},
         {Ground::table, "table", "the bed is a block on a pale table"},
         {Ground::endless, "endless",
          "the ground goes on to the horizon, with wind ripples below the grid: a periodic bed "
          "repeats, and where a bed ends it runs out into invented land: a plain with relief of "
          "its own kind or, around terrain and water, land that is drained, whose streams lead on "
          "from its own"}},
        {.help = "what lies around the bed", .earlier = {"0.2.0", "\"table\""}});
    table.choice("look.far_copies", look.far_copies,
                 {{FarGround::varied, "varied",
                   "each wider or narrower than the bed, shifted, and lower; beyond 0.7 of the "
                   "bed's sides around what the first picture looks at"},
                  {FarGround::alike, "alike", "the bed as it is, again and again"}},
                 {.help = "repetitions of a periodic bed far from the camera, on endless ground",
                  .earlier = {"0.3.0", "\"alike\""}});
    table.choice("look.survey_edge", look.survey_edge,
                 {{SurveyEdge::none, "none", "as if all of it had been surveyed"},
                  {SurveyEdge::line, "line", "a thin line around the bed's cells"},
                  {SurveyEdge::fade, "fade", "invented land pales to grey within a dozen cells"}},
                 {.help = "how endless ground shows where a bed that ends gives way to invented "
                          "land"});
    table.choice("look.background", look.background,
                 {{Background::surroundings, "surroundings", "table, sky or the figure's paper"},
                  {Background::transparent, "transparent",
                   "nothing: the block alone, in a PNG with alpha; movies without alpha stand on "
                   "white"}},
                 {.help = "what stands behind the block"});
    table.choice(
        "look.light", look.light,
        {{LightKind::automatic, "auto",
          "studio around a block on its table, where the scene asks for no sky (look.sky, "
          "sun.source, sun.place, air.planet, air.clouds); else sun"},
         {LightKind::sun, "sun", "the sun or the moon, and the sky"},
         {LightKind::studio, "studio",
          "as a museum lights a model: a lamp 30 degrees wide in the sun's place, even light from "
          "all around, a neutral table and wall; for scenic views of a block"}},
        {.help = "what lights the ground", .earlier = {"0.3.0", "\"sun\""}});
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
          "\"atmosphere\"; filmic over endless ground with look.cover, and else"},
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
          "but not of red sand, and 1.12 with 0.3 stops less with look.cover = \"auto\"; else 1. "
          "Without such a cover, by day, shade two stops below middle grey and deeper keeps its "
          "share of the light"},
         {"auto-0.2", "the same numbers, with shade as dark as the power makes it"}},
        {.range = {0.2, 4},
         .help = "contrast of light before the tone curve: a power around middle grey",
         .earlier = {"0.3.0", "\"auto-0.2\""}});
}

void list_ground_keys(LookSettings& look, KeyTable& table) {
    table.boolean("look.block_sides", look.block_sides,
                  {.help = "draw the cut sides of the block"});
    table.choice("look.sides", look.sides,
                 {{BlockSides::plain, "plain", "plaster in the ground's tone"},
                  {BlockSides::soil, "soil",
                   "as a spade cuts it: damp sand under a dry skin, earth with stones"},
                  {BlockSides::layers, "layers", "sets of cross-beds, as in a dune's trench"}},
                 {.help = "what the block's sides show in a scenic view",
                  .earlier = {"0.3.0", "\"soil\""},
                  .earliest = {"0.2.0", "\"layers\""}});
    table.boolean("look.strata", look.strata,
                  {.help = "layers in steep ground and stones on it, which no data hold: a look, "
                           "for blocks with water and for mountains on endless ground",
                   .earlier = {"0.3.0", "true"}});
    table.choice("look.sand", look.sand,
                 {{SandKind::quartz, "quartz", "golden, as most dunes are"},
                  {SandKind::iron_red, "iron-red", "coated with iron oxide: Namib, Simpson Desert"},
                  {SandKind::gypsum, "gypsum", "white: White Sands"},
                  {SandKind::carbonate, "carbonate", "pale cream, of shells and corals"},
                  {SandKind::basalt, "basalt", "black: Iceland, Hawaii"},
                  {SandKind::martian, "mars", "basalt with a veil of red dust"}},
                 {.help = "colour of sand that is coloured \"natural\""});
    table.real("look.grain", look.grain, {.range = {0, 1}, .help = "visible grain of the sand"});
    table.choice(
        "look.pile", look.pile,
        {{PileSurface::smooth, "smooth",
          "dry sand: steps and pits of single cells are smoothed, and on a table cells without "
          "grains are a board; only in scenic views in natural colours, never in what is "
          "computed or measured"},
         {PileSurface::cells, "cells", "the cells as they are"}},
        {.help = "surface of piles of sand (model sandpile)", .earlier = {"0.3.0", "\"cells\""}});
    table.real("look.ripples", look.ripples,
               {.range = {0, 1},
                .help = "steepness of the wind ripples, too fine for the grid, on endless ground"});
    table.choice(
        "look.cover", look.cover,
        {{LandCover::bare, "bare", "earth and rock"},
         {LandCover::automatic, "auto",
          "by rule, as a look and not as data: rock where land is steep, grass where it is "
          "wet or faces north, soil, and snow above look.snow_line"}},
        {.help = "what covers terrain, with any model of it, in natural colours"});
    table.word_or_real(
        "look.sea_level", look.sea_level, {{"none", "no sea"}},
        {.unit = "m",
         .range = {-1e4, 1e4},
         .help = "still water that is drawn over ground below this height, in the bed's heights, "
                 "as far as it hangs together with the bed's edge; no model knows of it"});
    table.word_or_real("look.snow_line", look.snow_line, {{"none", "no snow"}},
                       {.unit = "m",
                        .range = {-1e4, 1e4},
                        .help = "height above which look.cover = \"auto\" lays snow, in the bed's "
                                "heights"});
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
}

void list_height_keys(LookSettings& look, KeyTable& table) {
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
        {{Datum::automatic, "auto",
          "mean for models with water and without look.sea_level, else first"},
         {Datum::first, "first", "the first bed's heights: a bed that sinks is seen to sink"},
         {Datum::mean, "mean",
          "each frame's mean height: a bed that sinks as a whole stays framed"}},
        {.help = "reference level for drawn heights"});
}

void list_water_keys(LookSettings& look, KeyTable& table) {
    table.boolean("look.water", look.water,
                  {.help = "draw the water over the bed, where the model has some"});
    table.word_or_real(
        "look.water_clarity", look.water_clarity,
        {{"auto", "from the frame's depths: ponds hide their ground, an even film does not"}},
        {.unit = "m", .range = {0, 1e6, true}, .help = "depth at which the bed is half hidden"});
    table.choice("look.water_tint", look.water_tint,
                 {{WaterTint::none, "none", "dark, as streams and ponds are"},
                  {WaterTint::blue_green, "blue-green", "as a clear sea over pale sand"}},
                 {.help = "colour of clear water", .earlier = {"0.3.0", "\"blue-green\""}});
    table.real("look.turbidity", look.turbidity,
               {.range = {0, 1}, .help = "turbidity of the water: 0 clear, 1 muddy"});
}

void list_drape_keys(LookSettings& look, KeyTable& table) {
    table.text(
        "look.drape", look.drape,
        {.help = "a map or photograph laid over the bed: PNG, JPEG, WebP, GeoTIFF or another "
                 "picture that GDAL reads, by its georeference (world file, GeoTIFF) in any "
                 "reference system, else fitted to the bed; empty: none"});
    table.real("look.drape_strength", look.drape_strength,
               {.range = {0, 1}, .help = "how far the drape hides the ground's own colour"});
    table.choice(
        "look.drape_light", look.drape_light,
        {{DrapeLight::relit, "relit", "its colours are the ground's, under the scene's light"},
         {DrapeLight::as_it_is, "as-it-is", "as the picture is, without light, shade and shadow"}},
        {.help = "light of the drape"});
}

void list_marking_keys(LookSettings& look, KeyTable& table) {
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
    table.choice(
        "look.rock", look.rock,
        {{RockSurface::weathered, "weathered", "worn and jointed, reddish brown"},
         {RockSurface::pavement, "pavement",
          "desert pavement where it is level: dark stones that wind has left, with sand "
          "in their lee"}},
        {.help = "what rock without sand looks like, where look.mark = \"ground\" shows it"});
    table.integer("look.profile_start", look.profile_start,
                  {.unit = "sites",
                   .range = {0, largest_grid_side},
                   .help = "first site of a profile (grid.ny = 1) that is drawn, as a strip"});
    table.integer(
        "look.profile_sites", look.profile_sites,
        {.unit = "sites",
         .range = {0, 8192},
         .help = "number of sites of a profile that are drawn; 0: 900, or all of a shorter one"});
}

}  // namespace

void list_look_keys(LookSettings& look, KeyTable& table) {
    list_colour_keys(look, table);
    table.word_or_real("look.exaggeration", look.exaggeration,
                       {{"auto",
                         "a round number that shows the relief and keeps 99 % of real terrain "
                         "below 45°; 1 without metres"},
                        {"relief", "a round number that shows the relief; 1 without metres"}},
                       {.range = {0, 1e4, true},
                        .help = "vertical exaggeration",
                        .earlier = {"0.2.0", "\"relief\""}});
    list_surroundings_keys(look, table);
    list_ground_keys(look, table);
    list_height_keys(look, table);
    table.choice("look.relief", look.relief,
                 {{FigureRelief::soft, "soft", "gentle shade, shadows, grey layered sides"},
                  {FigureRelief::clear, "clear",
                   "as a block diagram is drawn: deep shade and bright slopes, faint shadows, "
                   "plain light sides with a thin outline"}},
                 {.help = "of a figure's hill shading"});
    table.real("look.shading", look.shading,
               {.range = {0, 1}, .help = "hill shading of a figure; 0: the colours alone"});
    list_water_keys(look, table);
    list_marking_keys(look, table);
    list_drape_keys(look, table);
}

}  // namespace fumon
