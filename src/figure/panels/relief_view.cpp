#include "figure/panels/relief_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/compensated_sum.h"
#include "base/elementary_angle.h"
#include "base/units.h"
#include "render/view/block.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double circle_degrees = 360.0;
constexpr double sun_from_camera_degrees =
    110.0;  // degrees clockwise from it: the upper left of the picture
constexpr double freest_turn_degrees =
    75.0;  // degrees off the line across the crests, of a bed without
constexpr double least_turn_degrees = 20.0;  // and of parallel ones
constexpr double sun_elevation_degrees = 38.0;
constexpr double block_thickness_share =
    0.02;  // of the block under the lowest place, in longer sides
constexpr double headroom_share = 0.005;
constexpr double outline_level = 70.0;  // of 255

/// An angle in −180 … 180 degrees.
double about_zero(double angle) {
    return angle - circle_degrees * std::round(angle / circle_degrees);
}

/// Least and greatest height of some snapshots, as their pictures count heights.
struct Span {
    double low = 0.0;
    double high = 0.0;
};

Span span_of(const Snapshot& snapshot, bool from_mean) {
    const HeightStatistics heights = height_statistics(snapshot.bed, snapshot.nodata);
    const double from = from_mean ? heights.mean : 0.0;
    return {heights.low - from, heights.high - from};
}

const Snapshot& roughest_of(const Snapshot& first, std::span<const Snapshot> snapshots) {
    const Snapshot* roughest = &first;
    double most = -1.0;
    for (const Snapshot& snapshot : snapshots) {
        const Span heights = span_of(snapshot, false);
        if (heights.high - heights.low <= most) continue;
        most = heights.high - heights.low;
        roughest = &snapshot;
    }
    return *roughest;
}

void fit_block(View& view, const Snapshot& first, std::span<const Snapshot> snapshots) {
    LookSettings& look = view.look;
    const bool from_mean = counts_from_own_mean(look, first);
    const auto shown_span = [&](const Snapshot& snapshot) {
        const std::optional<Snapshot> part = shown_snapshot(snapshot, view);  // of a profile
        return span_of(part ? *part : snapshot, from_mean);
    };
    const Span begin = shown_span(first);
    Span all = begin;
    for (const Snapshot& snapshot : snapshots) {
        const Span heights = shown_span(snapshot);
        all = {std::min(all.low, heights.low), std::max(all.high, heights.high)};
    }
    const std::optional<Snapshot> strip = shown_snapshot(first, view);
    const Grid& bed = strip ? strip->bed : first.bed;
    const WorldScale& scale = strip ? strip->scale : first.scale;
    const double side = std::max(bed.nx() * scale.dx, bed.ny() * scale.dy);
    const double length = side / (scale.height_unit * look.exaggeration.value);
    look.footing = {"", begin.low - all.low + block_thickness_share * length};
    if (look.room.is_word() && !has_water(first) && !first.section)
        look.room = {"", all.high - begin.high + headroom_share * length};
}

}  // namespace

SlopeDirection slope_direction(const Snapshot& snapshot) {
    const Grid& bed = snapshot.bed;
    CompensatedSum east_squared;
    CompensatedSum north_squared;
    CompensatedSum product;
    const auto known = [&](int x, int y) {
        return snapshot.nodata.empty() || snapshot.nodata(x, y) == 0;
    };
    for (int y = 1; y + 1 < bed.ny(); ++y) {
        for (int x = 1; x + 1 < bed.nx(); ++x) {
            if (!known(x - 1, y) || !known(x + 1, y) || !known(x, y - 1) || !known(x, y + 1))
                continue;
            const double east = (bed(x + 1, y) - bed(x - 1, y)) / snapshot.scale.dx;
            const double north = (bed(x, y + 1) - bed(x, y - 1)) / snapshot.scale.dy;
            east_squared.add(east * east);
            north_squared.add(north * north);
            product.add(east * north);
        }
    }
    const double sum = east_squared.value() + north_squared.value();
    if (!(sum > 0.0)) return {};
    const double difference = north_squared.value() - east_squared.value();
    const double twice = 2.0 * product.value();
    SlopeDirection slopes;
    slopes.azimuth = 0.5 * elementary::atan2(twice, difference) / degree;
    if (slopes.azimuth < 0.0) slopes.azimuth += 0.5 * circle_degrees;
    slopes.coherence = std::sqrt(difference * difference + twice * twice) / sum;
    return slopes;
}

double relief_light_azimuth(const SlopeDirection& slopes, double camera_azimuth) {
    const double wanted = camera_azimuth + sun_from_camera_degrees;
    double off = about_zero(wanted - slopes.azimuth);  // to the nearer end of the axis
    double across = slopes.azimuth;
    if (std::abs(off) > 0.25 * circle_degrees) {
        across += 0.5 * circle_degrees;
        off = about_zero(wanted - across);
    }
    const double most =
        std::lerp(freest_turn_degrees, least_turn_degrees, std::min(1.0, 1.5 * slopes.coherence));
    const double azimuth = across + std::clamp(off, -most, most);
    return azimuth - circle_degrees * std::floor(azimuth / circle_degrees);
}

View relief_view(View view, const Snapshot& first, std::span<const Snapshot> snapshots) {
    view.look.mode = ViewMode::figure;
    view.look.relief = FigureRelief::clear;
    if (!first.section) view.look.background = Background::transparent;
    const Snapshot& roughest = roughest_of(first, snapshots);
    const SunSettings usual;
    const bool sun_is_usual = view.sun.azimuth == usual.azimuth &&
                              view.sun.elevation == usual.elevation && view.sun.place.empty();
    if (sun_is_usual) {
        view.sun.azimuth = relief_light_azimuth(slope_direction(roughest), view.camera.azimuth);
        view.sun.elevation = sun_elevation_degrees;
    }
    if (view.look.exaggeration.is_word())
        view.look.exaggeration = {"", figure_exaggeration(roughest)};
    if (view.look.footing.is_word()) fit_block(view, first, snapshots);
    return view;
}

Image outlined(const Image& image, double width) {
    if (!image.transparent()) return image;
    Image drawn = composited_on(image, 255);
    const int reach = std::max(1, static_cast<int>(std::ceil(width)));
    const auto alpha = [&](int x, int y) -> double {
        if (x < 0 || y < 0 || x >= image.width || y >= image.height) return 0.0;
        return image.alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x)] /
               255.0;
    };
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* pixel = drawn.row(y);
        for (int x = 0; x < image.width; ++x, pixel += 3) {
            const double here = alpha(x, y);
            if (here == 0.0) continue;
            double open = 0.0;  // how near what is seen through lies
            for (int v = -reach; v <= reach; ++v) {
                for (int u = -reach; u <= reach; ++u) {
                    const double apart = std::sqrt(static_cast<double>(u * u + v * v));
                    const double near = std::clamp(width + 0.5 - apart, 0.0, 1.0);
                    if (near > open) open = std::max(open, near * (1.0 - alpha(x + u, y + v)));
                }
            }
            const double share = here * open;
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(
                    std::lround(std::lerp(static_cast<double>(pixel[c]), outline_level, share)));
        }
    }
    return drawn;
}

}  // namespace fumon
