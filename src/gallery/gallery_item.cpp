#include "gallery/gallery_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "figure/canvas/figure_metadata.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "foreign/open_run.h"
#include "gallery/description.h"
#include "gallery/gallery_plots.h"
#include "keys/key_value.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "picture/movie.h"
#include "picture/stills/picture_file.h"
#include "scene/read.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;

constexpr std::array<std::string_view, 4> with_sidecars{".webp", ".gif", ".apng", ".webm"};

constexpr std::array<std::string_view, 4> results_endings{".nc", ".nc4", ".cdf", ".sww"};

fs::path sidecar(const fs::path& file) {
    return file.string() + ".json";
}

bool is_file(const fs::path& path) {
    std::error_code fault;
    return fs::is_regular_file(path, fault);
}

Texts texts_of_sidecar(const fs::path& file) {
    Texts texts;
    try {
        const auto json = parse_json(read_input_file(sidecar(file)));
        for (const auto& [keyword, text] : json.items())
            if (text.is_string()) texts[keyword] = text;
    } catch (const nlohmann::json::exception&) {
        texts.clear();
    }
    return texts;
}

/// The texts that a file of fumon's carries; empty where it is none.
Texts texts_of(const fs::path& file) {
    const std::string ending = small_ending(file);
    if (std::ranges::find(with_sidecars, ending) != with_sidecars.end() && is_file(sidecar(file)))
        return texts_of_sidecar(file);
    if (!is_made_by_fumon(file)) return {};
    PictureText texts;
    if (std::ranges::find(pixel_endings, ending) != pixel_endings.end())
        texts = read_picture_texts(file);
    if (ending == ".mp4") texts = read_movie_texts(file);
    if (ending == ".svg") texts = read_figure_metadata(read_input_file(file), file.string());
    return {texts.begin(), texts.end()};
}

bool decides_the_run(KeyRole role) {
    return role == KeyRole::run || role == KeyRole::parameter;
}

std::vector<GalleryParameter> parameters_of(Scene& scene) {
    std::vector<GalleryParameter> parameters;
    const KeyTable table = scene_keys(scene);
    for (const Key& key : table.keys()) {
        if (!decides_the_run(key.role)) continue;
        const std::string value = value_text(key);
        if (value == "\"\"" || value == "[]") continue;
        const bool pure = key.notes.unit == "1";
        parameters.push_back({key.path, value, pure ? "" : key.notes.unit, key.notes.help});
    }
    return parameters;
}

std::string described(const std::string& kind, const Scene& scene, const std::string& step) {
    if (kind == "film" || (kind == "run" && step.empty())) return described_film(scene);
    return kind == "figure" ? described_figure(scene) : described_picture(scene, step);
}

/// What an item tells of the scene that its file was made from, which was written with every key.
void describe_scene(GalleryItem& item, const std::string& text, const std::string& source,
                    const std::string& step) {
    try {
        SceneText written{text, source, ""};
        written.trusted = false;  // nothing is run
        Scene scene = parse_scene(written, {});
        item.parameters = parameters_of(scene);
        item.description = described(item.kind, scene, step) + ": " + item.title;
    } catch (const InputError&) {
        item.parameters.clear();  // of a version whose scenes this one does not read
    }
}

/// The paragraphs of the caption beside a figure, if fumon wrote it.
std::vector<std::string> caption_of(const fs::path& file) {
    std::vector<std::string> paragraphs;
    if (!is_file(file) || !is_made_by_fumon(file)) return paragraphs;
    const std::string text = read_input_file(file);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find("\n\n", begin), text.size());
        std::string paragraph = text.substr(begin, end - begin);
        while (paragraph.ends_with('\n')) paragraph.pop_back();
        std::ranges::replace(paragraph, '\n', ' ');
        if (!paragraph.empty()) paragraphs.push_back(std::move(paragraph));
        begin = end + 2;
    }
    return paragraphs;
}

/// The items so far, with names that are not taken twice.
class Gathering {
  public:
    void add_path(const fs::path& path) {
        std::error_code fault;
        const std::size_t before = items_.size();
        if (fs::is_directory(path, fault)) {
            add_folder(path, 0);
        } else if (is_file(path)) {
            add_file(path);
        } else {
            throw InputError(fmt::format("{}: there is no such file or folder", path.string()));
        }
        if (items_.size() == before) {
            if (!faults_.empty()) throw InputError(faults_.back());
            throw InputError(
                fmt::format("{}: holds no run, picture or film that fumon made", path.string()));
        }
    }
    std::vector<GalleryItem> take() { return std::move(items_); }
    std::vector<std::string> take_faults() { return std::move(faults_); }

