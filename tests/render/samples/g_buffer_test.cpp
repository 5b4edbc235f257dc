#include "render/samples/g_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fumon {
namespace {

// A look between texels of a mipmap takes from all cells of the two nearest along each axis.
TEST(GBuffer, AKindIsTheHighestOfThoseThatALookMayMeet) {
    const double closes = 0.004;
    for (const int nx : {32, 37}) {
        Field<float> depth(nx, 32);
        std::ranges::fill(depth.values(), 0.1F * static_cast<float>(closes));
        depth(17, 9) = 10.0F * static_cast<float>(closes);
        depth(5, 25) = static_cast<float>(closes);
        const g_buffer_vectors::KindMap map = kind_map(depth, closes);
        ASSERT_EQ(map.levels.size(), 3U);
        for (std::size_t i = 0; i < map.levels.size(); ++i) {
            const g_buffer_vectors::KindMap::Level& level = map.levels[i];
            EXPECT_EQ(level.width, nx >> (i + 1));
            const auto meets = [&](int x, int y, double cell_x, double cell_y) {
                // The cell reaches to the middles of neighbours of a texel, widened by half of it.
                const double wide = static_cast<double>(nx) / level.width;
                const double high = 32.0 / level.height;
                return cell_x + 1.0 > (x - 1) * wide && cell_x < (x + 2) * wide &&
                       cell_y + 1.0 > (y - 1) * high && cell_y < (y + 2) * high;
            };
            for (int y = 0; y < level.height; ++y) {
                for (int x = 0; x < level.width; ++x) {
                    const int expected = meets(x, y, 17, 9)   ? shows_any
                                         : meets(x, y, 5, 25) ? shows_film
                                                              : shows_dry_ground;
                    const auto at = static_cast<std::size_t>(level.first + y * level.width + x);
                    EXPECT_EQ(int{map.kinds[at]}, expected)
                        << nx << " " << i << " " << x << " " << y;
                }
            }
        }
    }
}

}  // namespace
}  // namespace fumon
