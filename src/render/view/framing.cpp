#include "render/view/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "render/view/bilinear_height.h"
#include "render/view/ground_choice.h"
#include "render/view/surrounding_plain.h"
#include "render/view/water.h"
#include "scene/placed_sun.h"

namespace fumon {

namespace {

/// The bed's height at a place in cells, between its four nearest centres; of those without data,
/// that of the nearest cell with some.
double height_at(const Snapshot& snapshot, double x, double y) {
    const Grid& bed = snapshot.bed;
    const auto cell = [](double position, int count, bool periodic) {
        const int index = static_cast<int>(std::floor(position));
        return periodic ? ((index % count) + count) % count : std::clamp(index, 0, count - 1);
    };
    const double column = std::clamp(x, -1e8, 1e8) - 0.5;
    const double row = std::clamp(y, -1e8, 1e8) - 0.5;
    const auto height = [&](double i, double j) {
        const auto [known_column, known_row] =
            known_cell(snapshot.nodata, cell(column + i, bed.nx(), snapshot.periodic),
                       cell(row + j, bed.ny(), snapshot.periodic));
        return bed(known_column, known_row);
    };
    const double east = column - std::floor(column);
    const double north = row - std::floor(row);
    return (1.0 - north) * ((1.0 - east) * height(0, 0) + east * height(1, 0)) +
           north * ((1.0 - east) * height(0, 1) + east * height(1, 1));
}

/// z of the ground at a place from the bed's middle.
double ground_at(const Snapshot& snapshot, const Block& block, const glm::dvec2& position,
                 const TileWarp& copies) {
    const glm::dvec2 shown = copies.bed_position_at(position);
    return copies.raised(
        copies.at(position),
        block.z(height_at(snapshot, (shown.x / block.width_x + 0.5) * snapshot.bed.nx(),
                          (shown.y / block.width_y + 0.5) * snapshot.bed.ny())));
}

/// A place of the scene in the block's lengths; none for an empty one.
std::optional<glm::dvec3> position_in_block(const std::vector<double>& position,
                                            const Snapshot& first, const Block& block) {
    if (position.empty()) return std::nullopt;
    const double ground =
        height_at(first, position[0] / first.scale.dx, position[1] / first.scale.dy);
    return glm::dvec3(position[0] / block.side - 0.5 * block.width_x,
                      position[1] / block.side - 0.5 * block.width_y,
                      block.z(ground + position[2] / first.scale.height_unit));
}

/// Where far copies of the bed stand otherwise than it does.
void stand_on_copies(Block& block, const View& view, const Snapshot& first) {
    const TileWarp copies = tile_warp_of(view, block, first);
    const auto stand = [&](std::optional<glm::dvec3>& point) {
        if (!point || !copies.varies_at(glm::dvec2(*point))) return;
        point->z += ground_at(first, block, glm::dvec2(*point), copies) -
                    ground_at(first, block, glm::dvec2(*point), {});
    };
    stand(block.eye);
    stand(block.look_at);
}

/// What a bed looks like from afar, in the block's lengths.
struct Relief {
    double low = 0.0;     ///< z of the 5th percentile
    double high = 0.0;    ///< of the 99th
    double length = 1.0;  ///< of its waves: 2π times the height over the slope, both as rms
    glm::dvec2 highest{0.0};
};

Relief relief_of(const Snapshot& first, const Block& block) {
    if (height_statistics(first.bed, first.nodata).smoothness < 0.5) {
        // Landforms are still to grow out of noise.
        Relief expected;
        expected.low = block.surface;
        expected.high = std::max(block.z(first.highest_expected), block.surface + 0.015);
        expected.length = 0.15;
        return expected;
    }
    const Grid& bed = first.bed;
    const double dx = block.width_x / bed.nx();
    const double dy = block.width_y / bed.ny();
    const auto inside = [&](int x, int y) {
        return first.nodata.empty() || first.nodata(x, y) == 0;
    };
    std::vector<double> heights;
    heights.reserve(bed.size());
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (inside(x, y)) heights.push_back(bed(x, y));
        }
    }
    if (heights.empty()) return {};
    std::ranges::sort(heights);
    const auto at = [&](double share) {
        return block.z(
            heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))]);
    };
    Relief relief{at(0.05), at(0.99)};
    double squares = 0.0;
    double slopes = 0.0;
    double most = std::numeric_limits<double>::lowest();
    const double middle = at(0.5);
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (!inside(x, y)) continue;
            const double z = block.z(bed(x, y));
            const auto slope = [&](int column, int row, double distance) {
                return inside(column, row) ? (block.z(bed(column, row)) - z) / distance : 0.0;
            };
            const bool ends_east = !first.periodic && x + 1 == bed.nx();
            const bool ends_north = !first.periodic && y + 1 == bed.ny();
            const double east = ends_east ? 0.0 : slope((x + 1) % bed.nx(), y, dx);
            const double north = ends_north ? 0.0 : slope(x, (y + 1) % bed.ny(), dy);
            squares += (z - middle) * (z - middle);
            slopes += 0.5 * (east * east + north * north);
            // Of equal crests the one nearest to the middle.
            const glm::dvec2 position((x + 0.5) * dx - 0.5 * block.width_x,
                                      (y + 0.5) * dy - 0.5 * block.width_y);
            const double rank = z - 0.05 * (relief.high - relief.low) * glm::length(position);
            if (rank <= most) continue;
            most = rank;
            relief.highest = position;
        }
    }
    if (slopes > 0.0)
        relief.length = std::clamp(2.0 * std::numbers::pi * std::sqrt(squares / slopes), 0.02, 1.0);
    return relief;
}

