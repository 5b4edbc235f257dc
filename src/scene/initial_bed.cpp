#include "scene/initial_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/limits.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "files/terrain/reproject.h"
#include "files/terrain/suspect_heights.h"
#include "files/terrain/terraces/terraces.h"
#include "files/terrain/terrain_file.h"
#include "models/registry.h"
#include "numerics/resampling.h"
#include "numerics/spline_refinement.h"
#include "scene/beds/made_beds.h"
#include "scene/beds/memory_bed.h"
#include "scene/beds/nodata_height.h"
#include "scene/trust.h"

namespace fumon {

namespace {

ModelDefaults home_of(const Scene& scene) {
    const ModelEntry* model = find_model(scene.model.name);
    return model != nullptr ? model->home : ModelDefaults{};
}

/// Cells northward: one for a model on a profile, unless the scene says otherwise.
int rows_of(const Scene& scene) {
    if (home_of(scene).on_profile && !scene.locations.contains("grid.ny")) return 1;
    return static_cast<int>(scene.grid.ny);
}

/// Whether a key of the scene holds for its terrain file. A file named on the command line takes
/// the place of the scene's own bed, and of the size written for that.
bool holds_for_file(const Scene& scene, const char* key) {
    if (!scene.locations.contains(key)) return false;
    return scene.set_on_command_line(key) || !scene.set_on_command_line("bed.file");
}

/// What messages call the bed.
std::string bed_title(const Scene& scene) {
    return is_memory_bed(scene.bed.file) ? memory_bed_title : scene.bed.file;
}

void check_size(const Scene& scene, const char* key, std::int64_t wanted, int found) {
    if (!holds_for_file(scene, key) || wanted == found) return;
    throw InputError(
        fmt::format("{}{} is {}, but {} has {} cells there; leave the key out for a terrain file",
                    scene.at(key), key, wanted, bed_title(scene), found));
}

/// Whether a model height is as long as a cell: where neither the scene nor the model says more.
bool height_follows_cells(const Scene& scene) {
    const ModelEntry* model = find_model(scene.model.name);
    const bool is_terrain = model != nullptr && model->landform == Landform::terrain;
    return home_of(scene).cell_size == 0.0 && scene.grid.height_unit.is_word() && !is_terrain;
}

/// Cell size from the scene, from the file, or none. Where both have one they must agree.
WorldScale scale_of(const Scene& scene, double file_dx, double file_dy) {
    WorldScale scale;
    const std::vector<double>& given = scene.grid.cell_size;
    const bool file_decides = file_dx > 0.0 && !holds_for_file(scene, "grid.cell_size");
    if (!given.empty() && !file_decides) {
        scale.dx = given.front();
        scale.dy = given.back();
        scale.in_metres = true;
        constexpr double tolerance = 1e-6;
        if (file_dx > 0.0 && (std::abs(scale.dx / file_dx - 1.0) > tolerance ||
                              std::abs(scale.dy / file_dy - 1.0) > tolerance)) {
            throw InputError(fmt::format(
                "{}grid.cell_size is [{}, {}] m, but {} has cells of [{:.6g}, {:.6g}] m; leave the "
                "key out",
                scene.at("grid.cell_size"), scale.dx, scale.dy, bed_title(scene), file_dx,
                file_dy));
        }
    } else if (file_dx > 0.0) {
        scale.dx = file_dx;
        scale.dy = file_dy;
        scale.in_metres = true;
    }
    const ModelDefaults home = home_of(scene);
    if (home.cell_size > 0.0) {
        if (!scale.in_metres) scale = {home.cell_size, home.cell_size, 1.0, true};
        if (!scene.grid.height_unit.is_word() && scene.grid.height_unit.value != 1.0) {
            throw InputError(fmt::format(
                "{}grid.height_unit is {}, but {} works in metres; leave the key out",
                scene.at("grid.height_unit"), scene.grid.height_unit.value, scene.model.name));
        }
    } else if (!scene.grid.height_unit.is_word()) {
        scale.height_unit = scene.grid.height_unit.value;
    } else {
        scale.height_unit = height_follows_cells(scene) ? scale.dx : 1.0;
    }
    return scale;
}

/// Takes the cells of height bed.nodata_value, in metres or as the file has it, out of a terrain.
void take_out_nodata_value(const Scene& scene, Terrain& terrain) {
    const WordOrReal& value = scene.bed.nodata_value;
    if (value.is_word()) return;
    const std::int64_t cells = take_out_height(terrain, value.value);
    if (cells == 0) {
        throw InputError(
            fmt::format("{}bed.nodata_value is {:g} m, but no cell of {} has that height; leave "
                        "the key out",
                        scene.at("bed.nodata_value"), value.value, bed_title(scene)));
    }
    if (cells == static_cast<std::int64_t>(terrain.heights.size())) {
        throw InputError(fmt::format("{}bed.nodata_value is {:g} m, the height of every cell of {}",
                                     scene.at("bed.nodata_value"), value.value, bed_title(scene)));
    }
}

/// One line on cells whose size nobody said, in a model that lives in metres; or empty.
std::string guessed_cells(const Scene& scene, const Terrain& terrain, const WorldScale& scale) {
    if (!scale.in_metres || terrain.dx > 0.0 || !scene.grid.cell_size.empty()) return {};
    return fmt::format("{} has no cell size: {:g} m is assumed (override with grid.cell_size)",
                       is_memory_bed(scene.bed.file) ? memory_bed_title : "the file", scale.dx);
}

void apply_nodata_rule(const Scene& scene, Terrain& terrain) {
    if (terrain.nodata.empty()) return;
    const WordOrReal& rule = scene.bed.nodata;
    if (rule.word == "mask") return;
    if (rule.word == "fill") {
        terrain.heights = fill_nodata(terrain.heights, terrain.nodata);
    } else {
        for (std::size_t cell = 0; cell < terrain.heights.size(); ++cell) {
            if (terrain.nodata.values()[cell] != 0) terrain.heights.values()[cell] = rule.value;
        }
    }
    terrain.nodata = {};
}

/// Divides each cell as bed.refine says, with heights between them as bed.refine_method says.
void refine(const Scene& scene, Terrain& terrain) {
    const auto refinement = static_cast<int>(scene.bed.refine);
    if (refinement == 1) return;
    const std::int64_t cells =
        static_cast<std::int64_t>(terrain.heights.size()) * refinement * refinement;
    check_limits(scene, cells, 0);
    if (cells > largest_grid_cells) {
        throw InputError(fmt::format(
            "{}bed.refine is {}: {} x {} cells would become {}; at most {}", scene.at("bed.refine"),
            refinement, terrain.heights.nx(), terrain.heights.ny(), cells, largest_grid_cells));
    }
    if (scene.bed.refine_method == Refinement::spline) {
        // A spline reaches farther than a few cells: no height may be foreign to the others.
        if (!terrain.nodata.empty()) terrain.heights = fill_nodata(terrain.heights, terrain.nodata);
        terrain.heights = spline_refined(terrain.heights, refinement);
    } else {
        if (!terrain.nodata.empty()) extrapolate_outward(terrain.heights, terrain.nodata, 0.0);
        terrain.heights = refined(terrain.heights, refinement);
    }
    terrain.nodata = refined(terrain.nodata, refinement);
    if (terrain.place) {
        terrain.place->dx /= refinement;
        terrain.place->dy /= refinement;
    }
}

TerrainQuery query_of(const Scene& scene) {
    const BedSettings& bed = scene.bed;
    TerrainQuery query{.png_heights = bed.heights,
                       .variable = bed.variable,
                       .band = bed.band,
                       .record = bed.record,
                       .height_unit = bed.height_unit,
                       .height_factor = bed.height_factor,
                       .height_sign = bed.height_sign};
    if (bed.window.size() == 4)
        query.window = {bed.window[0], bed.window[1], bed.window[2], bed.window[3]};
    query.trusted = may_report_bed(scene);
    return query;
}

/// Not for a grid in metres from (0, 0), as local ones are and fumon's own.
bool lies_somewhere(const GeoReference& place) {
    return place.west != 0.0 || place.south != 0.0 || place.degrees || !place.crs.empty();
}

/// Brings the terrain onto cells of bed.resample metres.
void resample(const Scene& scene, Terrain& terrain, WorldScale& scale) {
    const double size = scene.bed.resample;
    if (size == 0.0) return;
    const std::string key = scene.at("bed.resample") + "bed.resample";
    if (!scale.in_metres) {
        throw InputError(fmt::format("{} is {} m, but {} has no cell size; write grid.cell_size",
                                     key, size, bed_title(scene)));
    }
    const double cells =
        static_cast<double>(terrain.heights.size()) * (scale.dx / size) * (scale.dy / size);
    check_limits(scene, static_cast<std::int64_t>(std::min(cells, 1e18)), 0);
    terrain = resampled(terrain, scale.dx, scale.dy, size, scene.bed.resample_method, key);
    if (height_follows_cells(scene)) scale.height_unit = size;
    scale.dx = size;
    scale.dy = size;
}

/// Whether a scene's terrain file is not looked for from the scene's folder.
bool named_from_here(const Scene& scene) {
    return std::filesystem::path(scene.bed.file).is_absolute() ||
           scene.set_on_command_line("bed.file");
}

/// A scene from a picture's metadata opens no file that the metadata does not list.
void check_listed(const Scene& scene, const std::filesystem::path& file) {
    if (!scene.bed_hashes || scene.set_on_command_line("bed.file")) return;
    const auto& hashes = *scene.bed_hashes;
    if (std::ranges::any_of(hashes, [&](const auto& hash) { return has_grid_hash(file, hash); }))
        return;
    throw InputError(fmt::format(
        "{}{} is not one of the files whose SHA-256 the metadata lists, is missing, or has changed",
        scene.at("bed.file"), file.string()));
}

InputError no_bed_in(const Scene& scene, const std::filesystem::path& file) {
    return InputError(
        fmt::format("{}{} does not exist or is not a readable bed; --trust gives details",
                    scene.at("bed.file"), file.string()));
}

/// The file as it is asked for. Where others named it, what is wrong with it tells nothing of what
/// is in it, nor whether it is there.
Terrain read_bed_file(const Scene& scene, const std::filesystem::path& file) {
    try {
        return read_terrain(file, query_of(scene));
    } catch (const InputError&) {
        if (may_report_bed(scene)) throw;
        throw no_bed_in(scene, file);
    }
}

/// As suspect_heights(); of a file that others named a refusal tells nothing of what is in it.
std::string terrain_warning(const Scene& scene, const Terrain& terrain,
                            const std::filesystem::path& file) {
    try {
        return suspect_heights(terrain,
                               is_memory_bed(scene.bed.file) ? memory_bed_title : file.string());
    } catch (const InputError&) {
        if (may_report_bed(scene)) throw;
        throw no_bed_in(scene, file);
    }
}

/// Brings the terrain to the reference system of bed.crs.
void reproject(const Scene& scene, Terrain& terrain) {
    if (scene.bed.crs.empty()) return;
    try {
        terrain = reprojected(terrain, scene.bed.crs);
    } catch (const InputError& refusal) {
        throw InputError(fmt::format("{}bed.crs: {}: {}", scene.at("bed.crs"), bed_title(scene),
                                     refusal.what()));
    }
}

/// Takes out the terraces of rounded heights where bed.smooth_terraces says so. One line on what
/// was done, or could be; or empty.
std::string smooth_terraces(const Scene& scene, Terrain& terrain) {
    const std::optional<double> step = height_step(terrain);
    if (!scene.bed.smooth_terraces) {
        const bool is_terrain = terrain.dx > 0.0;  // and no bed in sites, whose heights are whole
        if (!step || !is_terrain || !has_terraces(terrain, *step)) return {};
        return fmt::format(
            "heights are multiples of {:.4g} m, which makes terraces (bed.smooth_terraces = true "
            "takes them out)",
            *step);
    }
    if (!step)
        return "heights are not multiples of a step: bed.smooth_terraces leaves them unchanged";
    const bool has_cells = terrain.dx > 0.0 && terrain.dy > 0.0;
    terrain.heights = without_terraces(terrain, *step, has_cells ? terrain.dx : 1.0,
                                       has_cells ? terrain.dy : 1.0);
    return fmt::format("terraces of {:.4g} m are taken out of the heights", *step);
}

/// What a program has handed over. Keys that say how a file is read mean nothing for it.
Terrain memory_terrain(const Scene& scene) {
    const BedSettings& bed = scene.bed;
    const std::array<std::pair<const char*, bool>, 8> given{
        {{"bed.window", !bed.window.empty()},
         {"bed.heights", !bed.heights.empty()},
         {"bed.variable", !bed.variable.empty()},
         {"bed.record", bed.record != 0},
         {"bed.band", bed.band != 0},
         {"bed.height_unit", !bed.height_unit.empty()},
         {"bed.height_factor", bed.height_factor != 1.0},
         {"bed.height_sign", bed.height_sign != HeightSign::automatic}}};
    for (const auto& [key, is_given] : given) {
        if (!is_given) continue;
        throw InputError(
            fmt::format("{}{} applies to files, but the bed is an array; prepare the array itself",
                        scene.at(key), key));
    }
    try {
        return find_memory_bed(scene.bed.file)->terrain();
    } catch (const InputError& fault) {
        throw InputError(scene.at("bed.file") + fault.what());
    }
}

/// The terrain file of a scene, where the scene may read it and it is there.
Terrain terrain_of_file(const Scene& scene, const std::filesystem::path& file) {
    check_listed(scene, file);
    check_trust(scene, "bed.file", file);
    std::error_code fault;
    if (!std::filesystem::exists(file, fault) && !may_report_bed(scene))
        throw no_bed_in(scene, file);
    if (!std::filesystem::exists(file, fault) && !scene.locations.contains("bed.file")) {
        throw InputError(fmt::format("{}: does not exist; check the path", file.string()));
    }
    if (!std::filesystem::exists(file, fault)) {
        throw InputError(fmt::format(
            "{}bed.file \"{}\" does not exist (looked for {}); paths are relative to {}",
            scene.at("bed.file"), scene.bed.file, file.string(),
            named_from_here(scene) ? "the working folder" : "the scene file"));
    }
    return read_bed_file(scene, file);
}

InitialBed bed_from_file(const Scene& scene) {
    const std::filesystem::path file = bed_path(scene);
    const bool held = is_memory_bed(scene.bed.file);
    Terrain terrain = held ? memory_terrain(scene) : terrain_of_file(scene, file);
    take_out_nodata_value(scene, terrain);
    const std::string warning = terrain_warning(scene, terrain, file);
    const std::string terraces = smooth_terraces(scene, terrain);
    reproject(scene, terrain);
    for (const std::string& remark : {warning, terraces}) {
        if (!remark.empty()) add_note(terrain, remark);
    }
    InitialBed initial;
    initial.scale = scale_of(scene, terrain.dx, terrain.dy);
    if (const std::string guess = guessed_cells(scene, terrain, initial.scale); !guess.empty())
        terrain.note += (terrain.note.empty() ? "" : "; ") + guess;
    const std::string note = terrain.note;
    resample(scene, terrain, initial.scale);
    const int refinement = static_cast<int>(scene.bed.refine);
    check_size(scene, "grid.nx", scene.grid.nx, terrain.heights.nx() * refinement);
    check_size(scene, "grid.ny", scene.grid.ny, terrain.heights.ny() * refinement);
    apply_nodata_rule(scene, terrain);
    refine(scene, terrain);
    initial.scale.dx /= refinement;
    initial.scale.dy /= refinement;
    if (terrain.place && lies_somewhere(*terrain.place))
        initial.scale.place = std::move(terrain.place);
    initial.bed = std::move(terrain.heights);
    if (initial.scale.height_unit != 1.0) {
        for (double& height : initial.bed.values()) height /= initial.scale.height_unit;
    }
    initial.nodata = std::move(terrain.nodata);
    initial.inputs.push_back(
        held ? InputFile{scene.bed.file, find_memory_bed(scene.bed.file)->hash()}
             : InputFile{file.lexically_normal().string(), hex(grid_hash(file))});
    initial.note = note;
    return initial;
}

}  // namespace

std::filesystem::path bed_path(const Scene& scene) {
    return named_from_here(scene) || is_memory_bed(scene.bed.file)
               ? std::filesystem::path(scene.bed.file)
               : scene.directory / scene.bed.file;
}

BedKind bed_kind(const Scene& scene) {
    if (scene.bed.kind != BedKind::automatic) return scene.bed.kind;
    if (!scene.bed.file.empty()) return BedKind::file;
    return home_of(scene).starts_bare ? BedKind::flat : BedKind::noise;
}

InitialBed make_initial_bed(const Scene& scene) {
    const BedKind kind = bed_kind(scene);
    if (kind == BedKind::file) {
        InitialBed initial = bed_from_file(scene);
        check_limits(scene, static_cast<std::int64_t>(initial.bed.size()), scene.run.steps);
        return initial;
    }
    InitialBed initial;
    initial.scale = scale_of(scene, 0.0, 0.0);
    const BedSize size{static_cast<int>(scene.grid.nx), rows_of(scene)};
    const WorldScale& scale = initial.scale;
    initial.bed =
        kind == BedKind::noise ? noise_bed(size, scene.seed, scene.bed.low, scene.bed.high)
        : kind == BedKind::heap
            ? heap_bed(size, scale.in_metres ? scale.dx : 1.0, scale.in_metres ? scale.dy : 1.0,
                       scene.bed.height, scene.bed.heap_radius)
            : Grid(size.nx, size.ny, scene.bed.height);
    return initial;
}

}  // namespace fumon
