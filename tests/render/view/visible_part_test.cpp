#include "render/view/visible_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "render/view/framing.h"
#include "support/view_beds.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

View view_of(std::vector<double> at, std::vector<double> look_at) {
    View view;
    view.image.width = 640;
    view.image.height = 360;
    view.camera.at = std::move(at);
    view.camera.look_at = std::move(look_at);
    view.look.exaggeration = {"", 1.0};
    return view;
}

struct Seen {
    Block block;
    Camera camera;
    VisiblePart part;
};

Seen seen_of(const View& view) {
    const Snapshot bed = flat_bed(200, 120);
    const Block block = framed_block(view, bed);
    const Camera camera = camera_at_step(view, block, 0, 1);
    return {block, camera, visible_part(camera, view, block)};
}

TEST(VisiblePart, IsTheWholeBlockFromAfar) {
    const Seen seen = seen_of(view_of({}, {}));
    EXPECT_EQ(seen.part.low, glm::dvec2(0.0));
    EXPECT_EQ(seen.part.high, glm::dvec2(1.0));
    const double middle = pixels_per_length(seen.camera, view_of({}, {}));
    EXPECT_GT(seen.part.sharpness, middle);
    EXPECT_LT(seen.part.sharpness, 1.5 * middle);
}

/// Every place of the ground that a picture shows lies in the part.
void expect_held(const Seen& seen) {
    const glm::dmat4 clip = clip_matrix(seen.camera);
    int inside = 0;
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 300; ++x) {
            const glm::dvec2 position = (glm::dvec2(x, y) + 0.5) / 300.0;
            const glm::dvec4 at =
                clip * glm::dvec4((position.x - 0.5) * seen.block.width_x,
                                  (position.y - 0.5) * seen.block.width_y, seen.block.surface, 1.0);
            if (at.w <= 0.0 || std::abs(at.x) > at.w || std::abs(at.y) > at.w) continue;
            ++inside;
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(position, seen.part.low)) &&
                        glm::all(glm::lessThanEqual(position, seen.part.high)))
                << position.x << " " << position.y;
        }
    }
    EXPECT_GT(inside, 5000);
}

TEST(VisiblePart, HoldsEveryPlaceThatIsSeenFromNear) {
    const Seen seen = seen_of(view_of({60, 20, 6}, {100, 50, 0}));
    EXPECT_GT(seen.part.low.x, 0.1);
    EXPECT_GT(seen.part.sharpness, 3.0 * seen_of(view_of({}, {})).part.sharpness);
    expect_held(seen);
}

TEST(VisiblePart, HoldsEveryPlaceThatIsSeenFromAboveAndLittleMore) {
    const Seen seen = seen_of(view_of({100, 59, 90}, {100, 60, 0}));
    EXPECT_GT(seen.part.low.x, 0.05);
    EXPECT_LT(seen.part.high.x, 0.95);
    expect_held(seen);
}

TEST(VisiblePart, IsAllThroughALens) {
    View view = view_of({60, 20, 6}, {100, 50, 0});
    view.camera.f_number = {"", 2.0};
    const Seen seen = seen_of(view);
    EXPECT_EQ(seen.part.low, glm::dvec2(0.0));
    EXPECT_EQ(seen.part.high, glm::dvec2(1.0));
}

}  // namespace
}  // namespace fumon
