#include "film/camera/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/error.h"
#include "drape/lay_layers.h"
#include "film/script/film_looks.h"
#include "render/view/bilinear_height.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"
#include "scene/initial_bed.h"

namespace fumon {

namespace {

/// The height of the cell that holds a place of the block, or of the nearest one with data.
double ground_at(const FilmStage& stage, const Snapshot& bed, double x, double y) {
    const auto cell = [&](double place, int count) {
        const int index = static_cast<int>(std::floor(std::clamp(place, -1e8, 1e8)));
        return bed.periodic ? ((index % count) + count) % count : std::clamp(index, 0, count - 1);
    };
    const auto [column, row] =
        known_cell(bed.nodata, cell((x / stage.block.width_x + 0.5) * bed.bed.nx(), bed.bed.nx()),
                   cell((y / stage.block.width_y + 0.5) * bed.bed.ny(), bed.bed.ny()));
    return bed.bed(column, row);
}

/// Lays the film's own layers over the run's bed.
void lay_layers_of(const Film& film, const StoredBeds& beds, const std::vector<Override>& looks,
                   Scene& scene) {
    const auto of_layers = [](const Override& setting) {
        return setting.path.starts_with("layer.");
    };
    if (!std::ranges::any_of(film.looks, of_layers) && !std::ranges::any_of(looks, of_layers))
        return;
    InitialBed ground;
    ground.bed = beds.first().bed;
    ground.scale = beds.first().scale;
    lay_layers(scene, ground);
}

/// Refuses colours that a film asks for and no difference of two runs can have.
void check_difference(const Scene& scene) {
    const Colouring by = scene.view.look.colour_by;
    if (by == Colouring::height || by == Colouring::change || by == Colouring::water_depth ||
        by == Colouring::natural || by == Colouring::field || by == Colouring::field_change)
        return;
    throw InputError(scene.at("look.colour_by") +
                     "panes.show = \"difference\" colours by the difference of two runs in height, "
                     "water depth or a field; take look.colour_by = \"height\", \"water-depth\" or "
                     "\"field\"");
}

/// Lets a difference of two runs be of the water where it colours, and its bar say of what it is.
void name_difference(View& view) {
    LookSettings& look = view.look;
    if (look.colour_by == Colouring::water_depth) {
        look.colour_by = Colouring::field;
        look.field = "water_depth";
    }
    const bool by_field =
        look.colour_by == Colouring::field || look.colour_by == Colouring::field_change;
    std::string words = by_field ? look.field : "height";
    std::ranges::replace(words, '_', ' ');
    for (OverlaySettings& overlay : view.overlays)
        if (overlay.kind == OverlayKind::colour_bar && overlay.text.empty())
            overlay.text = "difference of " + words;
}

}  // namespace

FilmStage make_stage(const Film& film, const StoredBeds& beds, const FilmSize& size,
                     const std::vector<Override>& looks) {
    FilmStage stage{with_looks(beds.scene(), film, looks), {}};
    lay_layers_of(film, beds, looks, stage.scene);
    View& view = stage.scene.view;
    if (view.look.mode == ViewMode::figure && beds.first().section) {
        throw InputError(
            "the run's frames are flat figures of a section, which have no camera; give its scene "
            "look.mode = \"scenic\"");
    }
    view.image.width = size.width;
    view.image.height = size.height;
    if (film.settings.supersampling != 0) view.image.supersampling = film.settings.supersampling;
    view.camera.projection = Projection::perspective;
    view.camera.framing = Framing::block;
    view.camera.distance = 1.0;  // it is not always the whole block that is seen
    view.camera.at.clear();
    view.camera.look_at.clear();
    view.camera.turn = 0.0;
    view.camera.roll = 0.0;
    view.overlays = film.overlays;
    if (film.panes.show == PanesShow::difference) {
        const auto colours = [](const Override& look) { return look.path == "look.colour_by"; };
        const bool given =
            std::ranges::any_of(film.looks, colours) || std::ranges::any_of(looks, colours);
        if (given) check_difference(stage.scene);
        name_difference(view);
    }
    if (film.settings.background == FilmBackground::transparent) {
        view.look.background = Background::transparent;
        if (view.look.ground == Ground::endless) {
            throw InputError(film.at("film.background") +
                             "film.background = \"transparent\": look.ground is \"endless\", which "
                             "leaves nothing transparent; take look.ground = \"table\"");
        }
    }
    view = with_chosen_ground(view, beds.first());
    const std::optional<Snapshot> shown = shown_snapshot(beds.first(), view);
    stage.block = framed_block(view, shown ? *shown : beds.first());
    stage.copies = tile_warp_of(view, stage.block, shown ? *shown : beds.first());
    stage.repeats = view.look.ground == Ground::endless && beds.first().periodic;
    stage.aspect = static_cast<double>(size.width) / static_cast<double>(size.height);
    return stage;
}

Camera camera_of(const FilmStage& stage, const CameraPose& pose) {
    CameraSettings settings = stage.scene.view.camera;
    settings.focal_length = pose.focal_length * std::min(1.0, stage.aspect);
    Block block = stage.block;
    block.eye = pose.eye;
    block.look_at = pose.look_at;
    Camera camera = place_camera(settings, block, stage.aspect, 0.0);
    camera.focal_length = pose.focal_length;
    return camera;
}

glm::dvec3 place_on_stage(const FilmStage& stage, const std::vector<double>& place,
                          const Snapshot& bed) {
    const Block& block = stage.block;
    const double x = place[0] / block.side - 0.5 * block.width_x;
    const double y = place[1] / block.side - 0.5 * block.width_y;
    const glm::dvec2 shown = stage.copies.bed_position_at({x, y});
    const double on_bed = ground_at(stage, bed, shown.x, shown.y);
    const double above = place[2] / bed.scale.height_unit;
    const double raised =
        stage.copies.raised(stage.copies.at({x, y}), block.z(on_bed)) - block.z(on_bed);
    return {x, y, block.z(on_bed + above) + raised};
}

HighestGround::HighestGround(const FilmStage& stage) : stage_(stage), goes_on_(stage.repeats) {}

void HighestGround::add(const Snapshot& bed) {
    if (highest_.size() == 0)
        highest_ = Grid(bed.bed.nx(), bed.bed.ny(), stage_.block.z(bed.bed.values().front()));
    for (std::size_t i = 0; i < highest_.size(); ++i)
        highest_.values()[i] = std::max(highest_.values()[i], stage_.block.z(bed.bed.values()[i]));
}

double HighestGround::at(double x, double y) const {
    constexpr double nowhere = -1e9;
    constexpr int around = 2;  // cells
    const int nx = highest_.nx();
    const int ny = highest_.ny();
    const glm::dvec2 shown = stage_.copies.bed_position_at({x, y});
    const int column = static_cast<int>(
        std::floor(std::clamp((shown.x / stage_.block.width_x + 0.5) * nx, -1e8, 1e8)));
    const int row = static_cast<int>(
        std::floor(std::clamp((shown.y / stage_.block.width_y + 0.5) * ny, -1e8, 1e8)));
    double most = nowhere;
    for (int j = row - around; j <= row + around; ++j) {
        for (int i = column - around; i <= column + around; ++i) {
            const bool inside = i >= 0 && i < nx && j >= 0 && j < ny;
            if (!inside && !goes_on_) continue;
            most = std::max(most, highest_(((i % nx) + nx) % nx, ((j % ny) + ny) % ny));
        }
    }
    return most > nowhere ? stage_.copies.raised(stage_.copies.at({x, y}), most) : most;
}

}  // namespace fumon
