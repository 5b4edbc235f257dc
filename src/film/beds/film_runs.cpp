#include "film/beds/film_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/error.h"
#include "figure/overlays/overlay_text.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "keys/keys.h"
#include "scene/json.h"
#include "scene/placeholders.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// How many runs the sweep in a folder has; 0 where there is none.
std::size_t runs_of_sweep(const fs::path& folder) {
    std::error_code fault;
    const fs::path manifest = folder / "sweep.json";
    if (!fs::is_regular_file(manifest, fault)) return 0;
    try {
        return parse_json(read_input_file(manifest)).at("runs").size();
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: is damaged; make the sweep again", manifest.string()));
    }
}

/// "model.creep_rate" as one reads it: "creep rate".
std::string key_words(const std::string& key) {
    std::string words = key.substr(key.rfind('.') + 1);
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::optional<double> number_in(const std::string& text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc{} || stop != end) return std::nullopt;
    return number;
}

/// A key's value in a scene, with its unit where that is one word.
std::string value_words(const Scene& scene, const std::string& key) {
    std::string text = key_text(scene, key).value_or("none");
    if (number_in(text) && text.ends_with(".0")) text.resize(text.size() - 2);
    Scene copy = scene;  // the table binds to writable values
    const KeyTable table = scene_keys(copy);
    const Key* found = table.find(key);
    const std::string unit = found == nullptr ? "" : found->notes.unit;
    const bool short_unit = !unit.empty() && unit != "1" && unit.find(' ') == std::string::npos;
    return !short_unit ? text : text + " " + unit;
}

}  // namespace

bool is_run_folder(const fs::path& path) {
    std::error_code fault;
    return fs::is_regular_file(path / "run.json", fault) ||
           fs::is_regular_file(path / "sweep.json", fault);
}

RunArrangement arrangement_of(const Film& film) {
    return film.excerpts.empty() ? RunArrangement::together : RunArrangement::in_turn;
}

FilmRuns::FilmRuns(const std::vector<std::string>& folders, int threads, RunArrangement showing,
                   const ForeignQuery& query) {
    const auto limit = [&](std::size_t runs, const std::string& what) {
        const bool together = showing == RunArrangement::together;
        const std::size_t most = together ? most_panes : std::size_t{most_joined_runs};
        if (runs <= most) return;
        throw InputError(fmt::format("{}; a film shows at most {}", what,
                                     together ? fmt::format("{} (3 x 3) side by side", most)
                                              : fmt::format("{} one after the other", most)));
    };
    limit(folders.size(), fmt::format("{} runs", folders.size()));
    for (const std::string& folder : folders) {
        const std::size_t runs = runs_of_sweep(folder);
        limit(runs, fmt::format("{}: holds {} runs", folder, runs));
        if (runs == 0)
            beds_.push_back(std::make_shared<const StoredBeds>(
                StoredBeds::of_argument(folder, threads, {}, query)));
        for (std::size_t number = 1; number <= runs; ++number)
            beds_.push_back(std::make_shared<const StoredBeds>(
                StoredBeds::of_sweep(folder, static_cast<std::int64_t>(number), threads)));
        limit(beds_.size(), fmt::format("{} runs", beds_.size()));
    }
    if (showing == RunArrangement::in_turn) return;
    check();
    find_varied();
}

FilmRuns::FilmRuns(std::vector<StoredBeds> beds, RunArrangement showing) {
    for (StoredBeds& run : beds)
        beds_.push_back(std::make_shared<const StoredBeds>(std::move(run)));
    if (showing == RunArrangement::in_turn) return;
    check();
    find_varied();
}

FilmRuns FilmRuns::only(std::size_t run) const {
    FilmRuns one;
    one.beds_.push_back(beds_[run]);
    one.find_varied();
    return one;
}

void FilmRuns::check() const {
    const Snapshot& first = beds_.front()->first();
    for (const auto& beds : beds_) {
        const StoredBeds& run = *beds;
        const Snapshot& other = run.first();
        if (other.bed.nx() != first.bed.nx() || other.bed.ny() != first.bed.ny()) {
            throw InputError(
                fmt::format("{}: its bed has {} x {} cells, that of {} {} x {}; runs side by side "
                            "need the same grid",
                            run.name(), other.bed.nx(), other.bed.ny(), beds_.front()->name(),
                            first.bed.nx(), first.bed.ny()));
        }
        if (other.scale.dx != first.scale.dx || other.scale.dy != first.scale.dy) {
            throw InputError(
                fmt::format("{}: its cells are {} x {} large, those of {} {} x {}; runs side by "
                            "side need the same grid",
                            run.name(), other.scale.dx, other.scale.dy, beds_.front()->name(),
                            first.scale.dx, first.scale.dy));
        }
    }
}

void FilmRuns::find_varied() {
    constexpr std::size_t most = 2;
    constexpr std::array roles{KeyRole::run, KeyRole::parameter};
    std::vector<nlohmann::ordered_json> scenes;
    for (const auto& run : beds_) scenes.push_back(scene_json(run->scene(), roles).flatten());
    std::set<std::string> known;
    for (const auto& scene : scenes) {
        for (const auto& [pointer, value] : scene.items()) {
            const bool differs =
                std::ranges::any_of(scenes, [&, &at = pointer, &own = value](const auto& other) {
                    return other.value(at, nlohmann::ordered_json()) != own;
                });
            std::string key = pointer.substr(1);
            std::ranges::replace(key, '/', '.');
            if (differs && known.insert(key).second) varied_.push_back(key);
        }
    }
    // A longer run is not what one compares, unless it is all.
    if (varied_.size() > 1) std::erase(varied_, "run.steps");
    if (varied_.size() > most) varied_.clear();
    // As in a sweep's order: first the key that varies more slowly.
    const auto stays = [&](const std::string& key) {
        return key_text(beds_[0]->scene(), key) == key_text(beds_[1]->scene(), key);
    };
    if (varied_.size() == most && stays(varied_[1])) std::swap(varied_[0], varied_[1]);
}

