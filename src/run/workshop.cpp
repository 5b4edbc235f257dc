#include "run/workshop.h"

#include <fmt/format.h>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/panels/section_figure.h"
#include "models/registry.h"
#include "render/colouring.h"
#include "render/palette.h"
#include "render/water.h"
#include "scene/overlay_keys.h"

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
void check_marking(const Scene& scene, const Model& model) {
    const Marking mark = scene.view.look.mark;
    if (mark == Marking::none || marked_field(mark, model.snapshot()) != nullptr) return;
    throw InputError(fmt::format(
        "{}look.mark = \"last-avalanche\" needs a model with avalanches (sandpile), not {}",
        scene.at("look.mark"), scene.model.name));
}

/// Colours that mean the water need a model that has some.
void check_colouring(const Scene& scene, const Model& model) {
    if (!colours_water(scene.view.look.colour_by) || has_water(model.snapshot())) return;
    throw InputError(
        fmt::format("{}look.colour_by shows the water, and the model {} has none; take height, "
                    "slope, change or natural",
                    scene.at("look.colour_by"), scene.model.name));
}

/// The figure of a section needs a model with one, which gives what its panels show.
void check_section(const Scene& scene, const Model& model) {
    const bool as_usual = scene.view.section == SectionSettings{};
    if (as_usual && scene.view.look.mode != ViewMode::figure) return;
    const Snapshot snapshot = model.snapshot();
    if (!snapshot.section) {
        const auto key = scene.locations.lower_bound("section.");
        if (as_usual || key == scene.locations.end()) return;  // resolved scenes list all keys
        throw InputError(fmt::format("{}{} needs a model with a section (airflow), not {}",
                                     scene.at(key->first), key->first, scene.model.name));
    }
    if (scene.view.look.mode != ViewMode::figure) return;
    try {
        draw_section_figure(scene.view, snapshot);
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

/// Overlays must fit the scene and the picture.
void check_overlays(const Scene& scene, const Model& model) {
    if (!has_overlays(scene)) return;
    try {
        const FrameOverlays fitting(scene, model.snapshot());
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

}  // namespace

Workshop set_up(Scene scene, int threads) {
    Workshop workshop;
    workshop.scene = std::move(scene);
    check_palette(workshop.scene);
    name_parameter_keys(workshop.scene);
    workshop.initial = make_initial_bed(workshop.scene);
    workshop.scene.grid.nx =
        workshop.initial.bed.nx();  // resolved: a terrain file brings its own size
    workshop.scene.grid.ny = workshop.initial.bed.ny();
    workshop.pool = std::make_unique<WorkerPool>(threads, "fumon-simulate");
    workshop.model = make_model(
        workshop.scene, {workshop.initial.bed, workshop.initial.nodata, workshop.initial.scale,
                         static_cast<std::uint64_t>(workshop.scene.seed), *workshop.pool,
                         bed_kind(workshop.scene) == BedKind::file});
    check_marking(workshop.scene, *workshop.model);
    check_colouring(workshop.scene, *workshop.model);
    check_section(workshop.scene, *workshop.model);
    check_overlays(workshop.scene, *workshop.model);
    return workshop;
}

}  // namespace fumon
