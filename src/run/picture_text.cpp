#include "run/picture_text.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "picture/exr.h"
#include "picture/movie.h"
#include "picture/stills/jpeg.h"
#include "picture/stills/picture_file.h"
#include "picture/stills/tiff.h"
#include "picture/stills/webp.h"
#include "scene/input_maps.h"
#include "scene/json.h"
#include "scene/write.h"

namespace fumon {

namespace {

constexpr const char* scene_keyword = "fumon:scene";
constexpr const char* seed_keyword = "fumon:seed";
constexpr const char* step_keyword = "fumon:step";
constexpr const char* inputs_keyword = "fumon:inputs";
constexpr const char* pixels_keyword = "fumon:pixels-sha256";
constexpr const char* encoder_keyword = "fumon:encoder";
constexpr const char* environment_keyword = "fumon:environment";
constexpr const char* results_keyword = "fumon:results";

std::string inputs_text(const std::vector<InputFile>& inputs) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const InputFile& input : without_local_paths(inputs))
        list.push_back({{"path", input.path}, {"sha256", input.hash}});
    return json_text(list);
}

std::vector<InputFile> parse_inputs(const std::string& text, const std::string& picture) {
    std::vector<InputFile> inputs;
    try {
        for (const auto& item : parse_json(text))
            inputs.push_back({item.at("path"), item.at("sha256")});
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: its {} text is damaged; take an untouched copy", picture,
                                     inputs_keyword));
    }
    return inputs;
}

RenderingEnvironment parse_drawn_by(const std::string& text, const std::string& picture) {
    try {
        return parse_environment(text);
    } catch (const InputError&) {
        throw InputError(fmt::format("{}: its {} text is damaged; take an untouched copy", picture,
                                     environment_keyword));
    }
}

std::int64_t parse_step(const std::string& text, const std::string& picture) {
    std::int64_t step = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), step);
    if (fault != std::errc{} || end != text.data() + text.size() || step < 0) {
        throw InputError(
            fmt::format("{}: its {} text \"{}\" is not a step number; take an untouched copy",
                        picture, step_keyword, text));
    }
    return step;
}

std::string usual_ending(std::string_view head) {
    if (is_tiff(head)) return ".tif";
    return is_jpeg(head) ? ".jpg" : is_webp(head) ? ".webp" : ".png";
}

}  // namespace

std::string resolved_scene(const Scene& scene, const std::vector<InputFile>& inputs) {
    Scene resolved = scene;
    name_inputs(resolved, without_local_paths(inputs), &InputFile::path);
    return to_toml(resolved);
}

PictureText picture_text(const std::string& resolved, const Scene& scene, std::int64_t step,
                         const std::vector<InputFile>& inputs, const Sha256& pixels,
                         const RenderingEnvironment& environment) {
    PictureText texts;
    if (!scene.title.empty()) texts.emplace_back("Title", scene.title);
    texts.emplace_back("Software", "fumon " FUMON_VERSION);
    texts.emplace_back(version_keyword, FUMON_VERSION);
    texts.emplace_back(seed_keyword, fmt::format("{}", scene.seed));
    texts.emplace_back(step_keyword, fmt::format("{}", step));
    texts.emplace_back(scene_keyword, resolved);
    texts.emplace_back(inputs_keyword, inputs_text(inputs));
    texts.emplace_back(pixels_keyword, hex(pixels));
    texts.emplace_back(environment_keyword, environment_text(environment));
    return texts;
}

PictureText of_results(PictureText texts, const std::string& results) {
    if (!results.empty()) texts.emplace_back(results_keyword, results);
    return texts;
}

PictureText movie_text(const std::string& resolved, const Scene& scene,
                       const std::vector<InputFile>& inputs, const FrameList& frames,
                       const RenderingEnvironment& environment) {
    PictureText texts =
        picture_text(resolved, scene, frames.last_step(), inputs, frames.pixels(), environment);
    texts.emplace_back(encoder_keyword, movie_encoder());
    return texts;
}

PictureOrigin read_origin(const std::filesystem::path& picture) {
    constexpr std::size_t signature = 12;  // bytes
    std::map<std::string, std::string> texts;
    const bool movie = is_movie(picture);
    const std::string head = start_of_input_file(picture, signature);
    const bool light = is_exr(head);
    if (!movie && !light && !is_picture(head)) {
        const std::string what =
            picture.extension() == ".toml"
                ? fmt::format("; `fumon run {} -o DIR` runs a scene", picture.string())
                : "";
        throw InputError(fmt::format(
            "{}: is not a picture; fumon again takes a PNG, JPEG, WebP, OpenEXR, MP4, PDF "
            "or SVG that fumon made{}",
            picture.string(), what));
    }
    for (auto& [keyword, text] : movie   ? read_movie_texts(picture)
                                 : light ? read_exr_texts(picture)
                                         : read_picture_texts(picture))
        texts[keyword] = std::move(text);
    if (texts.contains("fumon:film")) {
        throw InputError(fmt::format(
            "{}: is a film, cut from the beds that a run has stored; `fumon film RUN {}` makes "
            "it again from the run's folder",
            picture.string(), picture.string()));
    }
    for (const char* keyword : {scene_keyword, step_keyword, inputs_keyword}) {
        if (!texts.contains(keyword)) {
            throw InputError(
                fmt::format("{}: has no {} text; fumon again takes a picture that fumon made and "
                            "that no other program has rewritten",
                            picture.string(), keyword));
        }
    }
    PictureOrigin origin;
    origin.scene = texts[scene_keyword];
    origin.step = parse_step(texts[step_keyword], picture.string());
    origin.inputs = parse_inputs(texts[inputs_keyword], picture.string());
    origin.version = texts[version_keyword];
    origin.pixels_hash = texts[pixels_keyword];
    origin.is_movie = movie;
    origin.is_exr = light;
    origin.ending = movie ? ".mp4" : light ? ".exr" : usual_ending(head);
    origin.encoder = texts[encoder_keyword];
    origin.results = texts[results_keyword];
    if (texts.contains(environment_keyword))
        origin.environment = parse_drawn_by(texts[environment_keyword], picture.string());
    return origin;
}

}  // namespace fumon
