#include "scene/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "base/limits.h"
#include "files/terrain/terrain_format.h"
#include "keys/key_value.h"
#include "keys/keys.h"
#include "models/registry.h"
#include "scene/figure/figure_keys.h"
#include "scene/uses_metres.h"
#include "scene/view/view_keys.h"

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
                     .range = {smallest_cell_size, largest_cell_size},
                     .help = "one number or [dx, dy]; without it lengths are in sites"});
    table.word_or_real("grid.height_unit", scene.grid.height_unit,
                       {{"auto",
                         "1 m for models in metres (static, gully, airflow), else the cell size dx "
                         "(1 site without one)"}},
                       {.unit = "m",
                        .range = {smallest_height_unit, largest_height_unit},
                        .help = "metres per model height"});
    const char* height = uses_metres(scene) ? "m" : "model heights";
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
               {.unit = height,
                .range = {-largest_height, largest_height},
                .help = "height of a flat bed, or of a heap's top"});
    table.real("bed.heap_radius", scene.bed.heap_radius,
               {.unit = "m, or sites",
                .range = {0, largest_coordinate},
                .help = "of a heap's foot, in metres where cells have a size; its height falls as "
                        "the squared cosine"});
    table.real("bed.low", scene.bed.low,
               {.unit = height,
                .range = {-largest_height, largest_height},
                .help = "lower end of the noise"});
    table.real("bed.high", scene.bed.high,
               {.unit = height,
                .range = {-largest_height, largest_height},
                .help = "upper end of the noise; 0.01 for a gully"});
    table.role(KeyRole::run);
    table.text("bed.file", scene.bed.file,
               {.help = terrain_titles() +
                        ", heights in metres; relative to the scene file, or with --set to the "
                        "working folder"});
    table.role(KeyRole::parameter);
    table.real_list("bed.heights", scene.bed.heights, 0, 2,
                    {.unit = "m",
                     .range = {-largest_height, largest_height},
                     .help = "[low, high]: heights of black and white in a PNG bed"});
    table.text("bed.variable", scene.bed.variable,
               {.help = "variable of a NetCDF bed; needed where the file has several and no "
                        "bed_height"});
    table.integer("bed.record", scene.bed.record,
                  {.range = {0, 1000000000},
                   .help = "record of a NetCDF variable that has several (over time, band …), from "
                           "1; 0: its last one"});
    table.integer("bed.band", scene.bed.band,
                  {.range = {0, 65535},
                   .help = "band to read from a raster with several (1 is the first); 0: the only "
                           "band, or the first"});
    table.text("bed.height_unit", scene.bed.height_unit,
               {.help = "unit of a terrain file's heights in place of the one that it names: any "
                        "length of UDUNITS, GDAL or PROJ (\"ft\", \"US survey foot\", \"cm\"); "
                        "empty: the file's own, else metres"});
    table.real(
        "bed.height_factor", scene.bed.height_factor,
        {.range = {1e-9, 1e9}, .help = "factor by which a terrain file's heights are multiplied"});
    table.choice("bed.height_sign", scene.bed.height_sign,
                 {{HeightSign::automatic, "auto", "as the file says; heights where it does not"},
                  {HeightSign::up, "up", "heights"},
                  {HeightSign::down, "down", "depths, which are heights below 0"}},
                 {.help = "whether a terrain file's numbers are heights or depths"});
    table.real_list("bed.window", scene.bed.window, 0, 4,
                    {.range = {-largest_coordinate, largest_coordinate},
                     .help = "[west, south, east, north]: the part of a terrain file to read, in "
                             "the file's coordinates, or in cells from its south-west corner where "
                             "it has none; empty: all"});
    table.word_or_real("bed.nodata", scene.bed.nodata,
                       {{"mask", "cells without data lie outside the domain"},
                        {"fill", "filled smoothly from their rim"}},
                       {.unit = "m",
                        .range = {-largest_height, largest_height},
                        .help = "cells without data: masked, filled, or set to a height"});
    table.word_or_real(
        "bed.nodata_value", scene.bed.nodata_value, {{"auto", "what the file itself says"}},
        {.unit = "m",
         .help = "the height that stands for no data in a terrain file, in metres or as the file "
                 "has it"});
    table.boolean("bed.smooth_terraces", scene.bed.smooth_terraces,
                  {.help = "takes out the terraces of a terrain file whose heights are rounded (to "
                           "metres, feet, decimetres …): the smoothest surface that no cell leaves "
                           "by more than half a step; wide level water stays level"});
    table.text("bed.crs", scene.bed.crs,
               {.help = "reference system in metres to which a terrain file is reprojected: "
                        "\"utm\" or a code such as \"EPSG:32613\"; empty: the file's own"});
    table.real("bed.resample", scene.bed.resample,
               {.unit = "m",
                .range = {0, largest_cell_size},
                .help = "cell size to which a terrain file is resampled; 0: not resampled; "
                        "grid.cell_size is that of the file's own cells"});
    table.choice(
        "bed.resample_method", scene.bed.resample_method,
        {{Resampling::average, "average", "mean over the new cell: for larger cells"},
         {Resampling::bilinear, "bilinear",
          "linear between the four nearest cells: for smaller ones"},
         {Resampling::nearest, "nearest", "of the cell in which the new one's centre lies"}},
        {.help = "how bed.resample finds heights"});
    table.integer("bed.refine", scene.bed.refine,
                  {.range = {1, 64},
                   .help = "splits each cell of a terrain file into n x n, smooth in between; "
                           "grid.cell_size is that of the file's own cells"});
    table.choice("bed.refine_method", scene.bed.refine_method,
                 {{Refinement::spline, "spline",
                   "natural bicubic spline: slope and curvature are continuous (Unser 1999)"},
                  {Refinement::bicubic, "bicubic",
                   "the slope alone is continuous (Catmull & Rom 1974): curvature jumps from cell "
                   "to cell of the file, which running water picks up as rills along the grid"}},
                 {.help = "how bed.refine finds heights", .earlier = {"0.3.0", "\"bicubic\""}});
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
                       {.range = {-largest_colour_value, largest_colour_value},
                        .help = "value at the palette's start, in the unit of section.colour_by"});
    table.word_or_real("section.high", section.high, {{"auto", "from the frame"}},
                       {.range = {-largest_colour_value, largest_colour_value},
                        .help = "value at the palette's end"});
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
    table.boolean("output.geotiff_frames", output.geotiff_frames,
                  {.help = "beside each frame of camera.projection = \"map\" the same pixels as a "
                           "GeoTIFF (.tif), for GIS"});
    table.boolean("output.exr_frames", output.exr_frames,
                  {.help = "beside each frame its linear light before exposure and tone curve as "
                           "OpenEXR (.exr), without overlays"});
    table.role(KeyRole::look);
    table.choice("output.exr_layers", output.exr_layers,
                 {{ExrLayers::all, "all", "colour, depth, normals, positions and the bed's fields"},
                  {ExrLayers::colour, "colour", "colour alone"}},
                 {.help = "what OpenEXR files hold"});
    table.real("output.movie_rate", output.movie_rate,
               {.unit = "frames/s", .range = {1, 240}, .help = "speed of the movie"});
    table.integer("output.movie_quality", output.movie_quality,
                  {.range = {0, 51}, .help = "H.264 rate factor: 18 looks lossless, 28 is small"});
    table.role(KeyRole::record);
    table.boolean("output.measurements", output.measurements, {.help = "write measurements.csv"});
    table.text_list(
        "output.columns", output.columns,
        {.help = "which measurements are taken and written: names of columns or of groups "
                 "of columns; []: all. What plots over frames show is added"});
    table.role(KeyRole::sampling);
    table.real("output.channel_area", output.channel_area,
               {.unit = "m2",
                .range = {0, 1e15},
                .help = "measure the network of channels through which at least this area drains "
                        "(water and terrain; cells without metres); 0: not"});
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

std::vector<std::string> colour_settings(const std::string& colour) {
    if (colour.empty()) return {};
    if (colour == "natural") return {"look.colour_by=\"natural\""};  // no palette is of it
    Scene scene;
    const KeyTable table = scene_keys(scene);
    const auto& choice = std::get<ChoiceTarget>(table.find("look.colour_by")->target);
    const bool names_none = colour == "field" || colour == "field-change";  // words of look.field
    const bool is_word = !names_none && std::ranges::find(choice.words, colour, &KeyWord::word) !=
                                            choice.words.end();
    std::vector<std::string> settings;
    if (is_word) {
        settings.push_back(fmt::format("look.colour_by=\"{}\"", colour));
    } else {
        settings.emplace_back("look.colour_by=\"field\"");
        scene.view.look.field = colour;
        settings.push_back("look.field=" + value_text(*table.find("look.field")));
    }
    const bool balanced = colour == "change" || colour == "field-change";
    settings.push_back(fmt::format("look.palette=\"{}\"", balanced ? "vik" : "viridis"));
    return settings;
}

}  // namespace fumon
