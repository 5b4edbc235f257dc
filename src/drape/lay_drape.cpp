#include "drape/lay_drape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "drape/picture_source.h"
#include "drape/placed_drape.h"
#include "files/hash.h"
#include "files/terrain/grid_hash.h"
#include "scene/input_maps.h"
#include "scene/trust.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr const char* key = "look.drape";

void check_size(const Scene& scene, const PictureSource& picture) {
    const std::int64_t pixels =
        static_cast<std::int64_t>(picture.width()) * static_cast<std::int64_t>(picture.height());
    if (scene.trusted || pixels <= trust_limits.samples) return;
    throw InputError(fmt::format(
        "{}a drape of {} pixels is larger than the {} allowed to scenes of unknown origin; --trust "
        "lifts this limit",
        scene.at(key), with_commas(pixels), with_commas(trust_limits.samples)));
}

/// One line on a picture or bed that does not say where it lies, or empty.
std::string how_fitted(const Scene& scene, const PictureSource& picture, const BedCells& bed) {
    if (picture.place() && bed.place) {
        const bool guessed = picture.place()->crs.empty() && !bed.place->crs.empty();
        return guessed ? fmt::format(
                             "look.drape: {} names no reference system: taken for the "
                             "bed's",
                             scene.view.look.drape)
                       : "";
    }
    return fmt::format(
        "look.drape: {} {}: fitted to the bed's extent", scene.view.look.drape,
        picture.place() ? "is georeferenced and the bed is not" : "has no georeference");
}

std::shared_ptr<const Drape> read_drape(const Scene& scene, const fs::path& file,
                                        InitialBed& initial) {
    const bool mine = scene.trusted || scene.set_on_command_line(key);
    std::unique_ptr<PictureSource> picture;
    try {
        picture = open_picture(file, mine);
        check_size(scene, *picture);
        const BedCells bed{initial.bed.nx(), initial.bed.ny(), initial.scale.place};
        auto drape = std::make_shared<const Drape>(placed_drape(*picture, bed));
        const std::string note = how_fitted(scene, *picture, bed);
        if (initial.note.find(note) == std::string::npos)
            initial.note += (initial.note.empty() ? "" : "; ") + note;
        return drape;
    } catch (const InputError& refusal) {
        if (!mine && !picture) {
            throw InputError(fmt::format("{}{} is not a readable picture; --trust gives details",
                                         scene.at(key), file.string()));
        }
        const std::string what = refusal.what();
        const bool placed = what.starts_with(scene.at(key)) && !scene.at(key).empty();
        const bool named = what.starts_with(file.string());
        throw InputError(placed ? what
                                : scene.at(key) + (named ? "" : file.string() + ": ") + what);
    }
}

}  // namespace

void lay_drape(Scene& scene, InitialBed& initial) {
    scene.view.drape.reset();
    if (scene.view.look.drape.empty()) return;
    const std::vector<InputKey> keys = input_keys(scene);
    const auto named = std::ranges::find(keys, key, &InputKey::path);
    const fs::path file = input_path(scene, *named);
    check_named_file(scene, key, scene.view.look.drape, file);
    if (initial.bed.ny() < 2) {
        throw InputError(scene.at(key) +
                         "look.drape lies over beds of several rows, and this one is a profile; "
                         "leave the key out");
    }
    scene.view.drape = read_drape(scene, file, initial);
    const auto before = static_cast<std::size_t>(named - keys.begin());
    if (initial.inputs.size() <= before)
        initial.inputs.push_back({file.lexically_normal().string(), hex(grid_hash(file))});
}

}  // namespace fumon
