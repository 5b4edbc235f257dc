#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "models/registry.h"
#include "picture/baseline.h"
#include "picture/png.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A folder with a small scene and a baseline of two cases, of which the map keeps its picture.
class Verify : public ::testing::Test {
  protected:
    Verify() {
        write_text(folder_ / "scene.toml", small_scene());
        write_baseline("");
    }

    /// `settings` go into both cases, behind the first.
    void write_baseline(const std::string& settings) const {
        write_text(folder_ / "b.toml",
                   "scene = \"scene.toml\"\nstep = 10\n" + settings +
                       "[cases]\nperspective = {}\n"
                       "map = {settings = [\"camera.projection=map\"], picture = true}\n");
    }

    [[nodiscard]] Ended verify(const std::vector<std::string>& more = {},
                               const std::vector<std::string>& environment = {}) const {
        std::vector<std::string> arguments{"verify", "b.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path(), environment);
    }

    void accept() const {
        const Ended ended = verify({"--update", "--pinned"});
        ASSERT_EQ(ended.status, 0) << ended.output << ended.errors;
    }

    ScratchFolder folder_;
};

TEST_F(Verify, MissingBaselinesFailAndLeaveThePicturesForReview) {
    const Ended ended = verify({"-o", "out", "--junit", "junit.xml"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_EQ(ended.output,
              "MISSING  b perspective: nothing is recorded; look at the picture, then `fumon "
              "verify --update`\n"
              "MISSING  b map: nothing is recorded; look at the picture, then `fumon verify "
              "--update`\n"
              "0 of 2 as recorded; see out/index.html\n");
    EXPECT_EQ(read_png(folder_ / "out/b/map-got.png").width, 64);
    EXPECT_TRUE(fs::exists(folder_ / "out/index.html"));
    EXPECT_TRUE(contains(read_text(folder_ / "junit.xml"), "failures=\"2\""));
    EXPECT_FALSE(fs::exists(folder_ / "b.lock"));
}

TEST_F(Verify, PassesAfterUpdateAndLeavesNothing) {
    const std::string cases = read_text(folder_ / "b.toml");
    const Ended update = verify({"--update", "--pinned"});
    EXPECT_EQ(update.status, 0) << update.errors;
    EXPECT_EQ(update.output,
              "new      b perspective: recorded; look at it before you keep it\n"
              "new      b map: recorded; look at it before you keep it\n");
    EXPECT_TRUE(fs::exists(folder_ / "b/map.png"));
    EXPECT_FALSE(fs::exists(folder_ / "b/perspective.png"));

    const Ended ended = verify();
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_EQ(ended.output,
              "ok       b perspective: strict: state and pixels as recorded\n"
              "ok       b map: strict: state and pixels as recorded\n"
              "2 of 2 as recorded\n");
    EXPECT_FALSE(fs::exists(folder_ / "verify-out"));
    EXPECT_EQ(verify({"-q"}).output, "");

    const std::string before = read_text(folder_ / "b.lock");
    EXPECT_EQ(verify({"--update"}).output,
              "kept     b perspective: as recorded\n"
              "kept     b map: as recorded\n");
    EXPECT_EQ(read_text(folder_ / "b.lock"), before);
    EXPECT_EQ(read_text(folder_ / "b.toml"), cases) << "people's file is theirs";
}

TEST_F(Verify, WhatWasRecordedInTheBaselineItselfHoldsUntilItIsMoved) {
    accept();
    const std::string cases = read_text(folder_ / "b.toml");
    const std::string lock = read_text(folder_ / "b.lock");
    write_text(folder_ / "b.toml", cases + lock.substr(lock.find('\n') + 1));
    fs::remove(folder_ / "b.lock");
    const Ended old = verify();
    EXPECT_EQ(old.status, 0) << old.output;
    EXPECT_EQ(old.errors,
              "b.toml: recorded values are in the baseline, as before version 0.2; `fumon verify "
              "--update` moves them into b.lock\n");
    const Ended update = verify({"--update"});
    EXPECT_TRUE(contains(update.output, "kept     b map: as recorded\n")) << update.output;
    EXPECT_TRUE(contains(update.output, "moved    b: what is recorded, into b.lock\n"));
    EXPECT_EQ(read_text(folder_ / "b.toml"), cases);
    EXPECT_EQ(read_text(folder_ / "b.lock"), lock);
    EXPECT_EQ(verify().errors, "");
}

TEST_F(Verify, AFigureIsACaseOfThePortableTier) {
    const std::string page =
        "[figure]\ndots_per_inch = 60\n[[figure.panel]]\nkind = \"map\"\n[[figure.panel]]\n"
        "[[figure.panel.curve]]\nseeds = 2\ny = \"standard_deviation\"\n";
    write_text(folder_ / "scene.toml", small_scene() + page);
    write_text(folder_ / "b.toml",
               "scene = \"scene.toml\"\nstep = 10\n[cases]\npage = {figure = true}\n");
    accept();
    EXPECT_EQ(verify().output,
              "ok       b page: portable (text uses the fonts of the machine): state and "
              "pixels as recorded\n1 of 1 as recorded\n");
    write_text(folder_ / "scene.toml", small_scene() + page + "x_logarithmic = true\n");
    const Ended curve = verify();
    EXPECT_EQ(curve.status, 2) << "a curve has no such key: " << curve.output;
    write_text(folder_ / "scene.toml", small_scene() + "[bed]\nhigh = 0.9\n" + page);
    const Ended other = verify();
    EXPECT_EQ(other.status, 1) << other.output << other.errors;
    EXPECT_TRUE(contains(other.output, "the state differs")) << other.output;
    write_text(folder_ / "scene.toml", small_scene());
    EXPECT_EQ(verify().status, 2) << "there is no figure in it";
    write_text(folder_ / "b.toml",
               "scene = \"scene.toml\"\n[cases]\npage = {figure = true, step = 3}\n");
    EXPECT_TRUE(contains(verify().output, "b.toml:3:1: cases.page is a figure"));
}

TEST_F(Verify, AMovedSunShowsOnOnePage) {
    accept();
    write_baseline("settings = [\"sun.azimuth=320\"]\n");
    const Ended ended = verify({"-o", "out", "--junit", "junit.xml"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_TRUE(contains(ended.output, "DIFFERS  b map: strict: ")) << ended.output;
    EXPECT_FALSE(contains(ended.output, "the state differs")) << ended.output;
    EXPECT_TRUE(contains(ended.output, "smallest tile SSIM")) << ended.output;
    for (const char* name : {"map-expected.png", "map-got.png", "map-difference.png"})
        EXPECT_EQ(read_png(folder_ / (std::string("out/b/") + name)).width, 64) << name;
    EXPECT_EQ(read_png(folder_ / "out/b/map-expected.png"), read_png(folder_ / "b/map.png"));
    EXPECT_EQ(read_png(folder_ / "out/b/perspective-expected.png").width, 32)
        << "of which no picture is kept, the thumbnail";
    EXPECT_EQ(read_png(folder_ / "out/b/perspective-got.png").width, 64);

    const std::string page = read_text(folder_ / "out/index.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    EXPECT_FALSE(contains(page, "http")) << "nothing from outside";
    for (std::size_t at = page.find("src=\""); at != std::string::npos;
         at = page.find("src=\"", at + 1))
        EXPECT_TRUE(page.substr(at + 5).starts_with("data:image/png;base64,iVBORw0KGgo"));
    EXPECT_TRUE(contains(read_text(folder_ / "junit.xml"), "failures=\"2\" errors=\"0\""));

    const Ended update = verify({"--update"});
    EXPECT_EQ(update.status, 0);
    EXPECT_TRUE(contains(update.output, "changed  b map: the pixels change, their thumbnail by "))
        << update.output;
    EXPECT_EQ(verify({"-o", "out"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/index.html")) << "the former page would tell otherwise";
    EXPECT_FALSE(fs::exists(folder_ / "out/b"));
}

TEST_F(Verify, LeavesAPageOfOthersAlone) {
    fs::create_directories(folder_ / "site");
    write_text(folder_ / "site/index.html", "<!DOCTYPE html>\nmine\n");
    const Ended ended = verify({"-o", "site"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.errors,
              "site/index.html: already exists and was not made by fumon; name another output, or "
              "replace it with --force\n");
    EXPECT_EQ(read_text(folder_ / "site/index.html"), "<!DOCTYPE html>\nmine\n");
}

TEST_F(Verify, OneStepMoreChangesState) {
    accept();
    write_text(folder_ / "b.toml", [&] {
        std::string text = read_text(folder_ / "b.toml");
        return text.replace(text.find("step = 10"), 9, "step = 11");
    }());
    const Ended ended = verify({"-o", "out"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_TRUE(contains(ended.output, "DIFFERS  b perspective: strict: the state differs; "))
        << ended.output;
}

TEST_F(Verify, AnotherProcessorPassesInThePortableTier) {
    EXPECT_EQ(verify({"--update"}).status, 0) << "not pinned";
    const Ended ended = verify({}, {"GALLIUM_OVERRIDE_CPU_CAPS=sse4.1"});
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_TRUE(contains(ended.output, "ok       b map: portable (")) << ended.output;
}

TEST_F(Verify, AChangedKeptPictureIsWrongInput) {
    accept();
    fs::copy_file(folder_ / "b/map.png", folder_ / "b/kept.png");
    EXPECT_EQ(fumon({"still", "scene.toml", "-o", "b/map.png", "-q"}, folder_.path()).status, 0);
    const Ended ended = verify();
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.output,
                         "WRONG    b map: b/map.png: is not the picture that b.lock "
                         "recorded for map; restore it"))
        << ended.output;
    fs::remove(folder_ / "b/map.png");
    const Ended gone = verify();
    EXPECT_EQ(gone.status, 1);
    EXPECT_TRUE(contains(gone.output, "MISSING  b map: its expected picture is missing"))
        << gone.output;
}

TEST_F(Verify, AWrongCaseIsAnErrorOfItsOwnAndTheOthersAreCompared) {
    write_text(folder_ / "b.toml",
               "[cases]\na = {scene = \"none.toml\"}\n"
               "b = {scene = \"scene.toml\", settings = [\"sun.azimut=3\"]}\n"
               "c = {scene = \"scene.toml\", stop = 3}\n"
               "d = {scene = \"scene.toml\"}\n");
    const Ended wrong = verify({"--junit", "junit.xml"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.errors, "");
    EXPECT_EQ(wrong.output,
              "WRONG    b a: b.toml:2:1: cases.a: none.toml does not exist or is invalid; `fumon "
              "check` with its path, or --trust here, gives details\n"
              "WRONG    b b: b.toml:3:1: cases.b: settings.1:1: unknown key sun.azimut; did you "
              "mean \"sun.azimuth\"?\n"
              "WRONG    b c: b.toml:4:28: unknown key cases.c.stop; did you mean "
              "\"cases.c.step\"?\n"
              "MISSING  b d: nothing is recorded; look at the picture, then `fumon verify "
              "--update`\n"
              "0 of 4 as recorded; see verify-out/index.html\n");
    EXPECT_TRUE(contains(read_text(folder_ / "junit.xml"), "failures=\"1\" errors=\"3\""));
    EXPECT_TRUE(contains(read_text(folder_ / "verify-out/index.html"), "b.toml:4:28: unknown key"));
    EXPECT_EQ(verify({"--update"}).status, 2);
    EXPECT_TRUE(contains(read_text(folder_ / "b.lock"), "[recorded.d]")) << "others are recorded";
}

TEST_F(Verify, ABaselineThatCannotBeReadIsAnErrorOfItsOwn) {
    accept();
    write_text(folder_ / "bad.toml", "[cases\n");
    const Ended bad = verify({"bad.toml", "no.toml", "--junit", "junit.xml"});
    EXPECT_EQ(bad.status, 2);
    EXPECT_TRUE(contains(bad.output, "WRONG    bad baseline: bad.toml:1:")) << bad.output;
    EXPECT_TRUE(contains(bad.output, "WRONG    no baseline: no.toml: ")) << bad.output;
    EXPECT_TRUE(contains(bad.output, "2 of 4 as recorded")) << bad.output;
    EXPECT_TRUE(
        contains(read_text(folder_ / "junit.xml"), "tests=\"4\" failures=\"0\" errors=\"2\""));
    const std::string lock = read_text(folder_ / "b.lock");
    write_text(folder_ / "b.lock", lock.substr(0, lock.size() / 2));
    const Ended damaged = verify();
    EXPECT_EQ(damaged.status, 2);
    EXPECT_TRUE(contains(damaged.output, "WRONG    b map: b.lock:")) << damaged.output;
}

TEST_F(Verify, WhatBelongsToNoCaseIsAnErrorUntilItIsRemoved) {
    write_text(folder_ / "b.toml", "[cases]\none = {scene = \"scene.toml\"}\n");
    accept();
    write_text(folder_ / "b.toml", [&] {
        std::string text = read_text(folder_ / "b.toml");
        return text.replace(text.find("one = {"), 7, "two = {");
    }());
    const Ended orphan = verify();
    EXPECT_EQ(orphan.status, 2);
    EXPECT_TRUE(contains(orphan.output,
                         "WRONG    b one: b.lock: recorded.one belongs to no case; restore its "
                         "case, or remove the record with `fumon verify --update`\n"))
        << orphan.output;
    const Ended update = verify({"--update"});
    EXPECT_TRUE(contains(update.output, "removed  b one: it has no case any more\n"))
        << update.output;
    EXPECT_FALSE(contains(read_text(folder_ / "b.lock"), "recorded.one"));
}

TEST_F(Verify, AStepAfterTheEndIsWrongInput) {
    write_text(folder_ / "b.toml",
               "[cases]\na = {scene = \"scene.toml\", step = 21}\n"
               "b = {scene = \"scene.toml\", time = 21}\n");
    const Ended ended = verify({"-o", "out"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.output,
                         "WRONG    b a: b.toml:2:1: cases.a: step 21 is after the run's end; "))
        << ended.output;
    EXPECT_TRUE(contains(
        ended.output, "WRONG    b b: b.toml:3:1: cases.b: time 21 is after the run's end at 20 "))
        << ended.output;
    EXPECT_TRUE(contains(read_text(folder_ / "out/index.html"), "step 21 is after"));
}

/// Every model's pictures are under test: in both looks, from above and in perspective. What a
/// section's figure shows has no camera.
TEST(ImageBaselines, CoverEveryModelLookAndProjection) {
    std::set<std::tuple<std::string, ViewMode, Projection>> covered;
    for (const auto& entry : fs::directory_iterator(FUMON_TEST_FOLDER "/images/baselines")) {
        if (entry.path().extension() != ".toml") continue;
        const Baseline baseline = read_baseline(entry.path());
        EXPECT_TRUE(baseline.orphans.empty()) << entry.path();
        for (const BaselineCase& one : baseline.cases) {
            EXPECT_TRUE(baseline.records.contains(one.name)) << entry.path() << " " << one.name;
            const Scene scene = read_scene(baseline.file.parent_path() / one.scene, one.settings);
            const auto cover = [&](Projection projection) {
                covered.insert({scene.model.name, scene.view.look.mode, projection});
            };
            cover(scene.view.camera.projection);
            if (scene.model.name == "airflow" && scene.view.look.mode == ViewMode::figure)
                cover(Projection::map);
        }
    }
    for (const ModelEntry& model : models()) {
        for (const ViewMode mode : {ViewMode::scenic, ViewMode::figure}) {
            for (const Projection projection : {Projection::perspective, Projection::map}) {
                EXPECT_TRUE(covered.contains({std::string(model.name), mode, projection}))
                    << model.name << ", look " << static_cast<int>(mode) << ", projection "
                    << static_cast<int>(projection);
            }
        }
    }
}

}  // namespace
}  // namespace fumon::test
