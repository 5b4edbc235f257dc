#include "render/view/bed_positions.h"

#include <fmt/format.h>

#include "base/error.h"

namespace fumon {

void check_shows_scale(const View& view, const Block& block, const Snapshot& first,
                       const std::string& key, const std::string& what) {
    const auto refuse = [&](const std::string& why) { throw KeyError(key, what + " " + why); };
    if (!first.scale.in_metres)
        refuse(
            "shows a scale, but this bed is not in metres; give grid.cell_size, or leave it out");
    if (view.look.mode != ViewMode::scenic) refuse("is for scenic views (look.mode)");
    if (view.camera.projection != Projection::perspective)
        refuse("is for the perspective camera (camera.projection)");
    if (first.bed.ny() < 2) refuse("is for beds of more than one row");
    if (block.exaggeration != 1.0) {
        refuse(fmt::format(
            "shows true sizes, but heights are exaggerated {:g} times; write look.exaggeration = 1",
            block.exaggeration));
    }
}

glm::dvec2 bed_position(const glm::dvec2& metres, const View& view, const Block& block,
                        const Snapshot& first, const std::string& key, const std::string& said) {
    const double x = metres.x / block.side;
    const double y = metres.y / block.side;
    const bool beside = x < 0.0 || y < 0.0 || x >= block.width_x || y >= block.width_y;
    const auto lies_outside = [&] {
        return first.nodata(static_cast<int>(x / block.width_x * first.bed.nx()),
                            static_cast<int>(y / block.width_y * first.bed.ny())) != 0;
    };
    if (view.look.ground != Ground::endless &&
        (beside || (!first.nodata.empty() && lies_outside()))) {
        throw KeyError(
            key, fmt::format("{} = [{:g}, {:g}] is outside the bed, which is {:g} x {:g} m", said,
                             metres.x, metres.y, block.width_x * block.side,
                             block.width_y * block.side));
    }
    return {x - 0.5 * block.width_x, y - 0.5 * block.width_y};
}

}  // namespace fumon
