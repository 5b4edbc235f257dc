#pragma once

#include <any>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "files/terrain/resample_terrain.h"
#include "files/terrain/terrain_file.h"
#include "keys/word_or_real.h"
#include "scene/figure/figure_settings.h"
#include "scene/view/view.h"

namespace fumon {

struct ModelChoice {
    std::string name;
    std::any parameters;  ///< the model's own struct, see models/registry.h
};

struct GridSettings {
    std::int64_t nx = 100;
    std::int64_t ny = 100;
    std::vector<double> cell_size;        ///< metres: empty, {dx} or {dx, dy}
    WordOrReal height_unit{"auto", 0.0};  ///< metres per model height
};

/// How heights come onto the finer cells of bed.refine.
enum class Refinement {
    spline,   ///< natural bicubic spline: slope and curvature are continuous
    bicubic,  ///< Catmull & Rom (1974): the slope is continuous
};

enum class BedKind { automatic, flat, noise, heap, file };

struct BedSettings {
    BedKind kind = BedKind::automatic;
    double height = 0.0;           ///< flat, or of the heap's top: model heights
    double heap_radius = 0.0;      ///< heap: of its foot, metres or sites
    double low = 0.0, high = 1.0;  ///< noise: uniform in [low, high), model heights
    std::string file;              ///< file: as written in the scene
    std::vector<double> heights;   ///< file, PNG: metres of black and of white
    std::string variable;          ///< file, NetCDF: the variable to read; empty for the file's own
    std::int64_t band = 0;         ///< file, GeoTIFF: the band to read; 0: the only or first one
    std::int64_t record = 0;       ///< file, NetCDF: of a variable with records; 0: the last one
    std::string height_unit;       ///< file: instead of the unit that it names; empty: its own
    double height_factor = 1.0;    ///< file: by which its heights are multiplied
    HeightSign height_sign = HeightSign::automatic;  ///< file: heights or depths
    std::vector<double> window;  ///< file: west, south, east, north of the part to read, or none
    WordOrReal nodata{"mask", 0.0};
    WordOrReal nodata_value{"auto", 0.0};  ///< m, that stands for no data; auto: the file says
    bool smooth_terraces = false;  ///< file: whether the terraces of rounded heights are taken out
    std::string crs;               ///< file: the reference system to bring it to; empty: its own
    double resample = 0.0;  ///< file: size of the model's cells, metres; 0: the file's own cells
    Resampling resample_method = Resampling::average;
    std::int64_t refine = 1;  ///< file: cells along each side of one of its cells
    Refinement refine_method = Refinement::spline;
};

struct RunSettings {
    std::int64_t steps = 0;
};

/// When frames are taken: every n steps, at listed steps, or at logarithmically spaced ones.
struct FrameSettings {
    std::int64_t every = 0;
    std::vector<std::int64_t> at;
    std::int64_t logarithmic = 0;
};

enum class ExrLayers { all, colour };

struct OutputSettings {
    bool frames = true;
    bool movie = true;
    bool exr_frames = false;  ///< beside the frames, their light and layers as OpenEXR
    ExrLayers exr_layers = ExrLayers::all;
    bool world_files = false;         ///< beside the frames, where on the map they lie
    bool geotiff_frames = false;      ///< the frames as GeoTIFF, too
    double movie_rate = 30.0;         ///< frames per second
    std::int64_t movie_quality = 18;  ///< H.264 constant rate factor, 0 (lossless) … 51
    bool measurements = true;
    std::vector<std::string> columns;  ///< of them: columns and groups of a suite; none: all
    std::int64_t measure_every = 0;    ///< steps between measurements; 0: with every frame
    double channel_area = 0.0;   ///< least drainage area of a measured channel, m²; 0: no network
    std::int64_t bed_every = 0;  ///< steps between written beds; 0: none
    std::vector<std::int64_t> bed_at;
    std::vector<std::string> bed_format{"esri-ascii"};  ///< names of terrain formats
    std::int64_t fields_every = 0;  ///< steps between records of fields.nc; 0: none
    std::vector<std::int64_t> fields_at;
    bool avalanches = true;  ///< avalanches.csv, where the model has avalanches
};

/// What `fumon sweep` runs when its command line does not say.
struct SweepSettings {
    std::vector<std::string> over;  ///< "key=v1,v2" or "key=lo:hi:n", as for --over
    std::int64_t seeds = 1;         ///< of each combination: seed, seed + 1 …
};

/// What messages call the place of a key that a Python program has set.
inline constexpr const char* python_place = "in Python";

/// What to simulate and how to show it: a value. Scene::locations knows where each key stood.
struct Scene {
    std::string title;
    std::int64_t seed = 1;
    ModelChoice model;
    GridSettings grid;
    BedSettings bed;
    RunSettings run;
    FrameSettings frames;
    View view;
    OutputSettings output;
    SweepSettings sweep;
    FigureSettings figure;

    std::filesystem::path directory;  ///< where relative files are looked for
    std::string source;               ///< the file's name, for messages
    bool trusted = true;              ///< the user named it; else scene/trust.h holds
    /// Where set, the SHA-256 (hexadecimal) that its bed file may have, unless that stands on the
    /// command line: those that a picture's metadata lists.
    std::shared_ptr<const std::vector<std::string>> bed_hashes;
    std::map<std::string, std::string> locations;  ///< key path → "file:line:column"

    /// "file:line:column: " of a key, or of the file where the key is not written.
    [[nodiscard]] std::string at(const std::string& key) const;
    /// Whether the key's value comes from the command line (--set, --over) or from a program that
    /// fumon is part of.
    [[nodiscard]] bool set_on_command_line(const std::string& key) const;
};

}  // namespace fumon
