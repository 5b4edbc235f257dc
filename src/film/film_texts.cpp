#include "film/film_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "film/beds/results_text.h"
#include "outputs/output_claims.h"
#include "picture/exr.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "run/inputs/find_input.h"
#include "run/picture_text.h"
#include "scene/input_maps.h"
#include "scene/json.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

FilmTexts texts_of_json(const fs::path& file) {
    FilmTexts texts;
    try {
        const Json json = parse_json(read_input_file(file));
        for (const auto& [keyword, text] : json.items())
            if (text.is_string()) texts[keyword] = text;
    } catch (const nlohmann::json::exception&) {
        texts.clear();
    }
    return texts;
}

std::string text_of(const FilmTexts& texts, const char* keyword) {
    const auto found = texts.find(keyword);
    return found == texts.end() ? "" : found->second;
}

Json json_of(const std::vector<InputFile>& inputs) {
    Json list = Json::array();
    for (const InputFile& input : inputs)
        list.push_back({{"path", input.path}, {"sha256", input.hash}});
    return list;
}

std::vector<InputFile> inputs_of(const Json& list) {
    std::vector<InputFile> inputs;
    for (const auto& input : list) inputs.push_back({input.at("path"), input.at("sha256")});
    return inputs;
}

}  // namespace

fs::path sidecar_of(const fs::path& file) {
    return file.string() + ".json";
}

FilmTexts read_film_texts(const fs::path& file) {
    constexpr std::size_t signature = 4;
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) return {};
    if (small_ending(file) == ".json") return texts_of_json(file);
    if (fs::is_regular_file(sidecar_of(file), fault)) return texts_of_json(sidecar_of(file));
    PictureText texts;
    if (is_movie(file)) {
        texts = read_movie_texts(file);
    } else if (start_of_input_file(file, signature) == "\x89PNG") {
        texts = read_png_texts(file);
    } else if (is_exr(start_of_input_file(file, signature))) {
        texts = read_exr_texts(file);
    }
    return {texts.begin(), texts.end()};
}

std::string filmed_runs_text(const FilmRuns& runs) {
    Json list = Json::array();
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const StoredBeds& beds = runs.beds(run);
        list.push_back({{"name", fs::path(beds.name()).filename().string()},
                        {"scene", resolved_scene(beds.scene(), beds.inputs())},
                        {"inputs", json_of(without_local_paths(beds.inputs()))}});
        if (const std::optional<ForeignQuery>& query = beds.foreign_query())
            list.back()["foreign"] = json_of_query(*query);
    }
    return json_text(list);
}

std::vector<FilmedRun> filmed_runs(const FilmTexts& texts, const std::string& film) {
    std::vector<FilmedRun> runs;
    try {
        for (const auto& item : parse_json(text_of(texts, runs_keyword))) {
            FilmedRun run{item.at("name"), item.at("scene"), inputs_of(item.at("inputs")),
                          text_of(texts, version_keyword)};
            if (item.contains("foreign")) run.foreign = query_of_json(item.at("foreign"));
            runs.push_back(std::move(run));
        }
    } catch (const nlohmann::json::exception&) {
        runs.clear();
    }
    if (!runs.empty() && runs.size() <= std::size_t{most_joined_runs}) return runs;
    const bool is_light = small_ending(film) == exr_ending.front();
    throw InputError(fmt::format(
        "{}: does not name the runs that it was cut from; `fumon film RUN {}{}` makes "
        "{} again from a run's folder",
        film, film, is_light ? " -o light_%05d.exr" : "", is_light ? "all frames" : "it"));
}

std::string filmed_layers_text(const std::vector<LayerRecord>& layers) {
    Json list = Json::array();
    for (const LayerRecord& layer : layers) {
        list.push_back(
            {{"path", layer.input.path}, {"sha256", layer.input.hash}, {"key", layer.key}});
        if (!layer.from.empty()) list.back()["from"] = layer.from;
    }
    return json_text(list);
}

std::vector<LayerRecord> filmed_layers(const FilmTexts& texts) {
    const std::string text = text_of(texts, layers_keyword);
    std::vector<LayerRecord> layers;
    try {
        if (text.empty()) return {};
        for (const auto& item : parse_json(text))
            layers.push_back({item.value("key", std::string()),
                              {item.at("path"), item.at("sha256")},
                              item.value("from", std::string())});
    } catch (const nlohmann::json::exception&) {
        layers.clear();
    }
    return layers;
}

LayerFiles found_layers(Film film, const std::vector<LayerRecord>& layers, const fs::path& file) {
    LayerFiles found;
    for_each_layer(film, [&](const std::string& key, const Override& setting) {
        if (is_given_now(setting)) return;
        const std::string written = plain_text(setting);
        const auto record = std::ranges::find_if(layers, [&](const LayerRecord& layer) {
            return layer.key.empty() ? layer.input.path == written : layer.key == key;
        });
        if (record == layers.end()) return;
        const auto find = [&](const std::string& path) {
            found[key] = {find_input({path, record->input.hash}, file, "film").string(),
                          record->from};
        };
        if (!record->from.empty()) {
            try {
                return find(record->from);
            } catch (const InputError&) {  // it may lie where the film says
            }
        }
        find(record->input.path);
    });
    return found;
}

std::int64_t most_bytes_of(const FilmTexts& texts) {
    const std::string text = text_of(texts, most_bytes_keyword);
    std::int64_t bytes = 0;
    std::from_chars(text.data(), text.data() + text.size(), bytes);
    return bytes;
}

std::string why_films_differ(const FilmTexts& then, const fs::path& made) {
    const FilmTexts now = read_film_texts(made);
    std::string text;
    for (const auto& [keyword, what] :
         {std::pair{version_keyword, "fumon"}, std::pair{"fumon:encoder", "encoder"},
          std::pair{"fumon:environment", "what drew it"}}) {
        const std::string was = text_of(then, keyword);
        const std::string is = text_of(now, keyword);
        if (was != is)
            text += fmt::format("{}{} was {}, is {}", text.empty() ? "" : "; ", what, was, is);
    }
    if (text_of(then, "fumon:pixels-sha256") == text_of(now, "fumon:pixels-sha256"))
        text += text.empty() ? "the same frames" : "; the same frames";
    return text.empty() ? "the parameters recorded in the film are the same" : text;
}

}  // namespace fumon
