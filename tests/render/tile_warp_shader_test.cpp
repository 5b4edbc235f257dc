#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "gl/context.h"
#include "render/view/tile_warp_vectors.h"
#include "support/shader_values.h"

namespace fumon {
namespace {

constexpr int side = 64;
constexpr double strength = 0.83;
const glm::dvec2 extent(1.0, 0.7);
const glm::dvec2 eye_from_middle(0.4, -1.3);

/// Numbers of shaders/world/tile_warp.glsl over a square of the ground.
std::vector<glm::vec4> shaded(const glm::dvec2& corner, double across, int numbers) {
    return shader_values("tile_warp.frag.glsl", side, side, {{"varied", 1.0F}},
                         [&](const gl::Program& program) {
                             program.set("extent", glm::vec2(extent));
                             program.set("eye_from_middle", glm::vec2(eye_from_middle));
                             program.set("warp_strength", static_cast<float>(strength));
                             program.set("corner", glm::vec2(corner));
                             program.set("across", static_cast<float>(across));
                             program.set("numbers", numbers);
                         });
}

glm::dvec4 expected(const WarpedGround& copy, int numbers) {
    if (numbers == 0) return {copy.offset, copy.height, 0.0};
    if (numbers == 1) return {copy.jacobian[0], copy.jacobian[1]};
    const glm::dvec2 slope = (copy.height * (glm::dvec2(0.3, -0.2) * extent * copy.jacobian) +
                              0.02 / copy.height * copy.height_gradient) /
                             extent;
    return {copy.height_gradient, slope};
}

/// The ground's triangles and its shading, of the same copies.
TEST(WarpedGround, IsTheSameInTheShaders) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    for (const double across : {6.0, 90.0}) {
        const glm::dvec2 corner(-0.45 * across, -0.6 * across);
        for (const int numbers : {0, 1, 2}) {
            const std::vector<glm::vec4> found = shaded(corner, across, numbers);
            int apart = 0;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::dvec2 offset =
                        corner + across * glm::dvec2(x + 0.5, y + 0.5) / double{side};
                    const WarpedGround copy =
                        tile_warp::warp_at(eye_from_middle + offset / extent, strength);
                    const glm::dvec4 off =
                        glm::abs(glm::dvec4(found[static_cast<std::size_t>(y * side + x)]) -
                                 expected(copy, numbers));
                    const double most = std::max({off.x, off.y, off.z, off.w});
                    apart += most > 2e-5 ? 1 : 0;
                    ASSERT_LT(most, 2e-4) << across << ' ' << numbers << ' ' << x << ' ' << y;
                }
            }
            EXPECT_LT(apart, 40) << across << ' ' << numbers << ": rounding far away";
        }
    }
}

}  // namespace
}  // namespace fumon
