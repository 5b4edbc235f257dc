#include "drape/lay_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "drape/area_drape.h"
#include "drape/gauge_places.h"
#include "drape/layer_places.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "scene/input_maps.h"
#include "scene/trust.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr long long most_points_of_others = 1'000'000;

std::string layer_key(std::size_t number, std::string_view name) {
    return fmt::format("layer.{}.{}", number, name);
}

/// One line on coordinates that are taken for the bed's, or empty.
std::string how_taken(std::size_t number, const LayerSettings& settings, const VectorLayer& layer,
                      const BedCells& bed) {
    if (!bed.place) {
        return "[[layer]]: the bed has no place: coordinates of layers are taken for lengths from "
               "its south-western corner";
    }
    if (system_of(*bed.place).empty()) {
        return "[[layer]]: the bed names no reference system: coordinates of layers are taken for "
               "its own";
    }
    if (layer.crs.empty()) {
        return fmt::format(
            "{}: {} names no reference system: its coordinates are taken for the bed's",
            layer_key(number, "file"), settings.file);
    }
    return {};
}

void add_note(InitialBed& initial, const std::string& note) {
    if (initial.note.find(note) == std::string::npos)
        initial.note += (initial.note.empty() ? "" : "; ") + note;
}

PlacedLayer read_placed(const Scene& scene, std::size_t number, const fs::path& file,
                        InitialBed& initial) {
    const LayerSettings& settings = scene.view.layers[number];
    const std::string file_key = layer_key(number, "file");
    const bool mine = is_own_file(scene, file_key);
    const auto refuse = [&](const std::string& place, const std::string& what) {
        throw InputError(scene.at(place) + file.string() +
                         (mine ? ": " + what : " is not a readable layer; --trust gives details"));
    };
    try {
        VectorQuery query;
        query.name = settings.name;
        query.where = settings.where;
        query.label = settings.label;
        query.trusted = mine;
        if (!mine) query.most_points = most_points_of_others;
        const VectorLayer layer = read_vector_layer(file, query);
        const BedCells bed{initial.bed.nx(), initial.bed.ny(), initial.scale.place};
        PlacedLayer placed = placed_layer(layer, bed, {initial.scale.dx, initial.scale.dy});
        if (layer.features.empty() && !settings.where.empty())
            throw KeyError("where", fmt::format("has nothing for which {}", settings.where));
        if (layer.features.empty()) throw InputError("holds no lines, points or areas");
        if (placed.features.empty()) {
            throw InputError(
                "lies beside the bed; name a file of the bed's place, or mend its reference "
                "system (ogr2ogr -a_srs)");
        }
        add_note(initial, how_taken(number, settings, layer, bed));
        return placed;
    } catch (const KeyError& refusal) {
        const std::string place = layer_key(number, refusal.key());
        refuse(scene.at(place).empty() ? file_key : place, refusal.what());
    } catch (const InputError& refusal) {
        refuse(file_key, refusal.what());
    }
    return {};
}

}  // namespace

void lay_layers(Scene& scene, InitialBed& initial) {
    scene.view.placed_layers.reset();
    if (scene.view.layers.empty()) return;
    if (initial.bed.ny() < 2) {
        throw InputError(scene.at(scene.view.layers.front().data == LayerData::file
                                      ? "layer.0.file"
                                      : "layer.0.data") +
                         "[[layer]] lies over beds of several rows, and this one is a profile; "
                         "leave it out");
    }
    const std::vector<InputKey> keys = input_keys(scene);
    const auto files = static_cast<std::size_t>(std::ranges::count(
        scene.view.layers, LayerData::file, [](const LayerSettings& layer) { return layer.data; }));
    std::size_t next = keys.size() - files;
    PlacedLayers placed;
    for (std::size_t n = 0; n < scene.view.layers.size(); ++n) {
        const LayerSettings& layer = scene.view.layers[n];
        if (layer.data != LayerData::file) {
            placed.layers.push_back(layer.data == LayerData::gauges
                                        ? placed_gauges(scene, layer, initial)
                                        : PlacedLayer{});
            continue;
        }
        const std::size_t number = next++;
        const InputKey& input = keys[number];
        const fs::path file = input_path(scene, input);
        check_named_file(scene, input.path, *input.file, file);
        placed.layers.push_back(read_placed(scene, n, file, initial));
        if (initial.inputs.size() <= number)
            initial.inputs.push_back({file.lexically_normal().string(), hex(grid_hash(file))});
    }
    std::vector<FilledAreas> areas;
    for (std::size_t n = 0; n < placed.layers.size(); ++n) {
        const LayerSettings& layer = scene.view.layers[n];
        const auto colour = layer_colour(layer.fill.empty() ? layer.colour : layer.fill);
        if (colour) areas.push_back({&placed.layers[n], *colour, layer.fill_opacity});
    }
    placed.areas = with_areas(scene.view.drape, scene.view.look.drape_strength, areas,
                              {initial.bed.nx(), initial.bed.ny(), initial.scale.place});
    scene.view.placed_layers = std::make_shared<const PlacedLayers>(std::move(placed));
}

}  // namespace fumon
