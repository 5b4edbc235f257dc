#include "render/view/ground_choice.h"

#include <fmt/format.h>

#include "base/error.h"
#include "render/view/surrounding_plain.h"
#include "render/view/water.h"

namespace fumon {

const char* endless_ground_obstacle(const View& view, const Snapshot& first) {
    if (view.look.mode != ViewMode::scenic) return "is for scenic views (look.mode)";
    if (view.look.light == LightKind::studio) return "is for light from the sun (look.light)";
    if (view.camera.projection != Projection::perspective)
        return "is for the perspective camera (camera.projection)";
    if (first.bed.ny() < 2 || first.section) return "is for beds of more than one row";
    if (view.look.draws_contours()) return "shows no contours (look.contours)";
    if (view.look.background == Background::transparent)
        return "leaves nothing transparent (look.background)";
    return nullptr;
}

bool is_endless(const View& view, const Snapshot& first) {
    if (view.look.ground == Ground::automatic)
        return !is_bounded(first) && !draws_water(view.look, first) &&
               endless_ground_obstacle(view, first) == nullptr;
    return view.look.ground == Ground::endless;
}

void check_background(const View& view, const Snapshot& first) {
    if (view.look.background == Background::transparent && first.section) {
        throw InputError(
            "look.background = \"transparent\" is for blocks of ground; a section with its air "
            "takes \"surroundings\"");
    }
}

void check_cover(const View& view, const Snapshot& first) {
    if (view.look.cover == LandCover::bare) {
        if (view.look.snow_line.is_word()) return;
        throw KeyError("look.snow_line", "belongs to look.cover = \"auto\"");
    }
    const bool land = first.landform == Landform::terrain || first.landform == Landform::water;
    if (!land || first.bed.ny() < 2)
        throw KeyError("look.cover",
                       "\"auto\" covers terrain, dry or under water; this bed takes \"bare\"");
}

void check_sea(const View& view, const Snapshot& first) {
    if (view.look.sea_level.is_word()) return;
    const auto refuse = [](const char* why) {
        throw KeyError("look.sea_level",
                       fmt::format("look.sea_level {}; \"none\" draws this one", why));
    };
    if (first.periodic) refuse("is for a bed with an edge, and this one goes on past its sides");
    if (first.bed.ny() < 2) refuse("is for beds of more than one row");
    if (!first.scale.in_metres) refuse("is a height in metres, and this bed has none");
}

std::optional<double> known_sea(const View& view, const Snapshot& first) {
    if (view.look.sea_level.is_word()) return std::nullopt;
    return view.look.sea_level.value / first.scale.height_unit;
}

View with_chosen_ground(View view, const Snapshot& first) {
    check_background(view, first);
    check_cover(view, first);
    check_sea(view, first);
    if (!is_endless(view, first)) {
        view.look.ground = Ground::table;
        return view;
    }
    if (const char* fault = endless_ground_obstacle(view, first); fault != nullptr) {
        throw InputError(
            fmt::format("look.ground = \"endless\" {}; \"table\" draws this one", fault));
    }
    view.look.ground = Ground::endless;
    return view;
}

}  // namespace fumon
