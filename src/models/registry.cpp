#include "models/registry.h"

#include <array>

#include "base/find_named.h"
#include "models/air/airflow.h"
#include "models/dunes/dunes.h"
#include "models/pile/sandpile.h"
#include "models/sand/sand.h"
#include "models/static/static_bed.h"
#include "models/water/gully.h"

namespace fumon {

namespace {

template <class Parameters, class Kind>
constexpr ModelEntry entry(std::string_view help, ModelDefaults home = {}) {
    return {Kind::model_name,
            help,
            Kind::landform,
            home,
            [] { return std::any(Parameters{}); },
            [](std::any& parameters, KeyTable& table) {
                list_keys(std::any_cast<Parameters&>(parameters), table);
            },
            [](const std::any& parameters, ModelSetup setup) -> std::unique_ptr<Model> {
                return std::make_unique<Kind>(std::any_cast<const Parameters&>(parameters),
                                              std::move(setup));
            }};
}

constexpr std::array all_models{
    entry<SandParameters, Sand>("wind-blown sand that hops and creeps: ripples, dunes, barchans"),
    entry<DunesParameters, Dunes>(
        "dunes with slip faces under any wind, in metres and years: barchans, ridges, stars",
        {.cell_size = 1.0}),
    entry<SandpileParameters, Sandpile>(
        "a pile that grains fall on and that topples: cones, avalanches and their sizes",
        {.starts_bare = true}),
    entry<GullyParameters, Gully>(
        "water down a slope that it erodes: gullies, channels with banks, rain on terrain",
        {.cell_size = 1.0, .noise_height = 0.01}),
    entry<WaterParameters, WaterModel>(
        "water over a bed that stays: breaking dams, floods, lakes, rain on terrain",
        {.starts_bare = true, .cell_size = 1.0}),
    entry<AirflowParameters, Airflow>(
        "air between a rippled bed and a moving lid: velocity, pressure, shear stress",
        {.starts_bare = true, .cell_size = 5e-5, .on_profile = true}),
    entry<StaticParameters, StaticBed>("a bed as it is: look at a terrain"),
};

}  // namespace

std::span<const ModelEntry> models() {
    return all_models;
}

const ModelEntry* find_model(std::string_view name) {
    return find_named(all_models, name);
}

const ModelEntry& terrain_model() {
    return *std::ranges::find(all_models, Landform::terrain, &ModelEntry::landform);
}

std::string models_of(Landform landform) {
    std::string names;
    for (const ModelEntry& model : all_models) {
        if (model.landform != landform) continue;
        names += names.empty() ? "" : ", ";
        names += model.name;
    }
    return names;
}

}  // namespace fumon