std::string FilmRuns::label(const Film& film, std::size_t run) const {
    const Scene& scene = beds_[run]->scene();
    if (!film.panes.label.empty()) {
        try {
            return filled_text(film.panes.label, scene, time_text_of(scene, beds_[run]->first()), 0,
                               0.0);
        } catch (const InputError& fault) {
            throw placed(film.at("panes.label"), fault);
        }
    }
    std::string text;
    for (const std::string& key : varied_)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key_words(key),
                            value_words(scene, key));
    return text.empty() ? fs::path(beds_[run]->name()).filename().string() : text;
}

std::vector<double> FilmRuns::values() const {
    std::vector<double> values;
    if (varied_.size() != 1) return values;
    for (const auto& run : beds_) {
        const auto number = number_in(key_text(run->scene(), varied_.front()).value_or(""));
        if (!number) return {};
        values.push_back(*number);
    }
    return values;
}

std::optional<int> FilmRuns::grid_columns() const {
    if (varied_.size() != 2) return std::nullopt;
    std::array<std::set<std::string>, 2> values;
    std::set<std::pair<std::string, std::string>> both;
    for (const auto& run : beds_) {
        const std::string one = key_text(run->scene(), varied_[0]).value_or("");
        const std::string two = key_text(run->scene(), varied_[1]).value_or("");
        values[0].insert(one);
        values[1].insert(two);
        both.emplace(one, two);
    }
    const auto columns = static_cast<int>(values[1].size());
    const bool whole =
        both.size() == beds_.size() && values[0].size() * values[1].size() == beds_.size();
    if (!whole || columns > most_pane_columns || values[0].size() > most_pane_columns)
        return std::nullopt;
    // In the order of a sweep the last key varies fastest: only then do rows have one value each.
    for (std::size_t run = 0; run < beds_.size(); ++run) {
        const std::size_t row = run - run % values[1].size();
        if (key_text(beds_[run]->scene(), varied_[0]) != key_text(beds_[row]->scene(), varied_[0]))
            return std::nullopt;
    }
    return columns;
}

std::size_t FilmRuns::in_step(std::size_t run, std::size_t bed, FilmClock clock) const {
    if (run == 0) return bed;
    const StoredBed& wanted = first().beds()[bed];
    const std::vector<StoredBed>& stored = beds_[run]->beds();
    if (clock == FilmClock::step) {
        const auto found = std::ranges::lower_bound(stored, wanted.step, {}, &StoredBed::step);
        if (found != stored.end() && found->step == wanted.step)
            return static_cast<std::size_t>(found - stored.begin());
        throw InputError(fmt::format(
            "{}: stored no bed of step {}, but {} did; store the same steps in all runs "
            "(output.fields_every), or synchronise the runs by time (shot.clock = \"time\")",
            beds_[run]->name(), wanted.step, beds_.front()->name()));
    }
    const auto after = std::ranges::lower_bound(stored, wanted.time, {}, &StoredBed::time);
    const double spacing = (stored.back().time - stored.front().time) /
                           static_cast<double>(std::max<std::size_t>(1, stored.size() - 1));
    auto nearest = after;
    if (after == stored.end() ||
        (after != stored.begin() && wanted.time - (after - 1)->time <= after->time - wanted.time))
        --nearest;
    if (std::abs(nearest->time - wanted.time) > spacing) {
        throw InputError(
            fmt::format("{}: stored no bed near the time {}, but {} did; run it for as long",
                        beds_[run]->name(), wanted.time, beds_.front()->name()));
    }
    return static_cast<std::size_t>(nearest - stored.begin());
}

RecordPlace FilmRuns::in_step(std::size_t run, const RecordPlace& place, FilmClock clock) const {
    if (run == 0) return place;
    const std::size_t bed = in_step(run, place.bed, clock);
    const std::size_t next = in_step(run, place.next, clock);
    if (clock == FilmClock::step) return {bed, next, place.share};
    const std::vector<StoredBed>& paced = first().beds();
    const double time =
        (1.0 - place.share) * paced[place.bed].time + place.share * paced[place.next].time;
    const std::vector<StoredBed>& stored = beds_[run]->beds();
    const auto after = static_cast<std::size_t>(
        std::ranges::lower_bound(stored, time, {}, &StoredBed::time) - stored.begin());
    if (after == 0) return {0, 0, 0.0};
    if (after == stored.size()) return {after - 1, after - 1, 0.0};
    if (stored[after].time == time) return {after, after, 0.0};
    const double before = stored[after - 1].time;
    return {after - 1, after, (time - before) / (stored[after].time - before)};
}

std::vector<fs::path> FilmRuns::files() const {
    std::vector<fs::path> all;
    for (const auto& run : beds_) {
        const std::vector<fs::path> files = run->files();
        all.insert(all.end(), files.begin(), files.end());
    }
    return all;
}

}  // namespace fumon
