#include "web/run_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/data_files.h"
#include "base/sha256.h"
#include "cite/reference_text.h"
#include "cite/scene_works.h"
#include "figure/canvas/packed_text.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "models/registry.h"
#include "picture/markup.h"
#include "run/picture_text.h"
#include "run/terminal/status_line.h"
#include "scene/json.h"
#include "scene/placeholders.h"
#include "web/packed_fields.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr double most_height_bytes = 0.85;  // of a cell of a bed
constexpr double most_depth_bytes = 0.5;

std::string page_part(const char* name) {
    return read_input_file(data_file(std::string("assets/web/") + name));
}

/// The scripts as one, whose names are no others'.
std::string page_script() {
    std::string script = "\"use strict\";\n(() => {\n";
    for (const char* name : {"beds.js", "camera.js", "stage.js", "page.js"})
        script += page_part(name);
    return script + "})();\n";
}

/// By which a policy of contents lets the text of an element pass, and no other.
std::string policy_hash(const std::string& text) {
    const Sha256 hash = text_hash(text);
    const std::string bytes(hash.begin(), hash.end());
    return "'sha256-" + base64_text(bytes) + "'";
}

/// In an element `script` no text may end or begin another.
std::string script_json(const Json& json) {
    std::string text;
    for (const char letter : json_text(json)) {
        if (letter == '<') {
            text += "\\u003c";
        } else {
            text += letter;
        }
    }
    return text;
}

Json packed_json(const PackedFields& packed, double zero) {
    Json fields = Json::array();
    for (const PackedField& field : packed.fields)
        fields.push_back({field.over_previous ? 1 : 0, field.predictor, base64_text(field.bytes)});
    return {{"low", packed.low + zero}, {"step", packed.step}, {"fields", std::move(fields)}};
}

std::string mask_letters(const Mask& nodata) {
    std::string bytes;
    for (const auto cell : nodata.values()) bytes += cell != 0 ? '\1' : '\0';
    return nodata.empty() ? "" : base64_text(deflated(bytes));
}

/// markup_text() of several lines: it takes a line's end for a letter that XML cannot hold.
std::string markup_lines(const std::string& text) {
    std::string marked;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        marked += markup_text(std::string_view(text).substr(begin, end - begin));
        if (end < text.size()) marked += '\n';
        begin = end + 1;
    }
    return marked;
}

std::string credits(const Scene& scene) {
    std::string works;
    for (const CitedWork& cited : works_of(scene))
        works += (works.empty() ? "" : "; ") + short_citation(*cited.work);
    const ModelEntry* model = find_model(scene.model.name);
    std::string text =
        fmt::format("Made with fumon {}. Model: {}", FUMON_VERSION, scene.model.name);
    if (model != nullptr) text += fmt::format(", {}", model->help);
    text += ".";
    return works.empty() ? text : text + " After " + works + ".";
}

/// Folders of this machine are nobody's business.
std::string title_of(const PageRun& run) {
    if (!run.scene.title.empty()) return run.scene.title;
    std::filesystem::path path(run.name);
    if (path.filename().empty()) path = path.parent_path();
    return path.stem().empty() ? "fumon" : path.stem().string();
}

std::string facts_of(const DrawnRun& drawn) {
    const char* unit = drawn.scale.in_metres ? " m" : " sites";
    std::string text = fmt::format("{:g} × {:g}{}, {} bed{}", drawn.width, drawn.height, unit,
                                   drawn.beds.size(), drawn.beds.size() == 1 ? "" : "s");
    if (drawn.block.exaggeration != 1.0)
        text += fmt::format(", heights × {:g}", drawn.block.exaggeration);
    return text;
}

