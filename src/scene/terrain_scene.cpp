#include "scene/terrain_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <initializer_list>
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

/// A scene of this text with a terrain file as its bed; only what settings say has a place.
Scene scene_over(const std::string& file, const std::string& text,
                 const std::vector<std::string>& settings) {
    Scene scene = parse_scene(text + "[bed]\nkind = \"file\"\nfile = \"-\"\n", "", "", settings);
    std::erase_if(scene.locations,
                  [](const auto& entry) { return !entry.second.starts_with("--set"); });
    if (!scene.set_on_command_line("bed.file")) scene.bed.file = file;
    return scene;
}

bool begins_any(const std::vector<std::string>& settings,
                std::initializer_list<std::string_view> beginnings) {
    return std::ranges::any_of(settings, [&](const std::string& setting) {
        return std::ranges::any_of(beginnings,
                                   [&](auto beginning) { return setting.starts_with(beginning); });
    });
}

/// The friction is that of bare and sparsely grown ground (Engman 1986). A step is what the frames
/// are apart or less: sub-steps follow the water by themselves.
constexpr const char* hour_of_water = R"([model]
name = "water"
initial_water = "dry"
friction = "manning"
manning = 0.05
time_step = 10
[run]
steps = 360
[output]
fields_every = 60
[[overlay]]
kind = "time"
text = "t = {time}"
[[overlay]]
kind = "scale-bar"
corner = "lower-left"
)";

constexpr const char* its_frames = "[frames]\nevery = 4\n";

constexpr const char* terrain_alone = R"([model]
name = "static"
[output]
movie = false
[[overlay]]
kind = "scale-bar"
corner = "lower-left"
)";

constexpr const char* another_model = "[model]\nname = \"static\"\n";

}  // namespace

bool is_terrain_name(const std::string& file, const std::vector<std::string>& settings) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending == ".png") return begins_any(settings, {"bed.heights="});
    constexpr std::array<std::string_view, 5> of_others{"", ".toml", ".mp4", ".pdf", ".svg"};
    return std::ranges::find(of_others, ending) == of_others.end();
}

Scene terrain_run(const std::string& file, const std::vector<std::string>& settings) {
    const auto water = [&] {
        const bool chosen = begins_any(settings, {"frames."});  // one way to choose frames
        return scene_over(file, std::string(hour_of_water) + (chosen ? "" : its_frames), settings);
    };
    if (begins_any(settings, {"model.name=water", "model.name=gully"})) return water();
    if (begins_any(settings, {"model.name="})) return scene_over(file, another_model, settings);
    const bool has_water = begins_any(settings, {"model.", "water.", "edge.", "gauge."});
    return has_water ? water() : scene_over(file, terrain_alone, settings);
}

Scene terrain_scene(const std::string& file, const std::string& heights,
                    const std::vector<std::string>& settings) {
    Scene scene =
        scene_over(file, fmt::format("[model]\nname = \"{}\"\n", terrain_model().name), settings);
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
