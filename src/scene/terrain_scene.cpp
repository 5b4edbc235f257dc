#include "scene/terrain_scene.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "models/registry.h"
#include "scene/read.h"

namespace fumon {

namespace {

double parse_height(std::string_view text, const std::string& whole) {
    double height = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), height);
    if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(height)) {
        throw InputError(fmt::format(
            "--heights is \"{}\"; it takes low:high in metres, for example 0:850", whole));
    }
    return height;
}

std::vector<double> parse_heights(const std::string& text) {
    if (text.empty()) return {};
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) parse_height("", text);
    return {parse_height(std::string_view(text).substr(0, colon), text),
            parse_height(std::string_view(text).substr(colon + 1), text)};
}

}  // namespace

Scene terrain_scene(const std::string& file, const std::string& heights,
                    const std::vector<std::string>& settings) {
    Scene scene =
        parse_scene(fmt::format("[model]\nname = \"{}\"\n[bed]\nkind = \"file\"\nfile = \"-\"\n",
                                terrain_model().name),
                    "", "", settings);
    std::erase_if(scene.locations,
                  [](const auto& entry) { return !entry.second.starts_with("--set"); });
    scene.bed.file = file;
    if (const auto range = parse_heights(heights); !range.empty()) {
        if (!(range[0] < range[1])) {
            throw InputError(fmt::format(
                "--heights {} must rise: low:high are the heights of black and white", heights));
        }
        scene.bed.heights = range;
    }
    return scene;
}

}  // namespace fumon
