#pragma once

#include <any>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/landform.h"
#include "models/shared/model.h"

namespace fumon {

class KeyTable;

/// A model's defaults for keys of [grid] and [bed] that the scene does not set.
struct ModelDefaults {
    bool starts_bare = false;  ///< its usual initial bed is flat, not noise
    /// Usual cell size, metres, of a model that lives in metres and seconds, whose heights are
    /// metres; 0 for one that lives in sites and model heights.
    double cell_size = 0.0;
    /// Upper end of its usual initial noise, model heights, where bed.high is not written.
    double noise_height = 1.0;
    bool on_profile = false;  ///< its bed is a single row: grid.ny is 1 where it is not written
};

/// One model as scenes know it. Its parameters are held in a `std::any`, into which only the
/// model's own functions look.
struct ModelEntry {
    std::string_view name;
    std::string_view help;  ///< one line
    Landform landform;      ///< of its snapshots
    ModelDefaults home;
    std::any (*default_parameters)();
    /// Lists the keys `model.*` of these parameters, bound to them.
    void (*list_keys)(std::any& parameters, KeyTable& table);
    /// Builds the model. Throws InputError where parameters or bed do not fit the model.
    std::unique_ptr<Model> (*make)(const std::any& parameters, ModelSetup setup);
};

/// Every model, in the order in which `fumon models` lists them.
std::span<const ModelEntry> models();

/// The entry of that name, or nullptr.
const ModelEntry* find_model(std::string_view name);

/// The model of a bed as it is, for terrain files and for figures that need no model.
const ModelEntry& terrain_model();

/// The names of all models of a landform, for messages: "airflow", or "one, other".
std::string models_of(Landform landform);

}  // namespace fumon
