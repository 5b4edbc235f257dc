#include "render/light/repeated_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "base/worker_pool.h"
#include "render/light/light.h"
#include "render/view/framing.h"
#include "support/drawn_picture.h"

namespace fumon {
namespace {

/// Ridges of sites 24 apart that rise by a tenth over 20 of them and fall over three.
Snapshot ridges_with_slip_faces() {
    Snapshot snapshot;
    snapshot.bed = Grid(48, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 48; ++x) {
            const int along = x % 24;
            snapshot.bed(x, y) = along <= 20 ? 0.1 * along : 2.0 - 0.65 * (along - 20);
        }
    }
    return snapshot;
}

TEST(RepeatedLight, SandLiesAsItSlidOnSlipFacesAndACellAroundThem) {
    View view = small_view();
    view.look.ground = Ground::endless;
    view.look.exaggeration = {"", 1.0};
    const Snapshot bed = ridges_with_slip_faces();
    WorkerPool pool(1);
    constexpr int refinement = 3;
    const RepeatedLight light = repeated_light(bed, framed_block(view, bed), refinement, {},
                                               sun_direction(view.sun), {1.0, 0.0}, pool);
    ASSERT_EQ(light.surface.size(), 2 * light.z.size());
    const auto slid = [&](int site) {
        const int middle = refinement * site + refinement / 2;
        return int{light.surface[2 * static_cast<std::size_t>(middle) + 1]};
    };
    EXPECT_GE(slid(22), 250);
    EXPECT_GE(slid(22 + 24), 250);
    EXPECT_GE(slid(20), 250) << "the brink";
    for (const int site : {4, 10, 16, 28, 34, 40}) EXPECT_EQ(slid(site), 0) << site;
}

}  // namespace
}  // namespace fumon
