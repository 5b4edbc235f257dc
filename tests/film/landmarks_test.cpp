#include "film/camera/landmarks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "film/beds/film_runs.h"
#include "film/camera/camera_distance.h"
#include "film/camera/moves.h"
#include "film/film_read.h"
#include "support/program.h"

namespace fumon {
namespace {

/// A cone on a plain of height 0, a trench along a row, and a slope down to the south.
Snapshot land(int nx, int ny) {
    Snapshot bed;
    bed.bed = Grid(nx, ny, 0.0);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double away = std::hypot(x - 0.75 * nx, y - 0.75 * ny);
            bed.bed(x, y) = 0.02 * y + std::max(0.0, 8.0 - 64.0 * away / nx);
            bed.bed(x, y) += 0.05 * std::abs(x - 0.25 * nx);
            if (std::abs(x - 0.25 * nx) < 1.5) bed.bed(x, y) -= 2.0;
        }
    }
    return bed;
}

TEST(Landmarks, AreWhereTheyAreAtAnySizeOfGrid) {
    for (const int scale : {1, 2}) {
        const Snapshot bed = land(64 * scale, 48 * scale);
        const Landmark top = find_landmark("highest", bed);
        EXPECT_EQ(top.x, 48.0 * scale);
        EXPECT_EQ(top.y, 36.0 * scale);
        EXPECT_LT(top.height, bed.bed(48 * scale, 36 * scale) - 2.0);
        EXPECT_NEAR(top.breadth / scale, 16.5, 1.5);
        const Landmark channel = find_landmark("deepest channel", bed);
        EXPECT_NEAR(channel.x, 16.0 * scale, 1.0);
        const Landmark mouth = find_landmark("outlet", bed);
        EXPECT_NEAR(mouth.x, 16.0 * scale, 2.0);
        EXPECT_EQ(mouth.y, 0.0);
        EXPECT_EQ(find_landmark("lowest", bed).y, 0.0);
        EXPECT_EQ(find_landmark("middle", bed).x, 32.0 * scale - 0.5);
    }
    EXPECT_THROW(find_landmark("somewhere", land(8, 8)), std::invalid_argument);
}

TEST(Landmarks, AFloodFrontIsWhereTheDepthChangesAtOnce) {
    Snapshot flood = land(64, 48);
    EXPECT_EQ(find_landmark("flood front", flood).x, find_landmark("middle", flood).x) << "dry";
    Grid depth(64, 48, 0.0);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 40; ++x) depth(x, y) = 1.0 + 0.05 * (40 - x);  // and a long back
    flood.fields.push_back({"water_depth", "depth", "m", depth});
    const Landmark front = find_landmark("flood front", flood);
    EXPECT_NEAR(front.x, 39.5, 0.2);
    EXPECT_NEAR(front.y, 23.5, 0.1);
    flood.nodata = Mask(64, 48, 0);
    for (int y = 0; y < 48; ++y) {  // where the data end, water does not
        flood.nodata(5, y) = 1;
        flood.fields.back().values(5, y) = 0.0;
    }
    EXPECT_NEAR(find_landmark("flood front", flood).x, 39.5, 0.2);
    for (double& metres : flood.fields.back().values.values()) metres = 2.0;
    EXPECT_EQ(find_landmark("flood front", flood).x, find_landmark("middle", flood).x) << "level";
}

TEST(Landmarks, TheLargestDuneIsTheHighestWhereNoneIsAlone) {
    Snapshot bed = land(64, 48);
    for (double& height : bed.bed.values()) height += 100.0;
    EXPECT_EQ(find_landmark("largest dune", bed).x, find_landmark("highest", bed).x);
    bed.nodata = Mask(64, 48, 0);
    bed.nodata(48, 36) = 1;
    const Landmark beside = find_landmark("highest", bed);
    EXPECT_NE(std::pair(beside.x, beside.y), std::pair(48.0, 36.0)) << "that cell has no data";
}

/// A run of a few beds, two steps from one to the next.
class WrittenShots : public ::testing::Test {
  protected:
    void SetUp() override {
        test::write_text(folder_ / "scene.toml",
                         "[model]\nname = \"dunes\"\n[[wind]]\nfrom = 270\n[grid]\nnx = 48\nny = "
                         "32\n[bed]\nkind = \"heap\"\nheight = 3\nheap_radius = 8\n[run]\nsteps = "
                         "40\n[output]\nfields_every = 4\nframes = false\nmovie = false\n[look]\n"
                         "ground = \"table\"\n");
        ASSERT_EQ(test::fumon({"run", "scene.toml", "-o", "out", "--quiet"}, folder_.path()).status,
                  0);
        runs_ = std::make_unique<FilmRuns>(std::vector{(folder_ / "out").string()}, 1);
    }

