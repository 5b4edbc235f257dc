#include "render/light/avalanche_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/worker_pool.h"

namespace fumon {
namespace {

constexpr int nx = 70;  // more than two words of cells, and no whole number of them
constexpr int ny = 9;

/// Level cells on which nothing slid.
struct Maps {
    LightTexels texels = LightTexels(std::size_t{4} * nx * ny, 32767);
    std::vector<std::uint8_t> surface = std::vector<std::uint8_t>(std::size_t{2} * nx * ny, 0);

    static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * nx + x); }
    void tilt(int x, int y, double slope) {
        const double part = slope / std::sqrt(1.0 + slope * slope);
        texels[4 * at(x, y) + 1] = static_cast<std::uint16_t>(std::lround(32767.0 * (1.0 - part)));
    }
    void slide(int x, int y) { surface[2 * at(x, y) + 1] = 1; }
    [[nodiscard]] AvalancheCells cells() const {
        WorkerPool pool(2);
        return avalanche_cells(texels, surface, nx, ny, min_avalanche_slope, pool);
    }
};

int count(const AvalancheCells& cells) {
    int sum = 0;
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) sum += cells.at(x, y) ? 1 : 0;
    return sum;
}

TEST(AvalancheCells, AreThoseBesideBothSteepGroundAndSandThatSlid) {
    Maps maps;
    maps.tilt(33, 4, 0.43);
    EXPECT_EQ(count(maps.cells()), 0) << "nothing slid";
    maps.slide(35, 5);
    const AvalancheCells cells = maps.cells();
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            EXPECT_EQ(cells.at(x, y), x == 34 && (y == 4 || y == 5)) << x << " " << y;
    maps.tilt(33, 4, 0.41);
    EXPECT_EQ(count(maps.cells()), 0) << "no ground is steep";
}

TEST(AvalancheCells, GoOnBeyondTheEdges) {
    Maps maps;
    maps.tilt(0, 0, 0.6);
    maps.slide(nx - 1, ny - 1);
    const AvalancheCells cells = maps.cells();
    EXPECT_EQ(count(cells), 4);
    for (const int x : {0, nx - 1})
        for (const int y : {0, ny - 1}) EXPECT_TRUE(cells.at(x, y)) << x << " " << y;
}

}  // namespace
}  // namespace fumon
