// Banks that water has cut, in shade: the bank across that stands in the sun lights them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/drawn_picture.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

/// Valleys 16 m apart along the north, whose banks fall at 38 degrees; none of it is wet.
Snapshot dry_valleys() {
    Snapshot bed = under_water(flat_bed(64, 64), 0.0, 0.0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) bed.bed(x, y) = 0.78 * std::abs((x + 8) % 16 - 7.5);
    return bed;
}

/// Mean display value, 0 … 255, at a share of the width, over the middle of the height.
double green_along(const Image& image, double x) {
    double sum = 0.0;
    for (int i = 0; i < 40; ++i) sum += colour_at(image, x, 0.3 + 0.01 * i)[1];
    return sum / 40.0;
}

TEST(BanksInShade, AreLitByTheBankAcross) {
    View view = small_view(128, 128);
    view.camera.projection = Projection::map;
    view.look.ground = Ground::table;
    view.look.sky = SkyModel::atmosphere;
    view.look.light = LightKind::sun;
    view.look.exaggeration = 1.0;
    view.sun.azimuth = 270.0;
    view.sun.elevation = 34.0;
    const Image image = picture(view, dry_valleys());
    double dark = 255.0;
    double bright = 0.0;
    for (double x = 0.3; x < 0.7; x += 0.01) {
        dark = std::min(dark, green_along(image, x));
        bright = std::max(bright, green_along(image, x));
    }
    EXPECT_GE(bright, 120.0);
    EXPECT_GE(dark, 0.34 * bright);
}

}  // namespace
}  // namespace fumon
