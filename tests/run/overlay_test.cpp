#include <gtest/gtest.h>

#include "picture/png.h"
#include "render/view/framing.h"
#include "run/still.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

std::string overlaid_scene() {
    std::string scene = small_scene();
    scene.replace(scene.find("width = 64\nheight = 48"), 22, "width = 480\nheight = 270");
    return scene +
           "[[overlay]]\nkind = \"title\"\n[[overlay]]\nkind = \"time\"\n"
           "[[overlay]]\nkind = \"parameters\"\ncorner = \"lower-left\"\n"
           "[[overlay]]\nkind = \"arrow\"\ncorner = \"upper-right\"\n"
           "[[overlay]]\nkind = \"plot\"\ny = \"celerity\"\ncorner = \"lower-right\"\nsize = 0.3\n";
}

class OverlayTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "scene.toml", overlaid_scene()); }

    Ended fumon_with(std::vector<std::string> arguments, const std::vector<std::string>& settings) {
        for (const std::string& setting : settings) {
            arguments.emplace_back("--set");
            arguments.push_back(setting);
        }
        return fumon(arguments, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(OverlayTest, AStillAndAgainGiveTheFrameOfTheRunWithItsLivePlot) {
    const std::vector<std::string> settings{"camera.turn=90", "output.measure_every=2",
                                            "output.measurements=false", "output.movie=false"};
    ASSERT_EQ(fumon_with({"run", "scene.toml", "-o", "out", "-q"}, settings).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/measurements.csv"));
    ASSERT_EQ(fumon_with({"still", "scene.toml", "--step", "15", "-o", "still.png", "-q"}, settings)
                  .status,
              0);
    const std::string frame = read_text(folder_ / "out/frames/frame_000003.png");
    EXPECT_EQ(read_text(folder_ / "still.png"), frame);
    ASSERT_EQ(fumon_with({"still", "scene.toml", "--time", "0", "-o", "first.png", "-q"}, settings)
                  .status,
              0);
    EXPECT_EQ(read_text(folder_ / "first.png"), read_text(folder_ / "out/frames/frame_000000.png"));

    const Ended again = fumon({"again", "out/frames/frame_000003.png"}, folder_.path());
    EXPECT_NE(again.errors.find("the same pixels"), std::string::npos) << again.errors;
    EXPECT_TRUE(read_manifest(folder_ / "out")["drawing"].contains("text_library"));
}

TEST_F(OverlayTest, TheLivePlotGoesOnWithEveryMeasurement) {
    const std::vector<std::string> plot{"output.movie=false", "overlay.0.show=false",
                                        "overlay.1.show=false", "overlay.2.show=false",
                                        "overlay.3.show=false"};
    std::vector<std::string> rarely = plot;
    rarely.emplace_back("output.measure_every=20");
    ASSERT_EQ(fumon_with({"run", "scene.toml", "-o", "often", "-q"}, plot).status, 0);
    ASSERT_EQ(fumon_with({"run", "scene.toml", "-o", "rarely", "-q"}, rarely).status, 0);
    EXPECT_EQ(read_png(folder_ / "often/frames/frame_000000.png"),
              read_png(folder_ / "rarely/frames/frame_000000.png"));
    EXPECT_NE(read_png(folder_ / "often/frames/frame_000003.png"),
              read_png(folder_ / "rarely/frames/frame_000003.png"));
    EXPECT_EQ(read_text(folder_ / "often/measurements.csv").substr(0, 9), "step,time");
}

TEST_F(OverlayTest, SwitchedOffTheyLeaveTheFrameAlone) {
    write_text(folder_ / "bare.toml", overlaid_scene().substr(0, overlaid_scene().find("[[")));
    std::vector<std::string> off;
    for (const char* number : {"0", "1", "2", "3", "4"})
        off.push_back("overlay." + std::string(number) + ".show=false");
    ASSERT_EQ(fumon_with({"still", "scene.toml", "-o", "off.png", "-q"}, off).status, 0);
    ASSERT_EQ(fumon_with({"still", "bare.toml", "-o", "bare.png", "-q"}, {}).status, 0);
    ASSERT_EQ(fumon_with({"still", "scene.toml", "-o", "on.png", "-q"}, {}).status, 0);
    EXPECT_EQ(read_png(folder_ / "off.png"), read_png(folder_ / "bare.png"));
    EXPECT_NE(read_png(folder_ / "on.png"), read_png(folder_ / "bare.png"));
}

TEST(StillCamera, AStillStandsOnTheGroundThatItDraws) {
    // A flat bed of which every cell has risen or fallen is looked at as the first one was.
    View view;
    view.look.exaggeration = 1.0;
    view.camera.projection = Projection::perspective;
    view.camera.at = {10.0, 12.0, 2.2};
    view.camera.look_at = {30.0, 20.0, 0.5};
    Snapshot first;
    first.bed = Grid(40, 30);
    first.scale = {1.0, 1.0, 0.5, true};
    for (const double rise : {7.0, -7.0}) {
        Snapshot later = first;
        for (double& height : later.bed.values()) height += rise;
        View still = view;
        stand_on_drawn_ground(still, first, later);
        EXPECT_NEAR(still.camera.look_at[2], 0.5 + 0.5 * rise, 1e-9);
        const Block block = framed_block(still, first);
        const Camera camera = above_ground(camera_at_step(still, block, 0, 1), block, later, {});
        EXPECT_NEAR(camera.eye.z / block.height_scale * 0.5, 0.5 * rise + 2.2, 1e-9);
    }
}

TEST_F(OverlayTest, AnErrorNamesItsPlaceAndNothingIsWritten) {
    const Ended column = fumon_with({"run", "scene.toml", "-o", "out"}, {"overlay.4.y=celery"});
    EXPECT_EQ(column.status, 2);
    EXPECT_NE(column.errors.find("--set 1"), std::string::npos) << column.errors;
    EXPECT_NE(column.errors.find("did you mean \"celerity\"?"), std::string::npos) << column.errors;
    const Ended key = fumon_with({"check", "scene.toml"}, {"overlay.2.keys=[\"model.crep_rate\"]"});
    EXPECT_EQ(key.status, 2);
    EXPECT_NE(key.errors.find("did you mean \"model.creep_rate\"?"), std::string::npos)
        << key.errors;
    const Ended small = fumon_with({"run", "scene.toml", "-o", "out"}, {"image.width=100"});
    EXPECT_EQ(small.status, 2);
    EXPECT_NE(small.errors.find("scene.toml:"), std::string::npos) << small.errors;
    EXPECT_NE(small.errors.find("does not fit into a picture of 100 x 270"), std::string::npos)
        << small.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace fumon::test
