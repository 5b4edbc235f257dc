#include "paper/figure_origin.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/json_text.h"
#include "paper/figure_paths.h"
#include "run/picture_text.h"
#include "scene/input_maps.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* figure_keyword = "fumon:figure";

const std::string* text_of(const FigureMetadata& metadata, const std::string& keyword) {
    for (const auto& [known, text] : metadata) {
        if (known == keyword) return &text;
    }
    return nullptr;
}

}  // namespace

FigureMetadata figure_metadata(const FigurePlan& plan, const FigureSources& sources) {
    const FigurePaths paths(plan, sources);
    Json origin;
    origin["scene"] = paths.name_of(plan.file);
    origin["set"] = Json::array();
    for (const std::string& setting : plan.settings)
        origin["set"].push_back(paths.in_text(setting));
    if (!sources.version().empty()) origin["defaults"] = sources.version();
    origin["texts"] = Json::array();
    for (const SourceText& text : sources.all()) {
        origin["texts"].push_back(
            {{"path", paths.name_of(text.path)}, {"text", paths.in_source(text)}});
    }
    origin["inputs"] = Json::array();
    for (const InputFile& input : plan.inputs)
        origin["inputs"].push_back({{"path", paths.name_of(input.path)}, {"sha256", input.hash}});
    FigureMetadata metadata;
    if (!plan.scene.title.empty()) metadata.emplace_back("Title", plan.scene.title);
    metadata.emplace_back("Software", "fumon " FUMON_VERSION);
    metadata.emplace_back(version_keyword, FUMON_VERSION);
    Scene scene = plan.scene;
    for (const InputKey& key : input_keys(scene)) *key.file = paths.name_of(*key.file);
    scene.figure.icc_profile = paths.name_of(scene.figure.icc_profile);
    metadata.emplace_back("fumon:scene", paths.in_text(resolved_scene(scene, {})));
    metadata.emplace_back(figure_keyword,
                          origin.dump(-1, ' ', true, Json::error_handler_t::replace));
    return metadata;
}

bool is_figure(const FigureMetadata& metadata) {
    return text_of(metadata, figure_keyword) != nullptr;
}

FigureOrigin read_figure_origin(const FigureMetadata& metadata, const std::string& figure) {
    FigureOrigin origin;
    if (const std::string* version = text_of(metadata, version_keyword)) origin.version = *version;
    try {
        const Json json = parse_json(*text_of(metadata, figure_keyword));
        origin.scene = json.at("scene");
        origin.settings = json.at("set").get<std::vector<std::string>>();
        for (const Json& text : json.at("texts"))
            origin.texts.push_back({text.at("path"), text.at("text")});
        for (const Json& input : json.at("inputs"))
            origin.inputs.push_back({input.at("path"), input.at("sha256")});
        origin.defaults = json.value("defaults", origin.version);
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: its {} text is damaged; take an untouched copy", figure,
                                     figure_keyword));
    }
    if (origin.defaults == FUMON_VERSION) origin.defaults.clear();
    return origin;
}

}  // namespace fumon
