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
    if (!says_that_fumon_made_it(file)) return {};
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

/// The parameters of a scene that was written with every key.
std::vector<GalleryParameter> parameters_of(const std::string& text, const std::string& source) {
    std::vector<GalleryParameter> parameters;
    try {
        SceneText written{text, source, ""};
        written.trusted = false;  // nothing is run
        Scene scene = parse_scene(written, {});
        const KeyTable table = scene_keys(scene);
        for (const Key& key : table.keys()) {
            if (!decides_the_run(key.role)) continue;
            const std::string value = value_text(key);
            if (value == "\"\"" || value == "[]") continue;
            const bool pure = key.notes.unit == "1";
            parameters.push_back({key.path, value, pure ? "" : key.notes.unit, key.notes.help});
        }
    } catch (const InputError&) {
        parameters.clear();  // of a version whose scenes this one does not read
    }
    return parameters;
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
            throw InputError(
                fmt::format("{}: holds no run, picture or film that fumon made", path.string()));
        }
    }
    std::vector<GalleryItem> take() { return std::move(items_); }

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
            } else if (is_file(path)) {
                add_file(path);
            }
        }
    }

    void add_file(const fs::path& file) {
        const Texts texts = texts_of(file);
        if (texts.empty()) return;
        const auto text = [&](const char* keyword) {
            const auto found = texts.find(keyword);
            return found == texts.end() ? std::string() : found->second;
        };
        GalleryItem item;
        item.name = free_name(file.stem().string());
        const std::string ending = small_ending(file);
        const std::string shown = "files/" + item.name + ending;
        item.title = text("Title").empty() ? file.stem().string() : text("Title");
        item.files.push_back({item.name + ending, file});
        const std::string scene = text("fumon:scene");
        if (!text("fumon:film").empty()) {
            item.kind = "film";
            const std::string film_file =
                ending == ".mp4" || ending == ".png" ? shown : shown + ".json";
            if (film_file != shown)
                item.files.push_back({item.name + ending + ".json", sidecar(file)});
            item.again = {fmt::format("fumon run files/{}.toml -o out/{}", item.name, item.name),
                          fmt::format("fumon film out/{} {}", item.name, film_file)};
            item.files.push_back({item.name + ".toml", {}, scene});
            fs::path captions = file;
            captions.replace_extension(".srt");
            if (is_file(captions)) item.files.push_back({item.name + ".srt", captions});
        } else {
            item.kind = ending == ".mp4" ? "film" : scene.empty() ? "figure" : "picture";
            item.again = {"fumon again " + shown};
        }
        if (!scene.empty()) item.parameters = parameters_of(scene, file.string());
        items_.push_back(std::move(item));
    }

    void add_run(const fs::path& folder) {
        GalleryItem item;
        item.name = free_name(folder.filename().empty() ? folder.parent_path().filename().string()
                                                        : folder.filename().string());
        item.kind = "run";
        item.title = item.name;
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
                item.parameters = parameters_of(found->second, folder.string());
                item.files.push_back({item.name + ".toml", {}, found->second});
                item.again = {
                    fmt::format("fumon run files/{}.toml -o out/{}", item.name, item.name)};
            }
        }
        if (is_file(folder / "measurements.csv")) {
            int number = 0;
            for (const std::string& plot : measurement_plots(folder / "measurements.csv"))
                item.plots.push_back(
                    {fmt::format("{}-plot-{}.svg", item.name, ++number), {}, plot});
            item.files.push_back({item.name + ".csv", folder / "measurements.csv"});
        }
        if (item.files.empty()) return;
        items_.push_back(std::move(item));
    }

    std::vector<GalleryItem> items_;
    std::set<std::string> names_;
};

}  // namespace

std::vector<GalleryItem> gallery_items(const std::vector<fs::path>& from) {
    Gathering gathering;
    for (const fs::path& path : from) gathering.add_path(path);
    return gathering.take();
}

}  // namespace fumon
