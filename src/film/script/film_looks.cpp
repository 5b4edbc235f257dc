#include "film/script/film_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "film/script/layer_files.h"
#include "keys/key_value.h"
#include "keys/look_presets.h"
#include "keys/setting.h"
#include "models/registry.h"
#include "scene/check.h"
#include "scene/placed_sun.h"
#include "scene/scene_keys.h"
#include "scene/unknown_keys.h"

namespace fumon {

namespace {

const std::string shots = "shot.";

/// The number of characters of "shot.12." that a path begins with; 0 for a path of the film.
std::size_t shot_prefix(const std::string& path) {
    if (!path.starts_with(shots)) return 0;
    const std::size_t dot = path.find('.', shots.size());
    return dot == std::string::npos ? 0 : dot + 1;
}

std::string section_of(const std::string& path) {
    return path.substr(0, path.find('.'));
}

/// Gives the lists of tables of which settings speak the items that these need, and no others.
void size_lists(Scene& scene, const std::vector<Override>& looks) {
    std::map<std::string, std::size_t> sizes;
    for (const Override& setting : looks) {
        const KeyTable table = scene_keys(scene);
        for (const TableList& list : table.lists()) {
            const std::string begin = list.path + ".";
            if (!setting.path.starts_with(begin)) continue;
            const std::size_t number = std::stoul(setting.path.substr(begin.size()));
            sizes[list.path] = std::max(sizes[list.path], number + 1);
        }
    }
    for (const auto& [path, size] : sizes) {
        const KeyTable table = scene_keys(scene);
        const TableList* list = table.find_list(path);
        list->resize(0);
        list->resize(size);
    }
}

/// Whether a key of the camera is left to the shots.
bool is_of_shots(const std::string& path) {
    constexpr std::array keys{"camera.projection", "camera.framing", "camera.distance",
                              "camera.roll",       "camera.at",      "camera.look_at",
                              "camera.turn"};
    return std::ranges::any_of(keys, [&](const char* key) {
        return path == key || path.starts_with(std::string(key) + ".");
    });
}

/// What of a look a film takes from the run or from its shots alone.
std::string_view why_not(const std::string& path) {
    if (is_of_shots(path))
        return "its shots say where the camera stands, by [[shot]] move, distance, subject and "
               "[[shot.key]]";
    if (path.starts_with("look.drape"))
        return "a drape is one of the run's own files; give it to the run's scene";
    if (path == "look.mode") return "a film shows the view in perspective";
    return {};
}

const Key& look_key(const KeyTable& table, const std::string& path, const std::string& place) {
    const Key* key = table.find(path);
    if (key == nullptr) refuse_unknown_key(path, place, table, "");
    if (const std::string_view reason = why_not(path); !reason.empty())
        throw InputError(
            fmt::format("{}: {} cannot be changed in a film: {}", place, path, reason));
    return *key;
}

/// A value as TOML. Throws InputError for one that no scene could have.
std::string checked_value(const std::string& path, const toml::node& value,
                          const std::string& place, const Locate& locate) {
    Scene scene = default_scene(std::string(terrain_model().name));
    size_lists(scene, {{path, "", place}});
    const KeyTable table = scene_keys(scene);
    if (path == "look.preset" && value.is_string()) {
        const std::string name = value.value_or(std::string());
        apply_look_preset(table, name, locate(value.source()));
    }
    const Key& key = look_key(table, path, place);
    assign(key, value, locate);
    return value_text(key);
}

/// A later setting of a key takes the place of an earlier one. They stand in the order of their
/// paths.
void put(std::vector<Override>& looks, Override setting) {
    std::erase_if(looks, [&](const Override& other) { return other.path == setting.path; });
    const auto place = std::ranges::lower_bound(looks, setting.path, {}, &Override::path);
    looks.insert(place, std::move(setting));
}

/// A film is seen in perspective, and a lens that it names stands in place of the run's: keys of
/// the run that set the same quantity, or belong to a lens which is gone, are not said any more.
void take_lens(const std::set<std::string>& given, CameraSettings& camera) {
    const auto says = [&](const char* key) { return given.contains(key); };
    camera.projection = Projection::perspective;
    if (says("camera.field_of_view") && !says("camera.focal_length"))
        camera.focal_length = WordOrReal{"auto", 0.0};
    if (says("camera.aperture") && !says("camera.f_number"))
        camera.f_number = WordOrReal{"pinhole", 0.0};
    if (says("camera.f_number") && !says("camera.aperture")) camera.aperture = 0.0;
    if (camera.has_lens()) return;
    if (!says("camera.focus")) camera.focus = WordOrReal{"auto", 0.0};
    if (!says("camera.lens_samples")) camera.lens_samples = WordOrReal{"auto", 0.0};
}

/// The settings as sections of a film, each under a header of its own.
std::string sections_of(const std::vector<Override>& looks, const std::string& owner) {
    std::map<std::pair<std::string, std::size_t>, std::string> sections;  // by name and item
    for (const Override& setting : looks) {
        const std::size_t dot = setting.path.rfind('.');
        const std::size_t first = setting.path.find('.');
        const std::size_t item = first == dot ? 0 : std::stoul(setting.path.substr(first + 1)) + 1;
        sections[{section_of(setting.path), item}] +=
            fmt::format("{} = {}\n", setting.path.substr(dot + 1), setting.value);
    }
    std::string text;
    for (const auto& [place, keys] : sections) {
        const std::string name = owner + place.first;
        text += place.second > 0 ? fmt::format("\n[[{}]]\n", name) : fmt::format("\n[{}]\n", name);
        text += keys;
    }
    return text;
}

/// Keys of a look in place of a scene's.
Scene with_looks(Scene scene, const std::vector<Override>& looks, const LayerFiles& found) {
    if (looks.empty()) return scene;
    // What the run's scene says of a look is no longer said.
    std::erase_if(scene.locations, [](const auto& key) { return !look_path(key.first).empty(); });
    size_lists(scene, looks);
    const KeyTable table = scene_keys(scene);
    for (const Override& setting : looks) {
        if (setting.path != "look.preset") continue;
        const Setting read = parse_setting(setting);
        apply_look_preset(table, read.value().value_or(std::string()), setting.place);
    }
    std::set<std::string> given;
    for (const Override& setting : looks) {
        if (setting.path == "look.preset") continue;
        const Setting read = parse_setting(setting);
        assign(look_key(table, setting.path, read.locate_key()), read.value(),
               [&](const auto& region) { return read.locate(region); });
        scene.locations[setting.path] = read.locate(read.value().source());
        given.insert(setting.path);
        if (!names_layer_file(setting)) continue;
        std::string& file = scene.view.layers[std::stoul(setting.path.substr(6))].file;
        if (!file.empty()) file = layer_file(setting, found).string();
    }
    take_lens(given, scene.view.camera);
    SunSettings& sun = scene.view.sun;
    if (given.contains("sun.azimuth") || given.contains("sun.elevation")) {
        if (!given.contains("sun.place")) sun.place.clear();
        if (!given.contains("sun.time")) sun.time.clear();
        if (!given.contains("sun.hours")) sun.hours = 0.0;
    }
    Faults faults(scene.source);
    check_scene(scene, {}, faults);
    faults.report();
    place_sun(sun);
    return scene;
}

}  // namespace

const std::vector<std::string>& film_look_sections() {
    static const std::vector<std::string> sections{"camera",    "look",   "sun",   "air",
                                                   "streamers", "person", "track", "layer"};
    return sections;
}

std::string look_path(const std::string& path) {
    const std::string own = path.substr(shot_prefix(path));
    const std::vector<std::string>& sections = film_look_sections();
    const bool known = std::ranges::find(sections, section_of(own)) != sections.end();
    return known ? own : "";
}

std::vector<Override>& looks_at(Film& film, const std::string& path) {
    if (shot_prefix(path) == 0) return film.looks;
    return film.shots.at(std::stoul(path.substr(shots.size()))).looks;
}

void read_looks(Film& film, const std::string& path, const toml::node& value,
                const std::string& place, const Locate& locate, Faults& faults) {
    if (const toml::table* section = value.as_table()) {
        for (const auto& [name, item] : *section)
            read_looks(film, fmt::format("{}.{}", path, name.str()), item, locate(name.source()),
                       locate, faults);
        return;
    }
    const toml::array* items = value.as_array();
    const bool is_list =
        items != nullptr && !items->empty() && std::ranges::all_of(*items, &toml::node::is_table);
    if (is_list) {
        std::size_t number = 0;
        for (const toml::node& item : *items)
            read_looks(film, fmt::format("{}.{}", path, number++), item, place, locate, faults);
        return;
    }
    faults.attempt([&] {
        const std::string key = look_path(path);
        if (key.find('.') == std::string::npos)
            throw InputError(
                fmt::format("{}: {} is a section; write its keys, such as those that "
                            "`fumon describe {}` lists",
                            place, path, key));
        const std::string at = locate(value.source());
        const std::size_t colon = at.rfind(':');
        put(looks_at(film, path), {key, checked_value(key, value, place, locate),
                                   at.substr(0, colon), std::stoul(at.substr(colon + 1))});
    });
}

void set_look(Film& film, const Override& setting) {
    if (const std::size_t prefix = shot_prefix(setting.path); prefix > 0) {
        const std::size_t number = std::stoul(setting.path.substr(shots.size()));
        if (number >= film.shots.size())
            throw InputError(fmt::format("{}: {}: the film has {} shots, counted from 0",
                                         setting.place, setting.path, film.shots.size()));
    }
    Override own = setting;
    own.path = look_path(setting.path);
    const Setting read = parse_setting(own);
    own.value = checked_value(own.path, read.value(), read.locate_key(),
                              [&](const auto& region) { return read.locate(region); });
    put(looks_at(film, setting.path), std::move(own));
}

std::string with_looks(const std::string& toml, const Film& film) {
    std::istringstream lines(toml);
    std::string text;
    std::string line;
    std::size_t shot = 0;  // how many have begun
    bool within = false;   // the last of them, keys of its own items too
    bool blank = false;    // a line that is not written yet
    const auto end_shot = [&] {
        if (within) text += sections_of(film.shots.at(shot - 1).looks, "shot.");
        within = false;
    };
    while (std::getline(lines, line)) {
        if (line.starts_with("[") && !line.starts_with("[[shot.")) end_shot();
        if (line == "[[shot]]") {
            ++shot;
            within = true;
        }
        if (std::exchange(blank, line.empty())) text += "\n";
        if (!line.empty()) text += line + "\n";
    }
    end_shot();
    return text + sections_of(film.looks, "");
}

std::vector<std::string> coloured_fields(const Film& film) {
    std::vector<std::string> names;
    const auto add = [&](const std::vector<Override>& looks) {
        for (const Override& setting : looks) {
            if (setting.path != "look.field") continue;
            std::string name = plain_text(setting);
            if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
        }
    };
    add(film.looks);
    for (const Shot& shot : film.shots) add(shot.looks);
    for (const Excerpt& excerpt : film.excerpts) {
        if (!excerpt.read) continue;
        add(excerpt.read->looks);
        for (const Shot& shot : excerpt.read->shots) add(shot.looks);
    }
    return names;
}

bool same_looks(const std::vector<Override>& first, const std::vector<Override>& second) {
    return std::ranges::equal(first, second, [](const Override& one, const Override& other) {
        return one.path == other.path && one.value == other.value;
    });
}

Scene with_looks(Scene scene, const Film& film, const std::vector<Override>& looks) {
    return with_looks(with_looks(std::move(scene), film.looks, film.found_layers), looks,
                      film.found_layers);
}

}  // namespace fumon
