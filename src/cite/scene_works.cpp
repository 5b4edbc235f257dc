#include "cite/scene_works.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "keys/key_value.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

constexpr std::string_view finite_volume = "finite-volume";
constexpr std::string_view cip = "cip";

/// Rules of words: `value` is what a key has.
constexpr std::array<CitingRule, 45> rules{{
    {"terada_2024", "sand", "model.order", "\"synchronous\"", "synchronous hops"},
    {"sudo_2002", "sand", "model.order", "\"random-sequential\"", "random sequential hops"},
    {"sudo_2002", "sand", "model.creep", "\"every-cell\"", "creep"},
    {"sudo_2002", "sand", "model.creep", "\"maxima-only\"", "creep"},
    {"sudo_2002", "sand", "model.creep", "\"profile\"", "creep"},
    {"nishimori_ouchi_1993", "sand", "model.hop_length", "\"linear\"", "hop lengths"},
    {"terada_2024", "sand", "model.hop_length", "\"slope\"", "hop lengths"},
    {"terada_2025", "sand", "model.hop_length", "\"exponential\"", "hop lengths"},
    {"terada_2024", "sand", "model.hop_amount", "\"slope\"", "amounts of hops"},
    {"nilles_2024", "dunes", "model.transport", "\"continuous\"", "continuous drift"},
    {"werner_1995", "dunes", "model.transport", "\"slabs\"", "slabs of sand"},
    {"momiji_2000", "dunes", "model.speed_up", "\"height\"", "wind speed-up by height"},
    {"kroy_2002", "dunes", "model.speed_up", "\"relief\"", "shear stress over relief"},
    {"paris_2019", "dunes", "model.wind_bend", "\"contours\"", "wind turned by relief"},
    {"nilles_2024", "dunes", "model.wind_bend", "\"contours\"", "wind turned by relief"},
    {"kroy_2002", "dunes", "model.wind_bend", "\"shear\"", "shear stress across the wind"},
    {"rouy_tourin_1992", "dunes", "", "", "slopes of avalanches"},
    {"baas_2002", "dunes", "model.plants", "\"fixed\"", "plants"},
    {"nield_baas_2008", "dunes", "model.plants", "\"grow\"", "plants that grow"},
    {"baas_2002", "dunes", "model.plants", "\"grow\"", "plants"},
    {"raupach_1993", "dunes", "model.plant_shelter", "\"raupach\"", "plants that slow the wind"},
    {"raupach_1993", "dunes", "model.plant_shelter", "\"okin\"", "plants that slow the wind"},
    {"okin_2008", "dunes", "model.plant_shelter", "\"okin\"", "wind behind plants"},
    {"higashi_takamori_2003", "sandpile", "", "", "the model"},
    {"saeki_okamura_2007", "gully", "", "", "the model"},
    {"terada_2025", "airflow", "", "", "the model"},
    {"horton_1933", "", "model.infiltration", "\"horton\"", "infiltration"},
    {"green_ampt_1911", "", "model.infiltration", "\"green-ampt\"", "infiltration"},
    {"meyer_peter_mueller_1948", "gully", "model.bed_load", "\"meyer-peter-mueller\"", "bed load"},
    {"ashida_michiue_1972", "gully", "model.bed_load", "\"ashida-michiue\"", "bed load"},
    {"partheniades_1965", "gully", "model.entrainment", "\"excess-shear\"", "entrainment"},
    {"ferguson_church_2004", "gully", "model.settling_velocity", "\"auto\"", "settling velocity"},
    {"yabe_aoki_1991", "", "scheme", cip, "CIP advection"},
    {"audusse_2004", "", "scheme", finite_volume, "well-balanced finite volumes"},
    {"chen_noelle_2017", "", "scheme", finite_volume, "reconstruction at steps of the bed"},
    {"toro_2001", "", "scheme", finite_volume, "HLLC fluxes"},
    {"van_leer_1977", "", "scheme", finite_volume, "slope limiter"},
    {"crameri_2021", "", "palette", "\"batlow\"", "colours"},
    {"crameri_2021", "", "palette", "\"lapaz\"", "colours"},
    {"crameri_2021", "", "palette", "\"oslo\"", "colours"},
    {"crameri_2021", "", "palette", "\"vik\"", "colours"},
    {"nunez_2018", "", "palette", "\"cividis\"", "colours"},
    {"hobley_2017", "", "terrain", "west_bijou_gully.asc", "terrain"},
    {"hobley_2017", "", "terrain", "front_range_hill.asc", "terrain"},
    {"farr_2007", "", "terrain", "front_range_hill.asc", "terrain"},
}};

