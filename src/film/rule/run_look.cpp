#include "film/rule/run_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "film/camera/bed_clock.h"
#include "film/camera/landmarks.h"
#include "render/view/block.h"
#include "render/view/ground_choice.h"

namespace fumon {

namespace {

constexpr double wind_camera_azimuth = 80.0;  // degrees from the sun to the camera
constexpr double past_the_wind = 15.0;        // degrees from the wind to the sun, clockwise

/// Degrees clockwise from north of a direction, 0 … 360.
double azimuth_of(double east, double north) {
    const double degrees = elementary::atan2(east, north) / degree;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

/// Where a third and four fifths of the visible change are over.
void find_pace(const StoredBeds& beds, RunLook& look) {
    constexpr std::size_t most = 40;        // beds that are compared
    constexpr double least_change = 0.004;  // of all light, below which the bed stays as it is
    const std::size_t count = beds.beds().size();
    look.changes = count > 1;
    if (!look.changes) return;
    const std::size_t stride = std::max<std::size_t>(1, count / most);
    std::vector<double> sums{0.0};
    std::vector<double> steps{static_cast<double>(beds.beds().front().step)};
    for (std::size_t i = 0; i + 1 < count; i += stride) {
        const std::size_t next = std::min(i + stride, count - 1);
        sums.push_back(sums.back() +
                       visible_change(*bed_as_seen(beds, i), *bed_as_seen(beds, next)));
        steps.push_back(static_cast<double>(beds.beds()[next].step));
    }
    look.shaped = sums.back() > least_change;
    if (!look.shaped) return;
    constexpr double start_alone =
        0.2;  // of all change: rain begins, or water drains that lay there
    constexpr double latest_begin = 0.3;  // of all steps: a film shows what is left
    const double passed = (steps[1] - steps.front()) / (steps.back() - steps.front());
    const bool begins_later =
        sums[1] > start_alone * sums.back() && sums.size() > 8 && passed < latest_begin;
    const double start = begins_later ? sums[1] : 0.0;
    if (begins_later) look.begin = static_cast<int>(std::ceil(100.0 * passed));
    const auto share_at = [&](double part, int low, int high) {
        const double wanted = start + part * (sums.back() - start);
        const auto after = std::ranges::lower_bound(sums, wanted) - sums.begin();
        const double step = steps[static_cast<std::size_t>(after)];
        const double share = (step - steps.front()) / (steps.back() - steps.front());
        return std::clamp(static_cast<int>(std::lround(100.0 * share)), low, high);
    };
    look.early = share_at(1.0 / 3.0, look.begin + 5, 60);
    look.late = share_at(0.8, look.early + 10, 90);
}

/// What a few cells of a bed say of its slopes.
struct Slopes {
    double mean_east = 0.0;  ///< mean rise
    double mean_north = 0.0;
    double relief = 0.0;                     ///< of heights, over the bed's longer side
    std::vector<std::array<double, 2>> all;  ///< rise eastward and northward
};

Slopes slopes_of(const Snapshot& bed, double exaggeration) {
    constexpr int most_cells = 200;  // along each side
    Slopes slopes;
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    const int stride = std::max(1, std::max(nx, ny) / most_cells);
    const double unit = bed.scale.height_unit * exaggeration;
    const auto there = [&](int x, int y) { return bed.nodata.empty() || bed.nodata(x, y) == 0; };
    double low = INFINITY;
    double high = -INFINITY;
    for (int y = stride; y + stride < ny; y += stride) {
        for (int x = stride; x + stride < nx; x += stride) {
            if (!there(x, y) || !there(x - stride, y) || !there(x + stride, y) ||
                !there(x, y - stride) || !there(x, y + stride))
                continue;
            const double reach = 2.0 * stride;
            slopes.all.push_back(
                {(bed.bed(x + stride, y) - bed.bed(x - stride, y)) * unit / (reach * bed.scale.dx),
                 (bed.bed(x, y + stride) - bed.bed(x, y - stride)) * unit /
                     (reach * bed.scale.dy)});
            slopes.mean_east += slopes.all.back()[0];
            slopes.mean_north += slopes.all.back()[1];
            low = std::min(low, bed.bed(x, y) * unit);
            high = std::max(high, bed.bed(x, y) * unit);
        }
    }
    if (slopes.all.empty()) return slopes;
    const auto count = static_cast<double>(slopes.all.size());
    slopes.mean_east /= count;
    slopes.mean_north /= count;
    slopes.relief = (high - low) / std::max(nx * bed.scale.dx, ny * bed.scale.dy);
    return slopes;
}

/// Degrees, of a slope that nine tenths do not exceed.
double steep_slope(const Slopes& slopes) {
    std::vector<double> rises;
    rises.reserve(slopes.all.size());
    for (const auto& [east, north] : slopes.all) rises.push_back(east * east + north * north);
    if (rises.empty()) return 0.0;
    const auto tenth = rises.begin() + static_cast<std::ptrdiff_t>(rises.size() * 9 / 10);
    std::ranges::nth_element(rises, tenth);
    return elementary::atan2(std::sqrt(*tenth), 1.0) / degree;
}

/// The variance of a sun's light over some slopes.
double light_variance(const Slopes& slopes, double azimuth, double elevation) {
    const double level = elementary::cos(elevation * degree);
    const double east = elementary::sin(azimuth * degree) * level;
    const double north = elementary::cos(azimuth * degree) * level;
    const double up = elementary::sin(elevation * degree);
    double sum = 0.0;
    double squares = 0.0;
    for (const auto& [rise_east, rise_north] : slopes.all) {
        const double light = (up - rise_east * east - rise_north * north) /
                             std::sqrt(1.0 + rise_east * rise_east + rise_north * rise_north);
        sum += std::max(0.0, light);
        squares += std::max(0.0, light) * std::max(0.0, light);
    }
    const double count = std::max<double>(1.0, static_cast<double>(slopes.all.size()));
    return squares / count - sum / count * (sum / count);
}

void find_light(const StoredBeds& beds, const Snapshot& last, RunLook& look) {
    const Snapshot& first = beds.first();
    const View& view = beds.scene().view;
    look.own_sun = !view.sun.place.empty();
    const Slopes slopes =
        slopes_of(last, view.look.exaggeration.is_word() ? automatic_exaggeration(first)
                                                         : view.look.exaggeration.value);
    const bool wind_made = first.landform == Landform::bed || first.landform == Landform::profile;
    constexpr double cancelled = 0.2;  // of the winds' drift, up to which they have no direction
    const auto blown_to = wind_made ? downwind(first, cancelled) : std::nullopt;
    const double tilt =
        std::sqrt(slopes.mean_east * slopes.mean_east + slopes.mean_north * slopes.mean_north);
    if (blown_to) {
        look.sun_azimuth = std::fmod(azimuth_of(-blown_to->x, -blown_to->y) + past_the_wind, 360.0);
        look.camera_azimuth = std::fmod(look.sun_azimuth - wind_camera_azimuth + 360.0, 360.0);
    } else if ((!look.endless || look.land) && !look.section && tilt > 0.1 * slopes.relief) {
        // On the low side, a little beside the middle of an edge: blocks fill the picture then.
        constexpr double beside = 20.0;
        const double down = azimuth_of(-slopes.mean_east, -slopes.mean_north);
        look.camera_azimuth = std::fmod(90.0 * std::round(down / 90.0) + beside, 360.0);
    } else if (look.section) {
        look.camera_azimuth = 190.0;
    } else if (!look.endless) {
        look.camera_azimuth = 200.0;
    }
    if (!blown_to) {
        constexpr double aside = 75.0;
        constexpr double usual = 25.0;
        const double right = std::fmod(look.camera_azimuth - aside + 360.0, 360.0);
        const double left = std::fmod(look.camera_azimuth + aside, 360.0);
        const bool is_right =
            light_variance(slopes, right, usual) > 1.1 * light_variance(slopes, left, usual);
        look.sun_azimuth = is_right ? right : left;
    }
    const bool sands = wind_made && first.scale.in_metres;
    const double lowest_sun = sands ? 14.0 : 20.0;  // degrees
    constexpr double highest_sun = 33.0;            // degrees
    look.sun_elevation = std::clamp(0.5 * steep_slope(slopes), lowest_sun, highest_sun);
}

/// How far apart the bed crosses its mean upward, along the rows or the columns, the shorter.
double wavelength_of(const Snapshot& bed) {
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    double mean = 0.0;
    for (const double height : bed.bed.values()) mean += height;
    mean /= static_cast<double>(bed.bed.size());
    std::int64_t along_rows = 0;
    std::int64_t along_columns = 0;
    const auto above = [&](int x, int y) {
        const int east = std::min(x + 1, nx - 1);
        const int north = std::min(y + 1, ny - 1);
        const double square =
            bed.bed(x, y) + bed.bed(east, y) + bed.bed(x, north) + bed.bed(east, north);
        return square > 4.0 * mean;
    };
    for (int y = 0; y + 1 < ny; ++y) {
        for (int x = 0; x + 1 < nx; ++x) {
            if (above(x, y)) continue;
            if (above(x + 1, y)) ++along_rows;
            if (above(x, y + 1)) ++along_columns;
        }
    }
    const double side = std::max(nx * bed.scale.dx, ny * bed.scale.dy);
    const double cells = static_cast<double>(nx) * ny;
    const double rows =
        cells * bed.scale.dx / static_cast<double>(std::max<std::int64_t>(1, along_rows));
    const double columns =
        cells * bed.scale.dy / static_cast<double>(std::max<std::int64_t>(1, along_columns));
    return std::min(rows, columns) / side;
}

bool is_dry(const Snapshot& snapshot) {
    const Grid* depth = field_of(snapshot.fields, "water_depth");
    return depth == nullptr ||
           std::ranges::none_of(depth->values(), [](double value) { return value > 0.0; });
}

/// Whether a bed is flat but for what rises from it, as sand does from a beach, and not as high as
/// a mountain.
bool is_heaped(const Snapshot& snapshot) {
    std::vector<double> heights;
    for (std::size_t cell = 0; cell < snapshot.bed.size(); ++cell)
        if (snapshot.nodata.empty() || snapshot.nodata.values()[cell] == 0)
            heights.push_back(snapshot.bed.values()[cell]);
    if (heights.empty()) return false;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    const auto [low, high] = std::ranges::minmax(heights);
    constexpr double highest_sand = 100.0;  // metres
    if (snapshot.scale.in_metres && (high - low) * snapshot.scale.height_unit > highest_sand)
        return false;
    constexpr double higher = 4.0;
    return high - *middle > higher * (*middle - low);
}

void find_largest(const StoredBeds& beds, const Snapshot& last, RunLook& look) {
    switch (beds.first().landform) {
        case Landform::bed:
        case Landform::profile:
            look.largest = find_landmark("largest dune", last).breadth ==
                                   find_landmark("highest", last).breadth
                               ? "highest"
                               : "largest dune";
            return;
        case Landform::pile:
            look.largest = "highest";
            return;
        case Landform::terrain:
        case Landform::water:
            look.largest = "deepest channel";
            if (is_dry(*beds.snapshot(beds.beds().size() - 1)) && is_heaped(last))
                look.largest = "highest";
            return;
        case Landform::air:
            look.largest = "middle";
            return;
    }
}

/// Whether water stands deeper than its bed is uneven, as behind a dam.
bool is_flood(const Snapshot& first) {
    const Grid* depth = field_of(first.fields, "water_depth");
    if (depth == nullptr) return false;
    double low = INFINITY;
    double high = -INFINITY;
    for (std::size_t cell = 0; cell < first.bed.size(); ++cell) {
        if (!first.nodata.empty() && first.nodata.values()[cell] != 0) continue;
        low = std::min(low, first.bed.values()[cell]);
        high = std::max(high, first.bed.values()[cell]);
    }
    const double deepest = *std::ranges::max_element(depth->values());
    return deepest > (high - low) * first.scale.height_unit;
}

/// Land that is surveyed, and can be drawn in what goes on around it.
bool is_surveyed_land(const StoredBeds& beds, const View& view) {
    const Snapshot& first = beds.first();
    const bool is_land = first.landform == Landform::terrain || first.landform == Landform::water;
    return is_land && first.scale.in_metres && !beds.scene().bed.file.empty() &&
           view.look.light != LightKind::studio && endless_ground_obstacle(view, first) == nullptr;
}

std::string title_of(const Scene& scene) {
    std::string name = std::filesystem::path(scene.bed.file).stem().string();
    if (name.empty() || !name.starts_with(scene.title)) return scene.title;
    if (!scene.title.empty()) name = scene.title;
    std::ranges::replace(name, '_', ' ');
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z')
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

}  // namespace

RunLook look_at_run(const StoredBeds& beds) {
    RunLook look;
    const Snapshot& first = beds.first();
    View view = beds.scene().view;
    look.section = first.section != nullptr;
    look.endless = is_endless(view, first);
    view.camera.projection = Projection::perspective;
    const bool has_no_land =
        (first.periodic && first.landform == Landform::bed) || first.landform == Landform::pile;
    if (!look.endless && !look.section && has_no_land &&
        endless_ground_obstacle(view, first) == nullptr)
        look.endless = look.widened = true;
    look.flood = first.landform == Landform::water && !look.section && is_flood(first);
    if (!look.endless && !look.section && !look.flood && is_surveyed_land(beds, view)) {
        look.endless = look.land = true;
        const Grid fallen =
            first.rain != nullptr ? first.rain(0.0, beds.beds().back().time) : Grid();
        look.showery =
            view.air.clouds == Clouds::none &&
            std::ranges::any_of(fallen.values(), [](double height) { return height > 0.0; });
    }
    find_pace(beds, look);
    const auto last = beds.heights(beds.beds().size() - 1);
    find_light(beds, *last, look);
    look.wavelength = wavelength_of(*last);
    find_largest(beds, *last, look);
    const auto longer = static_cast<double>(std::max(last->bed.nx(), last->bed.ny()));
    look.breadth = find_landmark(look.largest, *last).breadth / longer;
    look.title = title_of(beds.scene());
    return look;
}

}  // namespace fumon