/// An azimuth at least 10 degrees away from the lattice's sides and diagonals, as near as may be.
double off_lattice(double azimuth, const Block& block) {
    constexpr double away = 10.0;
    const double diagonal = elementary::atan2(block.width_x, block.width_y) / degree;
    double best = azimuth;
    double least = 1e9;
    const auto distance = [](double a, double b) {
        const double turns = (a - b) / 180.0;
        const double apart = 180.0 * (turns - std::floor(turns));
        return std::min(apart, 180.0 - apart);
    };
    for (int tenths = -250; tenths <= 250; ++tenths) {
        const double tried = azimuth + 0.1 * tenths;
        bool clear = true;
        for (const double lattice : {0.0, 90.0, diagonal, -diagonal})
            clear = clear && distance(tried, lattice) >= away;
        if (!clear || std::abs(0.1 * tenths) >= least) continue;
        least = std::abs(0.1 * tenths);
        best = tried;
    }
    return best;
}

/// Where the camera of a named framing stands and what it looks at.
void set_framing(Block& block, Framing framing, const Snapshot& first) {
    if (framing == Framing::block) return;
    const Relief relief = relief_of(first, block);
    const HorizontalDirection way = prevailing_direction(first);
    const double downwind = elementary::atan2(way.x, way.y) / degree;
    const double height = std::max(relief.high - relief.low, 0.02 * relief.length);
    struct Stand {
        double azimuth;   ///< towards which it looks, from downwind, degrees
        double distance;  ///< from what it looks at
        double above;     ///< the middle of the relief
        double target;    ///< height of what it looks at above the same
    };
    const double wave = relief.length;
    Stand stand{};
    switch (framing) {
        case Framing::overview:
            stand = {125.0, 2.2 * wave, 0.65 * wave, 0.0};
            break;
        case Framing::low:
            stand = {150.0, 1.6 * wave, 0.8 * height, 0.15 * height};
            break;
        case Framing::along_crest:
            stand = {72.0, 1.1 * wave, 0.75 * height, 0.3 * height};
            break;
        case Framing::slip_face:
            stand = {200.0, 0.9 * wave, 0.1 * height, 0.25 * height};
            break;
        case Framing::aerial:
            stand = {130.0, 1.2 * wave, 1.3 * wave, 0.0};
            break;
        case Framing::block:
            return;
    }
    const double azimuth = off_lattice(downwind + stand.azimuth, block) * degree;
    const glm::dvec2 ahead(elementary::sin(azimuth), elementary::cos(azimuth));
    const glm::dvec2 position = relief.highest - stand.distance * ahead;
    const double middle = 0.5 * (relief.low + relief.high);
    const double ground =
        block.z(height_at(first, (position.x / block.width_x + 0.5) * first.bed.nx(),
                          (position.y / block.width_y + 0.5) * first.bed.ny()));
    block.eye_above = 0.15 * height;
    block.eye = glm::dvec3(position, std::max(middle + stand.above, ground + block.eye_above));
    block.look_at = glm::dvec3(relief.highest, middle + stand.target);
}

}  // namespace

