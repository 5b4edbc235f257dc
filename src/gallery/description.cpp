#include "gallery/description.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

/// The side from which a camera looks: one of eight.
const char* side_of(double azimuth) {
    constexpr std::array sides{"north", "north-east", "east", "south-east",
                               "south", "south-west", "west", "north-west"};
    constexpr double circle = 360.0;
    const double turns = azimuth / circle - std::floor(azimuth / circle);
    const auto eighth = static_cast<std::size_t>(std::lround(turns * sides.size()));
    return sides[eighth % sides.size()];
}

std::string cells_of(const Scene& scene) {
    const std::string cells = scene.bed.file.empty()
                                  ? fmt::format("{} × {} cells", scene.grid.nx, scene.grid.ny)
                                  : std::string("a terrain");
    return fmt::format("{} of the model {}", cells, scene.model.name);
}

std::string view_direction_text(const Scene& scene) {
    const bool is_placed = !scene.view.camera.at.empty() || !scene.view.camera.look_at.empty();
    if (scene.view.camera.projection == Projection::map || is_placed) return "";
    return fmt::format(", seen from the {}", side_of(scene.view.camera.azimuth));
}

const char* kind_of_view(const Scene& scene) {
    return scene.view.camera.projection == Projection::map ? "Map" : "3-D view";
}

}  // namespace

std::string described_picture(const Scene& scene, const std::string& step) {
    const std::string when = step.empty() ? "" : " at step " + step;
    return fmt::format("{} of {}{}{}", kind_of_view(scene), cells_of(scene), when,
                       view_direction_text(scene));
}

std::string described_film(const Scene& scene) {
    return fmt::format("Film of {}", cells_of(scene));
}

std::string described_figure(const Scene& scene) {
    const std::size_t panels = scene.figure.panels.size();
    const std::string count = panels == 0   ? ""
                              : panels == 1 ? " of one panel"
                                            : fmt::format(" of {} panels", panels);
    return fmt::format("Figure{}, made from {}", count, cells_of(scene));
}

}  // namespace fumon
