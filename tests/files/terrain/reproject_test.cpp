#include "files/terrain/reproject.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/gdal/gdal_functions.h"
#include "files/terrain/terrain_file.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

/// A plane that rises by a metre a degree of latitude, over Colorado, with one cell without data.
Terrain plane_in_degrees() {
    Terrain terrain;
    terrain.heights = Grid(60, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) terrain.heights(x, y) = 1000.0 * (40.0 + (y + 0.5) * 0.001);
    terrain.nodata = Mask(60, 40);
    terrain.nodata(30, 20) = 1;
    terrain.place = GeoReference{-105.55, 40.0, 0.001, 0.001, true, ""};
    terrain.note =
        "cell size 0.001° read as degrees and converted to metres at the middle "
        "latitude 40.02°: dx = 1 m, dy = 1 m; another";
    return terrain;
}

TEST(Reprojected, ToUtmLiesWhereProjSays) {
    const Terrain metric = reprojected(plane_in_degrees(), "utm");
    ASSERT_TRUE(metric.place);
    EXPECT_EQ(metric.dx, metric.dy);
    EXPECT_FALSE(metric.place->degrees);
    EXPECT_NE(metric.place->crs.find("32613"), std::string::npos) << metric.place->crs;
    EXPECT_TRUE(metric.note.starts_with("another; reprojected to EPSG:32613: ")) << metric.note;
    // A cell's centre brought back by PROJ has the plane's height.
    OGRSpatialReferenceH from = OSRNewSpatialReference(nullptr);
    OGRSpatialReferenceH to = OSRNewSpatialReference(nullptr);
    OSRSetFromUserInput(from, "EPSG:32613");
    OSRSetFromUserInput(to, "EPSG:4326");
    OSRSetAxisMappingStrategy(from, OAMS_TRADITIONAL_GIS_ORDER);
    OSRSetAxisMappingStrategy(to, OAMS_TRADITIONAL_GIS_ORDER);
    OGRCoordinateTransformationH back = OCTNewCoordinateTransformation(from, to);
    int holes = 0;
    int compared = 0;
    for (int y = 5; y < metric.heights.ny() - 5; ++y) {
        for (int x = 5; x < metric.heights.nx() - 5; ++x) {
            if (metric.nodata(x, y) != 0) {
                ++holes;
                continue;
            }
            double east = metric.place->west + (x + 0.5) * metric.dx;
            double north = metric.place->south + (y + 0.5) * metric.dy;
            ASSERT_NE(OCTTransform(back, 1, &east, &north, nullptr), 0);
            EXPECT_NEAR(metric.heights(x, y), 1000.0 * north, 1000.0 * 0.25 * 0.001);
            ++compared;
        }
    }
    OCTDestroyCoordinateTransformation(back);
    OSRDestroySpatialReference(from);
    OSRDestroySpatialReference(to);
    EXPECT_GE(holes, 1);
    EXPECT_LE(holes, 4);
    EXPECT_GT(compared, 1000);
}

TEST(Reprojected, RefusesWhatIsNoPlaneInMetres) {
    const auto refusal = [](Terrain terrain, const std::string& crs) {
        return message_of<InputError>([&] { (void)reprojected(terrain, crs); });
    };
    EXPECT_NE(refusal(plane_in_degrees(), "EPSG:4326").find("is not in metres"), std::string::npos);
    EXPECT_NE(refusal(plane_in_degrees(), "EPSG:2231").find("is not in metres"), std::string::npos)
        << "feet";
    EXPECT_NE(refusal(plane_in_degrees(), "nonsense").find("is not a reference system"),
              std::string::npos);
    Terrain nowhere = plane_in_degrees();
    nowhere.place->degrees = false;
    EXPECT_NE(refusal(nowhere, "EPSG:32613").find("has no coordinate reference system"),
              std::string::npos);
    nowhere.place->crs = "EPSG:32613";
    EXPECT_NE(refusal(nowhere, "utm").find("is already projected"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