    /// Of a shot, its first and its last bed.
    std::pair<std::size_t, std::size_t> ends_of(const std::string& shot) {
        const Film film = parse_film("[[shot]]\n" + shot, "f.toml");
        const BedClock clock(film, 0, runs_->first());
        return {clock.bed_at(0.0), clock.bed_at(1.0)};
    }

    std::string fault_of(const std::string& shot) {
        try {
            ends_of(shot);
        } catch (const InputError& fault) {
            return fault.what();
        }
        return {};
    }

    test::ScratchFolder folder_;
    std::unique_ptr<FilmRuns> runs_;
};

TEST_F(WrittenShots, MomentsAreSharesAndTimes) {
    EXPECT_EQ(ends_of("from = \"20 %\"\nto = \"60%\"\n"),
              std::pair(std::size_t{2}, std::size_t{6}));
    EXPECT_EQ(ends_of("from = \"0 %\"\nto = \"100 %\"\nclock = \"time\"\n"),
              std::pair(std::size_t{0}, std::size_t{10}));
    const StoredBeds& beds = runs_->first();
    const std::string unit = beds.first().time_unit;
    ASSERT_EQ(unit, "yr");
    const double days = beds.beds()[5].time * 365.242198781;
    EXPECT_EQ(ends_of("from = \"start\"\nto = \"" + std::to_string(days) + " days\"\n").second, 5U);
    EXPECT_EQ(fault_of("to = \"400 yr\"\n").substr(0, 56),
              "f.toml:2:6: shot.0.to = \"400 yr\": the stored beds have t");
    for (const char* wrong : {"101 %", "-1 %", "3 metres", "3", "soon", "% 3"}) {
        EXPECT_NE(fault_of("to = \"" + std::string(wrong) + "\"\n")
                      .find("it takes \"start\", \"end\", \"40 %\", \"3 yr\" or a number"),
                  std::string::npos)
            << wrong << fault_of("to = \"" + std::string(wrong) + "\"\n");
    }
}

TEST_F(WrittenShots, ACameraStandsByWhatItLooksAt) {
    const Film film = parse_film(
        "[film]\nsize = \"96x54\"\n[[shot]]\nmove = \"still\"\nfrom = \"end\"\nsubject = \"largest "
        "dune\"\ndistance = \"near\"\nazimuth = 180\n[[shot]]\nmove = \"keys\"\nfrom = "
        "\"end\"\n[[shot.key]]\nlook_at = \"highest\"\nazimuth = 90\nelevation = 20\ndistance = "
        "0.5\n[[shot.key]]\ndistance = \"fill\"\n",
        "f.toml");
    const FilmStage stage = make_stage(film, runs_->first(), film_size(film));
    const StagedShot still(film, 0, stage, *runs_);
    const auto bed = runs_->first().heights(10);
    const LandmarkOnStage dune = landmark_on_stage(stage, "largest dune", *bed);
    EXPECT_LT(glm::length(still.pose_at(0.5).look_at - dune.place), 1e-9);
    const double away = glm::length(still.pose_at(0.5).eye - dune.place);
    EXPECT_NEAR(away, near_distance(dune.breadth, still.pose_at(0.5).focal_length), 1e-9);
    const StagedShot keys(film, 1, stage, *runs_);
    const LandmarkOnStage top = landmark_on_stage(stage, "highest", *bed);
    EXPECT_NEAR(glm::length(keys.pose_at(0.0).eye - top.place), 0.5, 1e-6);
    EXPECT_GT(keys.pose_at(0.0).eye.x, top.place.x);
    EXPECT_NEAR(ground_share(stage, *bed, keys.pose_at(1.0)), filled_share, 0.03);
    for (const auto& [shot, fault] :
         {std::pair{"move = \"crane\"\nsubject = \"highest\"\nfollow = true\n",
                    "shot.0.follow is for move = \"still\", \"orbit\" and \"push-in\""},
          std::pair{"follow = true\n", "shot.0.follow needs a .subject that may move"},
          std::pair{"[[shot.key]]\nat = [1, 2, 3]\ndistance = 0.4\n", "take one or the others"},
          std::pair{"subject = \"hihgest\"\n", "it takes \"middle\", \"highest\""}}) {
        EXPECT_NE(fault_of(shot).find(fault), std::string::npos) << fault_of(shot);
    }
}

TEST_F(WrittenShots, AreWrittenBackAsTheyAre) {
    const std::string film = film_toml(parse_film(
        "[[shot]]\nfrom = \"20 %\"\nto = \"3 yr\"\nsubject = \"largest dune\"\n", "f.toml"));
    for (const char* part : {"from = \"20 %\"", "to = \"3 yr\"", "subject = \"largest dune\""})
        EXPECT_NE(film.find(part), std::string::npos) << film;
    EXPECT_EQ(film_toml(parse_film(film, "g.toml")), film);
}

}  // namespace
}  // namespace fumon
