#include "run/prepared_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "base/snapshots/ground_range.h"
#include "drape/lay_drape.h"
#include "drape/lay_layers.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/panels/section_figure.h"
#include "figure/words/chosen_words.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "measure/suite.h"
#include "models/registry.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/life/person_layer.h"
#include "render/life/track_layer.h"
#include "render/streamers/blown_sand.h"
#include "render/view/ground_choice.h"
#include "render/view/lens.h"
#include "render/view/water.h"
#include "run/output_files.h"
#include "scene/faults.h"
#include "scene/input_maps.h"
#include "scene/overlay_keys.h"
#include "scene/scene_keys.h"
#include "scene/trust.h"
#include "scene/wind_tables.h"

namespace fumon {

namespace {

/// A model's refusal of its bed or parameters, placed at the key it names, else where the model was
/// chosen.
std::unique_ptr<Model> make_model(const Scene& scene, ModelSetup setup) {
    try {
        return find_model(scene.model.name)->make(scene.model.parameters, std::move(setup));
    } catch (const KeyError& refusal) {
        throw InputError(
            scene.at(scene.locations.contains(refusal.key()) ? refusal.key() : "model.name") +
            refusal.what());
    }
}

void check_palette(const Scene& scene) {
    try {
        read_palette(scene.view.look.palette);
    } catch (const InputError& refusal) {
        throw InputError(scene.at("look.palette") + refusal.what());
    }
}

/// A marking needs a model that has something to mark.
void check_marking(const Scene& scene, const Snapshot& first) {
    const Marking mark = scene.view.look.mark;
    if (mark == Marking::none || marked_field(mark, first) != nullptr) return;
    if (mark == Marking::ground) {
        throw InputError(
            fmt::format("{}look.mark = \"ground\" needs a model with sand on rock (dunes), not {}",
                        scene.at("look.mark"), scene.model.name));
    }
    throw InputError(
        fmt::format("{}look.mark = \"last-avalanche\" needs a model with avalanches ({}), not {}",
                    scene.at("look.mark"), models_of(Landform::pile), scene.model.name));
}

/// Colours that mean the water, or a field, need a model that has it.
void check_colouring(const Scene& scene, const Snapshot& first) {
    if (colours_field(scene.view.look.colour_by)) {
        try {
            static_cast<void>(coloured_field(scene.view.look, first));
        } catch (const InputError& fault) {
            throw InputError(scene.at("look.field") + fault.what());
        }
        return;
    }
    if (!colours_water(scene.view.look.colour_by) || has_water(first)) return;
    throw InputError(
        fmt::format("{}look.colour_by shows the water, and the model {} has none; take height, "
                    "slope, change or natural",
                    scene.at("look.colour_by"), scene.model.name));
}

/// The figure of a section needs a model with one, which gives what its panels show.
void check_section(const Scene& scene, const Snapshot& first) {
    const bool as_usual = scene.view.section == SectionSettings{};
    if (as_usual && scene.view.look.mode != ViewMode::figure) return;
    if (!first.section) {
        const auto key = scene.locations.lower_bound("section.");
        if (as_usual || key == scene.locations.end()) return;  // resolved scenes list all keys
        throw InputError(fmt::format("{}{} needs a model with a section ({}), not {}",
                                     scene.at(key->first), key->first, models_of(Landform::air),
                                     scene.model.name));
    }
    if (scene.view.look.mode != ViewMode::figure) return;
    try {
        draw_section_figure(scene.view, first);
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// Overlays must fit the scene and the picture.
void check_overlays(const Scene& scene, const Snapshot& first) {
    if (!has_overlays(scene)) return;
    const LookSettings& look = scene.view.look;
    if (colours_field(look.colour_by) && find_named(first.fields, look.field) == nullptr)
        return;  // check_colouring() says so; a bar of its colours would say it again
    try {
        const FrameOverlays fitting(scene, first);
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// A sea, who stands or walked on the bed, and files beside frames: those for GIS need a map, and a
/// bed that lies on one.
void check_persons_and_files(const Scene& scene, const Snapshot& first) {
    try {
        check_lens(scene.view, first);
        check_sea(scene.view, first);
        check_persons(scene.view, first);
        check_tracks(scene.view, first);
        check_streamers(scene.view, first);
        check_map_files(scene, first);
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// Times and values of two columns of a file.
void read_edge_table(const std::filesystem::path& file, const Range& times_range,
                     const Range& values_range, std::vector<double>& times,
                     std::vector<double>& values) {
    const std::string text = read_input_file(file);
    const TextSource source{file.string(), text};
    const std::string help = "it takes two columns: seconds, and m3/s or metres";
    const Table table = parse_csv_table(source, {{"seconds", "value"}, help});
    if (table.columns.size() != 2 || table.rows() == 0) {
        throw InputError(fmt::format("{}: {} columns and {} rows; {}", file.string(),
                                     table.columns.size(), table.rows(), help));
    }
    times = numbers_of(source, table, table.columns[0], times_range.low, times_range.high);
    values = numbers_of(source, table, table.columns[1], values_range.low, values_range.high);
}

/// Puts the tables that [[edge]] names in their place, so that a resolved scene needs no file.
void read_edge_tables(Scene& scene) {
    const KeyTable keys = scene_keys(scene);
    const TableList* list = keys.find_list("edge");
    for (std::size_t n = 0; list != nullptr && n < list->size(); ++n) {
        const auto path = [&](const char* key) { return fmt::format("edge.{}.{}", n, key); };
        std::string& written = *std::get<std::string*>(keys.find(path("table"))->target);
        if (written.empty()) continue;
        const std::string place = scene.at(path("table"));
        const bool from_here = scene.set_on_command_line(path("table"));
        if (!scene.trusted && !from_here) {
            throw InputError(
                place +
                "a scene of unknown origin may not read tables; name the scene's file directly");
        }
        const auto list_of = [&](const char* key) {
            return std::get<RealListTarget>(keys.find(path(key))->target).values;
        };
        if (!list_of("times")->empty())
            throw InputError(place + "the table has the times; leave edge.times out");
        const std::filesystem::path named(written);
        try {
            read_edge_table(named.is_absolute() || from_here ? named : scene.directory / named,
                            keys.find(path("times"))->notes.range,
                            keys.find(path("values"))->notes.range, *list_of("times"),
                            *list_of("values"));
        } catch (const InputError& fault) {
            throw InputError(place + fault.what());
        }
        written.clear();
    }
}

/// Whether a scene shows more than the bed, which a model may not have.
bool asks_for_more(const Scene& scene) {
    const LookSettings& look = scene.view.look;
    return look.mark != Marking::none || leaves_cells_uncoloured(look.colour_by) ||
           look.mode == ViewMode::figure || scene.view.section != SectionSettings{} ||
           has_overlays(scene) || !look.sea_level.is_word() || scene.output.world_files ||
           scene.output.geotiff_frames || scene.output.exr_frames || !scene.view.persons.empty() ||
           !scene.view.tracks.empty() || scene.view.streamers.strength > 0.0 ||
           !scene.output.columns.empty();
}

/// Checks the scene's palette, and puts names and tables that it refers to in their place.
void complete(Scene& scene) {
    check_palette(scene);
    name_parameter_keys(scene);
    read_wind_tables(scene);
    read_edge_tables(scene);
    read_picture_words(scene);
    try {
        static_cast<void>(picture_words(scene.view.image));
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// Heights and cells are those of ground. Of a file that others named, a refusal tells nothing of
/// what is in it.
void check_ground(const Scene& scene, const InitialBed& initial) {
    const std::string fault = beyond_ground(initial.bed, initial.scale);
    if (fault.empty()) return;
    const bool of_file = bed_kind(scene) == BedKind::file;
    const std::string place = scene.at(of_file ? "bed.file" : "bed.kind");
    const bool may_report = !of_file || may_report_bed(scene);
    throw InputError(place + (may_report ? "the bed: " + fault : "the bed has impossible heights"));
}

/// One line on a palette that colours nothing, or empty. Resolved scenes list all keys.
std::string palette_in_vain(const Scene& scene) {
    const LookSettings& look = scene.view.look;
    if (look.colour_by != Colouring::natural || !scene.locations.contains("look.palette") ||
        look.palette == LookSettings{}.palette || !scene.figure.panels.empty())
        return {};
    return fmt::format(
        "{}look.palette = \"{}\" colours nothing while look.colour_by is \"natural\"; "
        "look.colour_by = \"height\" colours the bed by it",
        scene.at("look.palette"), look.palette);
}

PreparedScene with_bed(Scene scene, InitialBed initial) {
    scene.grid.nx = initial.bed.nx();  // resolved: a terrain file brings its own size
    scene.grid.ny = initial.bed.ny();
    return {std::move(scene), std::move(initial)};
}

}  // namespace

PreparedScene prepare_scene(Scene scene) {
    complete(scene);
    InitialBed initial = make_initial_bed(scene);
    add_maps(scene, initial);
    lay_drape(scene, initial);
    lay_layers(scene, initial);
    return with_bed(std::move(scene), std::move(initial));
}

PreparedScene prepare_scene(Scene scene, InitialBed initial) {
    complete(scene);
    if (initial.maps.empty()) add_maps(scene, initial);
    lay_drape(scene, initial);
    lay_layers(scene, initial);
    return with_bed(std::move(scene), std::move(initial));
}

namespace {

/// The names of output.columns, which a model's measures decide.
void check_measured_columns(const Scene& scene, const Snapshot& first) {
    if (scene.output.columns.empty()) return;
    MeasureChoice all = recorded_measures(scene);
    all.columns.clear();
    const std::vector<std::string> known =
        MeasureSuite(measured_landform(first), first, all).names();
    for (const std::string& name : scene.output.columns) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw InputError(fmt::format(
            "{}the measurements of {} have no column or group of columns \"{}\"; {}",
            scene.at("output.columns"), scene.model.name, name, suggestion(name, known)));
    }
}

}  // namespace

void check_shown(const Scene& scene, const Snapshot& first) {
    Faults faults(scene.source);
    for (const auto check : {check_marking, check_colouring, check_section, check_overlays,
                             check_persons_and_files, check_measured_columns})
        faults.attempt([&] { check(scene, first); });
    faults.report();
}

PreparedRun prepare_run(PreparedScene prepared, int threads) {
    PreparedRun run;
    run.scene = std::move(prepared.scene);
    run.initial = std::move(prepared.initial);
    check_ground(run.scene, run.initial);
    if (const std::string vain = palette_in_vain(run.scene); !vain.empty())
        run.initial.note += (run.initial.note.empty() ? "" : "; ") + vain;
    run.pool = std::make_unique<WorkerPool>(threads, "fumon-simulate");
    run.model = make_model(run.scene, {run.initial.bed, run.initial.nodata, run.initial.scale,
                                       static_cast<std::uint64_t>(run.scene.seed), *run.pool,
                                       bed_kind(run.scene) == BedKind::file, run.initial.maps});
    if (asks_for_more(run.scene)) check_shown(run.scene, run.model->snapshot());
    return run;
}

PreparedRun prepare_run(Scene scene, int threads) {
    return prepare_run(prepare_scene(std::move(scene)), threads);
}

}  // namespace fumon