  private:
    static constexpr int deepest = 4;

    std::string free_name(const std::string& wanted) {
        std::string name;
        for (const char letter : wanted) {
            const bool plain = (letter >= 'a' && letter <= 'z') ||
                               (letter >= 'A' && letter <= 'Z') ||
                               (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
            name += plain ? letter : '-';
        }
        if (name.empty()) name = "item";
        std::string tried = name;
        for (int number = 2; !names_.insert(tried).second; ++number)
            tried = fmt::format("{}-{}", name, number);
        return tried;
    }

    /// Whether a file holds the beds of a run that a figure or a sweep keeps beside it.
    static bool is_stored_for_others(const fs::path& file) {
        constexpr std::string_view of_sweep = "-fields.nc";
        const std::string name = file.filename().string();
        if (name == "fields.nc") return is_file(file.parent_path() / "job.json");
        if (!name.ends_with(of_sweep)) return false;
        const std::string run = name.substr(0, name.size() - of_sweep.size());
        return is_file(file.parent_path() / (run + ".json"));
    }

    void add_folder(const fs::path& folder, int depth) {
        if (is_file(folder / "run.json")) {
            add_run(folder);
            return;
        }
        std::vector<fs::path> inside;
        for (const auto& entry : fs::directory_iterator(folder)) inside.push_back(entry.path());
        std::ranges::sort(inside);
        for (const fs::path& path : inside) {
            std::error_code fault;
            if (path.filename().string().starts_with(".") || fs::is_symlink(path, fault)) continue;
            if (fs::is_directory(path, fault)) {
                // A gallery holds copies of what is gathered.
                if (depth < deepest && !is_file(path / "gallery.css")) add_folder(path, depth + 1);
            } else if (is_file(path) && !is_stored_for_others(path)) {
                add_file(path);
            }
        }
    }

    void add_file(const fs::path& file) {
        const Texts texts = texts_of(file);
        if (texts.empty()) {
            if (std::ranges::find(results_endings, small_ending(file)) != results_endings.end())
                add_results(file);
            return;
        }
        const auto text = [&](const char* keyword) {
            const auto found = texts.find(keyword);
            return found == texts.end() ? std::string() : found->second;
        };
        const std::string ending = small_ending(file);
        const std::string scene = text("fumon:scene");
        const bool is_film = !text("fumon:film").empty();
        const bool is_figure = scene.empty() || !text("fumon:figure").empty();
        const std::string kind =
            is_film || ending == ".mp4" ? "film" : (is_figure ? "figure" : "picture");
        fs::path stem = file;
        stem.replace_extension();
        const auto [same, is_new] = of_stems_.try_emplace({stem, kind}, items_.size());
        if (!is_new) {
            add_another(items_[same->second], file, is_film);
            return;
        }
        GalleryItem item;
        item.name = free_name(stem.filename().string());
        item.kind = kind;
        item.title = text("Title").empty() ? stem.filename().string() : text("Title");
        item.description = item.title;
        if (!scene.empty()) describe_scene(item, scene, file.string(), text("fumon:step"));
        const std::string shown = "files/" + item.name + ending;
        add_another(item, file, is_film);
        if (is_film) {
            const bool has_sidecar = item.files.size() > 1;
            item.again = {fmt::format("fumon run files/{}.toml -o out/{}", item.name, item.name),
                          fmt::format("fumon film out/{} {}", item.name,
                                      has_sidecar ? shown + ".json" : shown)};
            item.files.push_back({item.name + ".toml", {}, scene});
            add_companion(item, stem, ".srt");
        } else {
            item.again = {"fumon again " + shown};
        }
        if (kind == "figure") {
            const fs::path page = stem.string() + ".pdf";
            if (is_file(page) && is_made_by_fumon(page)) add_companion(item, stem, ".pdf");
            item.caption = caption_of(stem.string() + ".caption.txt");
            if (!item.caption.empty()) add_companion(item, stem, ".caption.txt");
        }
        items_.push_back(std::move(item));
    }

    /// Adds a file to an item, with the sidecar of a film that cannot hold its texts.
    static void add_another(GalleryItem& item, const fs::path& file, bool is_film) {
        const std::string ending = small_ending(file);
        const std::string name = item.name + ending;
        const auto is_there = [&](const GalleryFile& other) { return other.name == name; };
        if (std::ranges::any_of(item.files, is_there)) return;  // gathered twice
        item.files.push_back({name, file});
        if (is_film && ending != ".mp4" && ending != ".png")
            item.files.push_back({item.name + ending + ".json", sidecar(file)});
    }

    static void add_companion(GalleryItem& item, const fs::path& stem, const char* ending) {
        const fs::path file = stem.string() + ending;
        if (is_file(file)) item.files.push_back({item.name + ending, file});
    }

    static void add_plots(GalleryItem& item, std::vector<MeasurementPlot> plots) {
        for (MeasurementPlot& plot : plots)
            item.plots.push_back({fmt::format("{}-plot-{}.svg", item.name, item.plots.size() + 1),
                                  {},
                                  std::move(plot.svg),
                                  std::move(plot.description)});
    }

    /// Of a NetCDF file.
    void add_results(const fs::path& file) {
        GalleryItem item;
        std::vector<MeasurementPlot> plots;
        try {
            const ForeignRun results = open_foreign_run(file.string());
            item.title = results.title;
            plots = series_plots(time_series(results), results.times);
            const std::string recognised = foreign_description(results);
            for (std::size_t begin = 0; begin < recognised.size();) {
                const std::size_t end = std::min(recognised.find('\n', begin), recognised.size());
                item.caption.push_back(recognised.substr(begin, end - begin));
                begin = end + 1;
            }
            item.again = {fmt::format("fumon still {} --step {} -o {}.png",
                                      file.filename().string(), results.times.steps.back(),
                                      file.stem().string())};
        } catch (const InputError& fault) {
            faults_.emplace_back(fault.what());
            return;
        }
        item.name = free_name(file.stem().string());
        item.kind = "run";
        item.description = "The last record of " + item.title;
        item.run = file;
        GalleryFile picture{item.name + ".png", {}};
        picture.results = file;
        item.files.push_back(std::move(picture));
        add_plots(item, std::move(plots));
        items_.push_back(std::move(item));
    }

    void add_run(const fs::path& folder) {
        GalleryItem item;
        item.name = free_name(folder.filename().empty() ? folder.parent_path().filename().string()
                                                        : folder.filename().string());
        item.kind = "run";
        item.run = folder;
        item.title = item.name;
        item.description = item.title;
        const fs::path movie = folder / "movie.mp4";
        std::optional<fs::path> shown;
        if (is_file(movie)) {
            shown = movie;
        } else if (std::error_code fault; fs::is_directory(folder / "frames", fault)) {
            for (const auto& entry : fs::directory_iterator(folder / "frames"))
                if (entry.path().extension() == ".png" && (!shown || entry.path() > *shown))
                    shown = entry.path();
        }
        if (shown) {
            const Texts texts = texts_of(*shown);
            const auto found = texts.find("fumon:scene");
            if (const auto title = texts.find("Title"); title != texts.end())
                item.title = title->second;
            item.files.push_back({item.name + small_ending(*shown), *shown});
            if (found != texts.end()) {
                const auto step = texts.find("fumon:step");
                describe_scene(item, found->second, folder.string(),
                               step == texts.end() ? "" : step->second);
                item.files.push_back({item.name + ".toml", {}, found->second});
                item.again = {
                    fmt::format("fumon run files/{}.toml -o out/{}", item.name, item.name)};
            }
        }
        if (is_file(folder / "measurements.csv")) {
            add_plots(item, measurement_plots(folder / "measurements.csv"));
            item.files.push_back({item.name + ".csv", folder / "measurements.csv"});
        }
        if (item.files.empty()) return;
        items_.push_back(std::move(item));
    }

    std::vector<GalleryItem> items_;
    std::vector<std::string> faults_;
    std::set<std::string> names_{"cards", "paging", "before", "close", "after"};  // are the page's
    std::map<std::pair<fs::path, std::string>, std::size_t> of_stems_;            ///< and of kinds
};

}  // namespace

std::vector<GalleryItem> gallery_items(const std::vector<fs::path>& from,
                                       std::vector<std::string>& faults) {
    Gathering gathering;
    for (const fs::path& path : from) gathering.add_path(path);
    faults = gathering.take_faults();
    return gathering.take();
}

}  // namespace fumon