Block framed_block(const View& view, const Snapshot& first) {
    const WordOrReal& wanted = view.look.exaggeration;
    const double exaggeration = !wanted.is_word()         ? wanted.value
                                : wanted.word == "relief" ? relief_exaggeration(first)
                                                          : automatic_exaggeration(first);
    Block block = frame_block(first, exaggeration, view.look.room, view.look.footing);
    block.eye = position_in_block(view.camera.at, first, block);
    block.look_at = position_in_block(view.camera.look_at, first, block);
    if (block.eye)
        block.eye_above = view.camera.at[2] / first.scale.height_unit * block.height_scale;
    if (block.eye || block.look_at) stand_on_copies(block, view, first);
    set_framing(block, view.camera.framing, first);
    block.goes_on = is_endless(view, first) && is_bounded(first);
    return block;
}

bool counts_from_own_mean(const LookSettings& look, const Snapshot& first) {
    if (look.datum != Datum::automatic) return look.datum == Datum::mean;
    return has_water(first) && look.sea_level.is_word();
}

Block block_of_frame(const Block& block, const LookSettings& look, const Snapshot& first,
                     const Snapshot& snapshot) {
    Block framed = block;
    if (counts_from_own_mean(look, first))
        framed.reference = height_statistics(snapshot.bed, snapshot.nodata).mean;
    return framed;
}

Camera camera_at_step(const View& view, const Block& block, std::int64_t step,
                      std::int64_t last_step) {
    const double aspect =
        static_cast<double>(view.image.width) / static_cast<double>(view.image.height);
    return place_camera(view.camera, block, aspect, share_of_run(step, last_step));
}

Camera above_ground(Camera camera, const Block& block, const Snapshot& snapshot,
                    const TileWarp& copies) {
    if (!block.eye) return camera;
    const double ground = ground_at(snapshot, block, glm::dvec2(camera.eye), copies);
    camera.eye.z = std::max(camera.eye.z, ground + block.eye_above);
    return camera;
}

View standing_on(View view, const Snapshot& first, const Snapshot& drawn) {
    CameraSettings& camera = view.camera;
    if (camera.at.empty() && camera.look_at.empty()) return view;
    const Block block = framed_block(view, first);
    const Block framed = block_of_frame(block, view.look, first, drawn);
    const TileWarp copies = tile_warp_of(view, block, first);
    const auto rise_at = [&](const glm::dvec3& point) {
        const glm::dvec2 position(point);
        const double rise =
            ground_at(drawn, framed, position, copies) - ground_at(first, block, position, copies);
        return rise / block.height_scale * first.scale.height_unit;
    };
    // Over ground that has risen above_ground() lifts the camera.
    if (!camera.at.empty()) camera.at[2] += std::min(0.0, rise_at(*block.eye));
    if (!camera.look_at.empty()) camera.look_at[2] += rise_at(*block.look_at);
    return view;
}

double pixels_per_length(const Camera& camera, const View& view) {
    const double depth = camera.perspective ? camera.focus : 1.0;
    return 0.5 * static_cast<double>(view.image.height) / (camera.half.y * std::max(depth, 0.05));
}

}  // namespace fumon
