#include "scene/wind_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "files/input_file.h"
#include "keys/key_value.h"
#include "scene/scene_keys.h"
#include "wind/crest_directions.h"
#include "wind/direction.h"
#include "wind/run_drift.h"
#include "wind/sand_flux.h"
#include "wind/wind_rose.h"

namespace fumon {

namespace {

/// A direction of a table: its share of the time, or of the sand where the table gives that, the
/// sand that it moves in a year, and likewise the sand times 1/(1 − (u*t/u*)²), by which relief
/// counts more near the threshold.
struct TableWind {
    double from = 0.0;
    double share = 0.0;
    double sand = 0.0;
    double over_threshold = 0.0;
};

/// u*/u*t of one wind over which relief counts as it does over all winds of a direction.
double threshold_ratio_of(const TableWind& wind) {
    constexpr double largest = 1e3;
    const double counts = wind.over_threshold / wind.sand;
    return std::clamp(std::sqrt(counts / (counts - 1.0)), std::nextafter(1.0, 2.0), largest);
}

/// How the speeds of a table become sand.
struct SpeedLaw {
    SandAndAir with;
    double height = usual_speed_height;  ///< m
};

void add(std::vector<TableWind>& winds, const TableWind& wind) {
    for (TableWind& one : winds) {
        if (one.from != wind.from) continue;
        one.share += wind.share;
        one.sand += wind.sand;
        one.over_threshold += wind.over_threshold;
        return;
    }
    winds.push_back(wind);
}

std::vector<TableWind> winds_of(const WindTable& table, const SpeedLaw& law) {
    std::vector<TableWind> winds;
    for (const SandFlux& flux : table.fluxes)
        add(winds, {opposite(flux.toward), flux.amount, flux.amount, 0.0});
    const double threshold = impact_threshold(law.with);
    for (const WindClass& wind : table.rose) {
        const std::vector<SandFlux> fluxes = saturated_fluxes({wind}, law.with, law.height);
        if (fluxes.empty()) continue;
        const double ratio = friction_velocity_of(wind, law.with, law.height) / threshold;
        const double sand = fluxes.front().amount;
        add(winds, {wind.from, wind.share, sand, sand * ratio * ratio / (ratio * ratio - 1.0)});
    }
    double whole = 0.0;
    for (const TableWind& wind : winds) whole += wind.share;
    for (TableWind& wind : winds) wind.share /= whole;
    return winds;
}

std::string path_of(std::size_t number, const char* key) {
    return fmt::format("wind.{}.{}", number, key);
}

std::filesystem::path file_of(const Scene& scene, const std::string& key,
                              const std::string& written) {
    if (!scene.trusted && !scene.set_on_command_line(key)) {
        throw InputError(
            fmt::format("{}{}: a scene of unknown origin may not read a table of winds; name the "
                        "scene's file directly",
                        scene.at(key), key));
    }
    const std::filesystem::path file(written);
    return file.is_absolute() || scene.set_on_command_line(key) ? file : scene.directory / file;
}

/// A copy of a scene in which the list of winds has another length, the items from `first` on
/// moved behind `count` copies of that one.
class WindList {
  public:
    explicit WindList(Scene& scene) : scene_(scene), table_(scene_keys(scene)) {}

    [[nodiscard]] std::size_t size() const {
        const TableList* list = table_.find_list("wind");
        return list == nullptr ? 0 : list->size();
    }
    [[nodiscard]] const std::string& text(std::size_t number, const char* key) const {
        return *std::get<std::string*>(table_.find(path_of(number, key))->target);
    }
    double& real(std::size_t number, const char* key) {
        return *std::get<double*>(table_.find(path_of(number, key))->target);
    }
    WordOrReal& word_or_real(std::size_t number, const char* key) {
        return *std::get<WordOrRealTarget>(table_.find(path_of(number, key))->target).value;
    }
    /// A number of the model.
    [[nodiscard]] double of_model(const char* key) const {
        return *std::get<double*>(table_.find(key)->target);
    }
    [[nodiscard]] bool has_threshold() const {
        const auto chosen = [&](const char* key) {
            return std::get<ChoiceTarget>(table_.find(key)->target).word();
        };
        return chosen("model.transport") == "continuous" && chosen("model.speed_up") == "relief";
    }
    void clear_text(std::size_t number, const char* key) {
        std::get<std::string*>(table_.find(path_of(number, key))->target)->clear();
    }
    /// Makes `count` of one wind.
    void repeat(std::size_t number, std::size_t count) {
        const std::size_t previous = size();
        table_.find_list("wind")->resize(previous + count - 1);
        table_ = scene_keys(scene_);
        for (std::size_t n = previous; n-- > number;) copy(n, n + count - 1);
        for (std::size_t k = 1; k + 1 < count; ++k) copy(number + count - 1, number + k);
        if (count > 1) copy(number + count - 1, number);
    }

