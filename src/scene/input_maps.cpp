#include "scene/input_maps.h"

#include <fmt/format.h>

#include <variant>

#include "base/error.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "files/terrain/on_cells.h"
#include "files/terrain/terrain_file.h"
#include "keys/key_value.h"
#include "scene/scene_keys.h"
#include "scene/trust.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

std::string map_key(std::size_t number, const char* key) {
    return fmt::format("map.{}.{}", number, key);
}

std::size_t count_of_maps(const KeyTable& keys) {
    const TableList* list = keys.find_list("map");
    return list == nullptr ? 0 : list->size();
}

template <class Value>
Value& value_of(const KeyTable& keys, std::size_t number, const char* key) {
    return *std::get<Value*>(keys.find(map_key(number, key))->target);
}

/// A reader's message as it would speak of a map.
std::string of_map(std::string message, std::size_t number) {
    for (const char* key : {"variable", "band", "record"}) {
        const std::string of_bed = fmt::format("bed.{}", key);
        for (std::size_t at = message.find(of_bed); at != std::string::npos;
             at = message.find(of_bed, at + of_bed.size()))
            message.replace(at, of_bed.size(), map_key(number, key));
    }
    return message;
}

/// The unit of what a map gives: that of its quantity, or of the law whose coefficient it is.
std::string unit_of_map(const KeyTable& keys, std::size_t number) {
    const auto unit_of = [&](const std::string& path) {
        return std::string(std::get<ChoiceTarget>(keys.find(path)->target).unit());
    };
    const std::string unit = unit_of(map_key(number, "quantity"));
    return unit.empty() ? unit_of("model.friction") : unit;
}

/// A map's file as it is asked for. Where others named it, what is wrong with it tells nothing of
/// what is in it, nor whether it is there.
Terrain read_map(const Scene& scene, const KeyTable& keys, std::size_t number,
                 const fs::path& file) {
    const std::string key = map_key(number, "file");
    check_named_file(scene, key, value_of<std::string>(keys, number, "file"), file);
    const bool mine = is_own_file(scene, key);
    TerrainQuery query;
    query.variable = value_of<std::string>(keys, number, "variable");
    query.band = value_of<std::int64_t>(keys, number, "band");
    query.record = value_of<std::int64_t>(keys, number, "record");
    query.must_name_record = value_text(*keys.find(map_key(number, "quantity"))) == "\"rain\"";
    query.any_unit = true;
    query.trusted = mine;
    query.wanted_unit = unit_of_map(keys, number);
    try {
        return read_terrain(file, query);
    } catch (const InputError& refusal) {
        if (!mine)
            throw InputError(
                fmt::format("{}{} is not a readable grid", scene.at(key), file.string()));
        throw InputError(scene.at(key) + of_map(refusal.what(), number));
    }
}

}  // namespace

std::vector<InputKey> input_keys(Scene& scene) {
    std::vector<InputKey> named;
    if (bed_kind(scene) == BedKind::file) named.push_back({"bed.file", &scene.bed.file});
    const KeyTable keys = scene_keys(scene);
    for (std::size_t n = 0; n < count_of_maps(keys); ++n)
        named.push_back({map_key(n, "file"), &value_of<std::string>(keys, n, "file")});
    if (!scene.view.look.drape.empty()) named.push_back({"look.drape", &scene.view.look.drape});
    for (std::size_t n = 0; n < scene.view.layers.size(); ++n) {
        LayerSettings& layer = scene.view.layers[n];
        if (layer.data == LayerData::file)
            named.push_back({fmt::format("layer.{}.file", n), &layer.file});
    }
    return named;
}

fs::path input_path(const Scene& scene, const InputKey& key) {
    const fs::path file(*key.file);
    return file.is_absolute() || scene.set_on_command_line(key.path) ? file
                                                                     : scene.directory / file;
}

void name_inputs(Scene& scene, const std::vector<InputFile>& inputs,
                 std::string InputFile::*member) {
    if (inputs.empty()) return;
    const std::vector<InputKey> keys = input_keys(scene);
    for (std::size_t k = 0; k < keys.size() && k < inputs.size(); ++k)
        *keys[k].file = inputs[k].*member;
}

std::vector<InputFile> without_local_paths(std::vector<InputFile> inputs) {
    for (InputFile& input : inputs) {
        const fs::path file(input.path);
        if (!file.is_absolute()) continue;
        const fs::path last = file.has_filename() ? file.filename() : file.parent_path().filename();
        input.path = last.string();
    }
    return inputs;
}

void add_maps(const Scene& scene, InitialBed& initial) {
    Scene named = scene;
    const KeyTable keys = scene_keys(named);
    for (std::size_t n = 0; n < count_of_maps(keys); ++n) {
        const InputKey key{map_key(n, "file"), &value_of<std::string>(keys, n, "file")};
        if (key.file->empty()) {
            throw InputError(scene.at(key.path) + key.path +
                             " is missing; name the file that has the values");
        }
        const fs::path file = input_path(scene, key);
        const Terrain map = read_map(scene, keys, n, file);
        check_limits(scene, static_cast<std::int64_t>(map.heights.size()), 0);
        if (!map.note.empty()) {
            initial.note +=
                fmt::format("{}{}: {}", initial.note.empty() ? "" : "; ", key.path, map.note);
        }
        try {
            Terrain brought =
                on_cells(map, {initial.bed.nx(), initial.bed.ny(), initial.scale.place});
            initial.maps.push_back({std::move(brought.heights), std::move(brought.nodata)});
        } catch (const InputError& refusal) {
            throw InputError(
                fmt::format("{}{}: {}", scene.at(key.path), file.string(), refusal.what()));
        }
        initial.inputs.push_back({file.lexically_normal().string(), hex(grid_hash(file))});
    }
}

}  // namespace fumon