Json data_of(DrawnRun& drawn, const PackedFields& heights) {
    const Block& block = drawn.block;
    Json outline = Json::array();
    for (const glm::dvec2& point : block.outline) outline.push_back({point.x, point.y});
    Json beds = Json::array();
    std::vector<Field<float>> depths;
    for (DrawnBed& bed : drawn.beds) {
        beds.push_back({{"step", bed.step},
                        {"label", bed.label},
                        {"reference", bed.reference + drawn.zero},
                        {"picture", base64_text(bed.picture)}});
        if (!bed.depths.empty()) depths.push_back(std::move(bed.depths));
    }
    Json data{{"cells", {drawn.nx, drawn.ny}},
              {"size", {drawn.width, drawn.height}},
              {"length", drawn.scale.in_metres ? "m" : "sites"},
              {"unit", drawn.scale.in_metres ? "m" : ""},
              {"extent", {block.width_x, block.width_y}},
              {"base", block.base},
              {"top", block.top},
              {"upward", block.height_scale / drawn.scale.height_unit},
              {"outline", std::move(outline)},
              {"azimuth", drawn.azimuth},
              {"elevation", drawn.elevation},
              {"tangent", drawn.tangent},
              {"margin", drawn.margin},
              {"walls", drawn.walls},
              {"water", drawn.water},
              {"nodata", mask_letters(drawn.nodata)},
              {"beds", std::move(beds)},
              {"heights", packed_json(heights, drawn.zero)}};
    if (depths.size() == drawn.beds.size())
        data["depths"] = packed_json(packed_fields(depths, most_depth_bytes), 0.0);
    return data;
}

}  // namespace

std::string run_page(const PageRun& run, DrawnRun drawn, double& height_step) {
    std::vector<Field<float>> fields;
    fields.reserve(drawn.beds.size());
    for (DrawnBed& bed : drawn.beds) fields.push_back(std::move(bed.heights));
    const PackedFields heights = packed_fields(fields, most_height_bytes);
    const Json data = data_of(drawn, heights);
    const std::string style = page_part("page.css");
    const std::string script = page_script();
    const std::string scene = resolved_scene(run.scene, run.inputs);
    const std::string title = title_of(run);
    const auto value = [&](const std::string& name) -> std::optional<std::string> {
        if (name == "title") return markup_text(title);
        if (name == "facts") return markup_text(facts_of(drawn));
        if (name == "last") return markup_text(drawn.beds.back().label);
        if (name == "credits") return markup_text(credits(run.scene));
        if (name == "scene") return markup_lines(scene);
        if (name == "scene-letters") return base64_text(scene);
        if (name == "poster") return base64_text(drawn.poster);
        if (name == "poster-width") return fmt::format("{}", drawn.poster_width);
        if (name == "poster-height") return fmt::format("{}", drawn.poster_height);
        if (name == "style") return style;
        if (name == "style-hash") return policy_hash(style);
        if (name == "script") return script;
        if (name == "script-hash") return policy_hash(script);
        if (name == "data") return script_json(data);
        return std::nullopt;
    };
    height_step = heights.step;
    return fill_placeholders(page_part("page.html"), value);
}

std::string page_file(const PageRun& run, const PageOptions& options, const WorkOptions& work) {
    DrawnRun drawn = drawn_run(run, options, work);
    const std::size_t beds = drawn.beds.size();
    const int cells = drawn.cells_per_point;
    const bool in_metres = drawn.scale.in_metres;
    double height_step = 0.0;
    std::string page = run_page(run, std::move(drawn), height_step);
    StatusLine status(work.verbosity);
    if (beds < run.beds.size())
        status.note(fmt::format("{} of {} stored beds, evenly (--beds allows more)", beds,
                                run.beds.size()));
    if (cells > 1)
        status.note(
            fmt::format("each point is the mean of {0} x {0} cells (--triangles allows "
                        "more)",
                        cells));
    constexpr double megabyte = 1e6;
    status.note(fmt::format("{} bed{}, heights in steps of {:.2g}{}, {:.1f} MB", beds,
                            beds == 1 ? "" : "s", height_step, in_metres ? " m" : "",
                            static_cast<double>(page.size()) / megabyte));
    return page;
}

}  // namespace fumon