  private:
    void copy(std::size_t from, std::size_t to) {
        if (from == to) return;
        const std::string begin = fmt::format("wind.{}.", from);
        for (const Key& key : table_.keys()) {
            if (!key.path.starts_with(begin)) continue;
            copy_value(key,
                       *table_.find(fmt::format("wind.{}.{}", to, key.path.substr(begin.size()))));
        }
    }

    Scene& scene_;
    KeyTable table_;
};

void check_no_speed(const Scene& scene, WindList& list, std::size_t number) {
    for (const char* key : {"speed", "friction_velocity"}) {
        if (list.word_or_real(number, key).is_word()) continue;
        const std::string path = path_of(number, key);
        throw InputError(fmt::format("{}{}: the table {} gives the winds; leave {} out",
                                     scene.at(path), path, list.text(number, "table"), key));
    }
}

SpeedLaw law_of(const Scene& scene, WindList& list, std::size_t number) {
    SpeedLaw law;
    law.with.grain_diameter = list.of_model("model.grain_diameter") * metres_per_millimetre;
    law.with.roughness = list.of_model("model.roughness");
    law.height = list.real(number, "speed_height");
    if (law.height > law.with.roughness) return law;
    const std::string path = path_of(number, "speed_height");
    throw InputError(fmt::format(
        "{}{}: speeds {:g} m above the ground lie within model.roughness = {:g} m; write the "
        "height of the anemometer",
        scene.at(path), path, law.height, law.with.roughness));
}

}  // namespace

void read_wind_tables(Scene& scene) {
    WindList list(scene);
    for (std::size_t n = 0; n < list.size(); ++n) {
        const std::string written = list.text(n, "table");
        if (written.empty()) continue;
        const std::string key = path_of(n, "table");
        const std::filesystem::path file = file_of(scene, key, written);
        check_no_speed(scene, list, n);
        const SpeedLaw law = law_of(scene, list, n);
        std::vector<TableWind> winds;
        WindTable table;
        try {
            const std::string text = read_input_file(file);
            table = read_wind_table({file.string(), text});
            winds = winds_of(table, law);
        } catch (const InputError& fault) {
            throw InputError(scene.at(key) + fault.what());
        }
        if (winds.empty())
            throw InputError(fmt::format("{}{}: no wind of {} is strong enough to move sand",
                                         scene.at(key), key, file.string()));
        if (list.size() + winds.size() > most_tables)
            throw InputError(fmt::format("{}{}: {} has {} directions, more than a run takes",
                                         scene.at(key), key, file.string(), winds.size()));
        const double strength = list.real(n, "strength");
        const double duration = list.real(n, "duration");
        const double flux = list.of_model("model.flux");
        const bool by_speed = !table.rose.empty() && list.has_threshold() &&
                              list.word_or_real(n, "threshold_ratio").word == "auto";
        list.clear_text(n, "table");
        list.repeat(n, winds.size());
        for (const TableWind& wind : winds) {
            constexpr double strongest = 100.0;
            if (table.fluxes.empty() && strength * wind.sand / (flux * wind.share) > strongest)
                throw InputError(fmt::format(
                    "{}{}: the wind from {:g} degrees moves {:.4g} m2 a year while it blows, more "
                    "than a hundred times model.flux = {:g}; raise model.flux",
                    scene.at(key), key, wind.from, wind.sand / wind.share, flux));
            list.real(n, "from") = wind.from;
            list.real(n, "duration") = duration * wind.share;
            list.real(n, "strength") =
                table.rose.empty() ? strength : strength * wind.sand / (flux * wind.share);
            if (by_speed) list.word_or_real(n, "threshold_ratio") = threshold_ratio_of(wind);
            ++n;
        }
        --n;
    }
}

std::string winds_line(const Snapshot& first) {
    if (first.winds.empty()) return "";
    const Drift drift = drift_of(fluxes_of(first.winds));
    if (drift.potential == 0.0)
        return "winds move no sand: none is above the threshold of transport";
    if (std::isnan(drift.toward))
        return fmt::format("winds move {:.4g} m2 of sand a year, and none on balance",
                           drift.potential);
    return fmt::format(
        "winds move {:.4g} m2 of sand a year, on balance {:.4g} toward {:.1f} degrees (RDP/DP "
        "{:.3f})",
        drift.potential, drift.resultant, drift.toward, drift.resultant / drift.potential);
}

}  // namespace fumon
