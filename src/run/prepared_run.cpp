#include "run/prepared_run.h"

#include <fmt/format.h>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/panels/section_figure.h"
#include "models/registry.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/view/water.h"
#include "scene/faults.h"
#include "scene/overlay_keys.h"
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
    throw InputError(
        fmt::format("{}look.mark = \"last-avalanche\" needs a model with avalanches ({}), not {}",
                    scene.at("look.mark"), models_of(Landform::pile), scene.model.name));
}

/// Colours that mean the water need a model that has some.
void check_colouring(const Scene& scene, const Snapshot& first) {
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
    try {
        const FrameOverlays fitting(scene, first);
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// Whether a scene shows more than the bed, which a model may not have.
bool asks_for_more(const Scene& scene) {
    const LookSettings& look = scene.view.look;
    return look.mark != Marking::none || colours_water(look.colour_by) ||
           look.mode == ViewMode::figure || scene.view.section != SectionSettings{} ||
           has_overlays(scene);
}

}  // namespace

PreparedScene prepare_scene(Scene scene) {
    check_palette(scene);
    name_parameter_keys(scene);
    read_wind_tables(scene);
    InitialBed initial = make_initial_bed(scene);
    scene.grid.nx = initial.bed.nx();  // resolved: a terrain file brings its own size
    scene.grid.ny = initial.bed.ny();
    return {std::move(scene), std::move(initial)};
}

void check_shown(const Scene& scene, const Snapshot& first) {
    Faults faults(scene.source);
    for (const auto check : {check_marking, check_colouring, check_section, check_overlays})
        faults.attempt([&] { check(scene, first); });
    faults.report();
}

PreparedRun prepare_run(PreparedScene prepared, int threads) {
    PreparedRun run;
    run.scene = std::move(prepared.scene);
    run.initial = std::move(prepared.initial);
    run.pool = std::make_unique<WorkerPool>(threads, "fumon-simulate");
    run.model = make_model(run.scene, {run.initial.bed, run.initial.nodata, run.initial.scale,
                                       static_cast<std::uint64_t>(run.scene.seed), *run.pool,
                                       bed_kind(run.scene) == BedKind::file});
    if (asks_for_more(run.scene)) check_shown(run.scene, run.model->snapshot());
    return run;
}

PreparedRun prepare_run(Scene scene, int threads) {
    return prepare_run(prepare_scene(std::move(scene)), threads);
}

}  // namespace fumon
