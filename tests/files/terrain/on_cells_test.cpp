#include "files/terrain/on_cells.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace fumon::test {
namespace {

Terrain grid_at(double west, double south, double size, int nx, int ny) {
    Terrain map;
    map.heights = Grid(nx, ny);
    map.place = GeoReference{west, south, size, size, false, ""};
    return map;
}

/// What a plane has at the middles of the cells.
void tilt(Terrain& map) {
    for (int y = 0; y < map.heights.ny(); ++y) {
        for (int x = 0; x < map.heights.nx(); ++x) {
            map.heights(x, y) = 3.0 * (map.place->west + (x + 0.5) * map.place->dx) -
                                (map.place->south + (y + 0.5) * map.place->dy);
        }
    }
}

std::string refusal(const Terrain& map, const CellLattice& lattice) {
    try {
        on_cells(map, lattice);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "";
}

TEST(OnCells, APlaneStaysOneOnFinerCellsThatLieElsewhere) {
    Terrain map = grid_at(100.0, 200.0, 8.0, 6, 5);
    tilt(map);
    const CellLattice fine{9, 7, GeoReference{111.0, 207.5, 2.5, 2.5, false, ""}};
    const Terrain brought = on_cells(map, fine);
    EXPECT_TRUE(brought.nodata.empty());
    for (int y = 0; y < fine.ny; ++y) {
        for (int x = 0; x < fine.nx; ++x) {
            EXPECT_NEAR(brought.heights(x, y),
                        3.0 * (111.0 + 2.5 * (x + 0.5)) - (207.5 + 2.5 * (y + 0.5)), 1e-10);
        }
    }
}

TEST(OnCells, TheSameCellsKeepTheirVeryValues) {
    Terrain map = grid_at(0.1, 7.3, 0.3, 11, 4);
    for (int k = 0; k < 44; ++k) map.heights.values()[static_cast<std::size_t>(k)] = 0.1 * k * k;
    const Terrain part =
        on_cells(map, {5, 2, GeoReference{0.1 + 4 * 0.3, 7.6, 0.3, 0.3, false, ""}});
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 5; ++x) EXPECT_EQ(part.heights(x, y), map.heights(x + 4, y + 1));
    }
}

TEST(OnCells, HolesStayHolesAndGiveNothingToTheirNeighbours) {
    Terrain map = grid_at(10.0, 10.0, 2.0, 3, 1);
    map.heights(0, 0) = 4.0;
    map.heights(2, 0) = 8.0;
    map.nodata = Mask(3, 1);
    map.nodata(1, 0) = 1;
    const Terrain brought = on_cells(map, {8, 2, GeoReference{9.0, 10.0, 1.0, 1.0, false, ""}});
    const std::vector<std::uint8_t> holes{0, 0, 0, 1, 1, 0, 0, 0};
    const std::vector<double> values{4.0, 4.0, 4.0, 0.0, 0.0, 8.0, 8.0, 8.0};
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(brought.nodata(x, 0), holes[static_cast<std::size_t>(x)]) << x;
        EXPECT_EQ(brought.heights(x, 1), values[static_cast<std::size_t>(x)]) << x;
    }
    const Terrain beyond = on_cells(map, {2, 1, GeoReference{8.0, 10.0, 1.0, 1.0, false, ""}});
    EXPECT_EQ(beyond.nodata(0, 0), 1) << "more than half a cell outside";
    EXPECT_EQ(beyond.nodata(1, 0), 0);
}

TEST(OnCells, WithoutAPlaceTheSizeDecides) {
    Terrain map = grid_at(0.0, 0.0, 1.0, 4, 3);
    map.heights(3, 2) = 7.0;
    EXPECT_EQ(on_cells(map, {4, 3, std::nullopt}).heights(3, 2), 7.0);
    EXPECT_EQ(on_cells(map, {4, 3, GeoReference{5.0, 5.0, 1.0, 1.0, false, ""}}).heights(3, 2),
              7.0);
    EXPECT_EQ(refusal(map, {8, 6, std::nullopt}),
              "has 4 x 3 cells, but the bed has 8 x 6; give it the same size, or give both files "
              "coordinates");
}

TEST(OnCells, DegreesAreNoMetres) {
    Terrain map = grid_at(10.0, 45.0, 0.1, 4, 3);
    map.place->degrees = true;
    EXPECT_EQ(refusal(map, {4, 3, GeoReference{5e5, 5e6, 30.0, 30.0, false, ""}}),
              "has coordinates in degrees, but the bed has them in metres; reproject one of them");
    EXPECT_EQ(refusal(map, {4, 3, GeoReference{10.0, 45.0, 0.1, 0.1, true, ""}}), "");
}

}  // namespace
}  // namespace fumon::test
