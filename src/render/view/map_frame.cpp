#include "render/view/map_frame.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "render/view/camera.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

std::string xml_text(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            default:
                escaped += letter;
        }
    }
    return escaped;
}

}  // namespace

MapFrame map_frame(const View& view, const Snapshot& snapshot, const char* key) {
    if (view.camera.projection != Projection::map)
        throw KeyError(key, fmt::format("{} belongs to camera.projection = \"map\"", key));
    if (!snapshot.scale.in_metres || !snapshot.scale.place) {
        throw KeyError(
            key,
            fmt::format("{} needs a terrain file with map coordinates; this bed has none", key));
    }
    const std::optional<Snapshot> coarser = shown_snapshot(snapshot, view);
    const Snapshot& shown = coarser ? *coarser : snapshot;
    const std::array<double, 4> bed = map_rectangle(view, shown);  // left, top, width, height
    const GeoReference& place = *snapshot.scale.place;
    const double width = shown.bed.nx() * shown.scale.dx * (place.dx / snapshot.scale.dx);
    const double height = shown.bed.ny() * shown.scale.dy * (place.dy / snapshot.scale.dy);
    const double pixel_x = width / bed[2];
    const double pixel_y = height / bed[3];
    return {place.west - bed[0] * pixel_x, place.south + height + bed[1] * pixel_y, pixel_x,
            pixel_y, place.crs};
}

std::vector<WorldFile> world_files(const MapFrame& frame, const std::string& ending) {
    if (ending.size() < 2) return world_files(frame);  // of a picture without an ending
    std::vector<WorldFile> files;
    files.push_back(
        {std::string{'.', ending.at(1), ending.back(), 'w'},
         fmt::format("{}\n0\n0\n{}\n{}\n{}\n", frame.pixel_x, -frame.pixel_y,
                     frame.west + 0.5 * frame.pixel_x, frame.north - 0.5 * frame.pixel_y)});
    const std::string system =
        frame.crs.empty() ? "" : fmt::format("  <SRS>{}</SRS>\n", xml_text(frame.crs));
    files.push_back(
        {ending + ".aux.xml",
         fmt::format("<PAMDataset>\n{}  <GeoTransform>{}, {}, 0, {}, 0, {}</GeoTransform>\n"
                     "</PAMDataset>\n",
                     system, frame.west, frame.pixel_x, frame.north, -frame.pixel_y)});
    return files;
}

}  // namespace fumon
