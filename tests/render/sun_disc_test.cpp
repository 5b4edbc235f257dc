#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/view/block.h"
#include "render/view/camera.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

Snapshot level_bed() {
    Snapshot bed;
    bed.bed = Grid(60, 60);
    bed.periodic = true;
    return bed;
}

/// Northward, a little upward, the sun in the middle of the sky that is seen; so dark that its
/// surroundings do not saturate.
View towards_sun(double azimuth, double elevation, int height = 180) {
    View view = small_view(height * 16 / 9, height);
    view.look.ground = Ground::endless;
    view.look.exposure = -5.0;
    view.camera.at = {30.0, 10.0, 8.0};
    view.camera.look_at = {30.0, 50.0, 14.0};
    view.camera.field_of_view = 40.0;
    view.sun.azimuth = azimuth;
    view.sun.elevation = elevation;
    view.air.aerosol = Aerosol::thin;  // which leaves the sky around the sun dark
    return view;
}

glm::dvec2 place_of_sun(const View& view) {
    const double pitch = std::atan2(6.0, 40.0);
    const double degrees = std::numbers::pi / 180.0;
    const double azimuth = view.sun.azimuth * degrees;
    const double up = std::sin(view.sun.elevation * degrees);
    const double level = std::cos(view.sun.elevation * degrees);
    const glm::dvec3 to_sun(std::sin(azimuth) * level, std::cos(azimuth) * level, up);
    const double depth = to_sun.y * std::cos(pitch) + to_sun.z * std::sin(pitch);
    const double higher = to_sun.z * std::cos(pitch) - to_sun.y * std::sin(pitch);
    const double scale = 0.5 * static_cast<double>(view.image.height) /
                         std::tan(0.5 * view.camera.field_of_view * degrees);
    return {0.5 * static_cast<double>(view.image.width) + scale * to_sun.x / depth,
            0.5 * static_cast<double>(view.image.height) - scale * higher / depth};
}

double green(const Image& image, const glm::dvec2& position) {
    return image.row(static_cast<int>(position.y))[3 * static_cast<std::ptrdiff_t>(position.x) + 1];
}

/// How much of the pixels around a place is brighter than halfway from what is around to what is
/// brightest, by how much each is.
double bright_area(const Image& image, const glm::dvec2& position, double radius) {
    double most = 0.0;
    double least = 255.0;
    const auto each = [&](const auto& body) {
        const int reach = static_cast<int>(std::ceil(3.0 * radius));
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) body(green(image, position + glm::dvec2(x, y)));
    };
    each([&](double value) {
        most = std::max(most, value);
        least = std::min(least, value);
    });
    double area = 0.0;
    each([&](double value) { area += std::clamp((value - least) / (most - least), 0.0, 1.0); });
    return area;
}

TEST(SunDisc, IsAsLargeWhereverItFallsBetweenPixels) {
    double least = 1e9;
    double most = 0.0;
    for (const double aside : {0.0, 0.05, 0.11, 0.17, 0.23}) {
        const View view = towards_sun(aside, 14.0 + aside);
        const double radius = 0.004675 * 90.0 / std::tan(20.0 * std::numbers::pi / 180.0);
        const double area = bright_area(picture(view, level_bed()), place_of_sun(view), radius);
        least = std::min(least, area);
        most = std::max(most, area);
    }
    EXPECT_LT(most, 1.1 * least);
}

/// Its edge is no staircase of white on blue.
TEST(SunDisc, HasASoftEdge) {
    for (const LightSource source : {LightSource::sun, LightSource::moon}) {
        View view = towards_sun(0.13, 14.2, 720);
        view.sun.source = source;
        if (source == LightSource::moon) view.look.exposure = 0.0;
        const Image image = picture(view, level_bed());
        const glm::dvec2 middle = place_of_sun(view);
        double steepest = 0.0;
        for (int x = 1; x < 40; ++x)
            steepest = std::max(steepest, std::abs(green(image, middle + glm::dvec2(x, 0.0)) -
                                                   green(image, middle + glm::dvec2(x - 1, 0.0))));
        const double rises = green(image, middle) - green(image, middle + glm::dvec2(40.0, 0.0));
        EXPECT_GT(rises, 40.0);
        EXPECT_LT(steepest, 0.65 * rises);
    }
}

Snapshot bed_with_a_wall() {
    Snapshot bed = level_bed();
    for (int y = 30; y < 33; ++y)
        for (int x = 0; x < 60; ++x) bed.bed(x, y) = 12.0;
    return bed;
}

/// What hides the sun hides its glare, too.
TEST(SunDisc, GlareEndsBehindDunes) {
    View view = towards_sun(0.0, 1.0);
    view.look.exposure = 0.0;
    const glm::dvec2 position = place_of_sun(view);
    const Image image = picture(view, bed_with_a_wall());
    const double there = green(image, position);
    const double beside = green(image, position + glm::dvec2(12.0, 0.0));
    EXPECT_NEAR(there, beside, 12.0);
    const Image open = picture(view, level_bed());
    EXPECT_GT(green(open, position), there + 60.0);
}

/// Likewise clouds, which are thick with such a cover.
TEST(SunDisc, GlareEndsBehindClouds) {
    View view = towards_sun(0.0, 14.0);
    view.look.exposure = -2.0;
    const glm::dvec2 position = place_of_sun(view);
    const auto rises = [&](const View& of) {
        const Image image = picture(of, level_bed());
        return green(image, position + glm::dvec2(3.0, 0.0)) -
               green(image, position + glm::dvec2(14.0, 0.0));
    };
    const double clear = rises(view);
    EXPECT_GT(clear, 15.0);
    view.air.clouds = Clouds::cumulus;
    view.air.cloud_cover = 1.0;
    EXPECT_LT(rises(view), 0.6 * clear);
}

}  // namespace
}  // namespace fumon