/// The scheme of water that a scene's keys choose, by the rule of start_of_gully(), as far as keys
/// alone tell; empty of other models.
std::string_view scheme_of(const KeyTable& table, const Scene& scene) {
    const Key* key = table.find("model.scheme");
    const bool water = scene.model.name == "water";
    if (key == nullptr || (!water && scene.model.name != "gully")) return {};
    const std::string word = value_text(*key);
    if (word != "\"auto\"") return word == "\"finite-volume\"" ? finite_volume : cip;
    const auto is = [&](const char* path, std::string_view value) {
        return value_text(*table.find(path)) == value;
    };
    const auto none = [&](const char* path) {
        const TableList* list = table.find_list(path);
        return list == nullptr || list->size() == 0;
    };
    const bool from_file = !scene.bed.file.empty();
    const auto is_periodic = [&](const char* edges) {
        return is(edges, "\"periodic\"") || (is(edges, "\"auto\"") && !from_file && none("edge"));
    };
    const bool plane = !water && is_periodic("model.edges_x") && is_periodic("model.edges_y") &&
                       none("map") && is("model.slope_x", "0.0") &&
                       !is("model.friction", "\"manning\"") && !is("model.transport", "\"loads\"");
    return plane ? cip : finite_volume;
}

/// Whether the keys of loads count.
bool is_idle(const CitingRule& rule, const KeyTable& table) {
    const bool of_loads = rule.key == "model.bed_load" || rule.key == "model.entrainment" ||
                          rule.key == "model.settling_velocity";
    if (of_loads) return value_text(*table.find("model.transport")) != "\"loads\"";
    return false;
}

/// Whether speeds or friction velocities give the drift of a wind.
bool has_speeds(const KeyTable& table) {
    return std::ranges::any_of(table.keys(), [](const Key& key) {
        return key.path.starts_with("wind.") &&
               (key.path.ends_with(".speed") || key.path.ends_with(".friction_velocity")) &&
               value_text(key) != "\"none\"";
    });
}

/// Whether something that a scene draws is coloured by that palette.
bool has_palette(const KeyTable& table, std::string_view palette) {
    const bool natural = value_text(*table.find("look.colour_by")) == "\"natural\"";
    return std::ranges::any_of(table.keys(), [&](const Key& key) {
        if (!key.path.ends_with("palette") || (natural && key.path == "look.palette")) return false;
        return value_text(key) == palette;
    });
}

bool holds(const CitingRule& rule, const KeyTable& table, const Scene& scene) {
    if (!rule.model.empty() && rule.model != scene.model.name) return false;
    if (rule.key.empty()) return true;
    if (rule.key == "scheme") return rule.value == scheme_of(table, scene);
    if (rule.key == "palette") return has_palette(table, rule.value);
    if (rule.key == "terrain")
        return rule.value == std::filesystem::path(scene.bed.file).filename().string();
    const Key* key = table.find(std::string(rule.key));
    return key != nullptr && value_text(*key) == rule.value && !is_idle(rule, table);
}

}  // namespace

std::vector<CitingRule> citing_rules() {
    return {rules.begin(), rules.end()};
}

std::vector<CitedWork> works_of(const Scene& scene) {
    Scene read = scene;
    const KeyTable table = scene_keys(read);
    std::vector<CitedWork> cited;
    const auto add = [&](std::string_view id, std::string_view what) {
        const Work& work = work_of(id);
        const auto found = std::ranges::find(cited, &work, &CitedWork::work);
        if (found == cited.end()) {
            cited.push_back({&work, std::string(what)});
        } else if (found->what.find(what) == std::string::npos) {
            found->what += ", ";
            found->what += what;
        }
    };
    for (const CitingRule& rule : rules) {
        if (holds(rule, table, scene)) add(rule.work, rule.what);
    }
    const Key* recovery = table.find("model.infiltration_recovery");
    if (recovery != nullptr && value_text(*recovery) != "0.0")
        add("rossman_huber_2016", "recovery of infiltration");
    const Key* deflection = table.find("model.slope_deflection");
    if (deflection != nullptr && value_text(*deflection) != "0.0")
        add("hersen_2004", "drift down slopes across the wind");
    const bool by_speed = has_speeds(table);
    const bool near_threshold = std::ranges::any_of(table.keys(), [&](const Key& key) {
        if (!key.path.ends_with(".threshold_ratio")) return false;
        const std::string ratio = value_text(key);
        return ratio != "\"none\"" && (by_speed || ratio != "\"auto\"");
    });
    if (near_threshold) add("gadal_2019", "threshold of transport");
    if (by_speed) {
        add("sauermann_2001", "saturated flux");
        add("duran_moore_2013", "saturated flux");
    }
    const Key* wall = table.find("model.wall_angle");
    if (scene.model.name == "dunes" && wall != nullptr && value_text(*wall) != "\"none\"")
        add("tsoar_1983", "walls");
    return cited;
}

}  // namespace fumon
