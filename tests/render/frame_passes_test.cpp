#include "render/frame_passes.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string_view>

#include "gl/context.h"
#include "render/tile_drawing.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

template <typename Drawing>
void expect_names_once(std::span<const Pass<Drawing>> passes) {
    std::set<std::string_view> names;
    for (const Pass<Drawing>& pass : passes)
        EXPECT_TRUE(names.insert(pass.name).second) << pass.name;
}

TEST(FramePasses, HaveNamesOfTheirOwn) {
    expect_names_once(picture_passes());
    expect_names_once(block_passes());
    expect_names_once(sample_passes());
}

TEST(FramePasses, EndInThePicture) {
    for (const auto& passes : {block_passes(), sample_passes()}) {
        EXPECT_TRUE(passes.back().writes.has(Target::picture));
        EXPECT_EQ(passes.back().needed, &TileDrawing::always);
    }
}

TEST(FramePasses, TargetsAreSets) {
    const Targets both{Target::visibility, Target::picture};
    EXPECT_TRUE(both.has(Target::visibility));
    EXPECT_FALSE(both.has(Target::coverage));
    EXPECT_TRUE(both.has(Targets{Target::picture}));
    EXPECT_TRUE(both.has(Targets{}));
    EXPECT_FALSE(both.has(Targets{Target::picture, Target::coverage}));
    EXPECT_TRUE((Targets{Target::coverage} | both).has(Targets{Target::picture, Target::coverage}));
}

/// What a line says of its pass is true: a target that it does not name is refused.
TEST(FramePasses, UseNoTargetThatTheirLineDoesNotName) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    context->make_current();
    WorkerPool pool(1);
    const View view = small_view(32, 18);
    Snapshot bed;
    bed.bed = Grid(8, 6, 1.0);
    RendererState state(*context, view, bed, 1, pool, {}, PixelFormat::display_8);
    Image image(32, 18);
    const Camera camera = state.camera_at(0);
    const Tile tile = state.plan.tiles.front();
    const auto draw = [&](const Targets& writes) {
        TileDrawing drawing(state, tile, camera, &image);
        const Pass<TileDrawing> pass{
            "clear", &TileDrawing::always, writes, &TileDrawing::clear_samples, {}};
        run(std::span(&pass, 1), drawing);
    };
    EXPECT_NO_THROW(draw({Target::sample_colours}));
    EXPECT_THROW(draw({}), std::logic_error);
    EXPECT_THROW(draw({Target::visibility, Target::picture}), std::logic_error);
}

}  // namespace
}  // namespace fumon
