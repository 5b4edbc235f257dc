#include "film/rule/film_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "base/error.h"
#include "film/camera/camera_distance.h"
#include "film/camera/landmarks.h"
#include "film/camera/moves.h"
#include "film/film_read.h"
#include "film/timeline.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::Ended;
using test::fumon;
using test::ScratchFolder;

/// A small run of a scene, and what its pictures stand on.
struct SmallRun {
    const char* name;
    const char* scene;
};

constexpr const char* stored = "[output]\nfields_every = 4\nframes = false\nmovie = false\n";

const SmallRun small_runs[] = {
    {"dunes",
     "title = \"Dunes\"\n[model]\nname = \"dunes\"\n[[wind]]\nfrom = 270\n[grid]\nnx = 96\nny = "
     "72\n[bed]\nkind = \"heap\"\nheight = 4\nheap_radius = 12\n[run]\nsteps = 80\n"},
    {"dunes on a table",
     "[model]\nname = \"dunes\"\n[[wind]]\nfrom = 250\n[grid]\nnx = 48\nny = 96\n[bed]\nkind = "
     "\"heap\"\nheight = 3\nheap_radius = 9\n[run]\nsteps = 40\n[look]\nlight = \"studio\"\nground "
     "= \"table\"\n"},
    {"ripples",
     "[model]\nname = \"sand\"\n[grid]\nnx = 72\nny = 72\n[run]\nsteps = 60\n[look]\nground = "
     "\"table\"\n"},
    {"pile",
     "[model]\nname = \"sandpile\"\ngrains_per_step = 60\n[grid]\nnx = 40\nny = 30\n[run]\nsteps = "
     "60\n"},
    {"pile on a table",
     "[model]\nname = \"sandpile\"\ngrains_per_step = 60\n[grid]\nnx = 40\nny = 40\n[run]\nsteps = "
     "60\n[look]\nlight = \"studio\"\nroom = 30\n"},
    {"gully",
     "[model]\nname = \"gully\"\ninitial_water = \"dry\"\nrain = 60\n[bed]\nfile = "
     "\"" FUMON_TEST_FOLDER
     "/../assets/terrain/west_bijou_gully.asc\"\nnodata = \"fill\"\n[run]\nsteps = 20\n"},
};

class FilmByRule : public ::testing::TestWithParam<SmallRun> {
  protected:
    void SetUp() override {
        test::write_text(folder_ / "scene.toml", std::string(GetParam().scene) + stored);
        const Ended ran = fumon({"run", "scene.toml", "-o", "out", "--quiet"}, folder_.path());
        ASSERT_EQ(ran.status, 0) << ran.errors;
    }

    [[nodiscard]] std::string run() const { return (folder_ / "out").string(); }

    ScratchFolder folder_;
};

/// How far out of a picture's middle a round landform reaches, 1 at its edges.
double farthest_out(const Camera& camera, const LandmarkOnStage& mark) {
    double most = 0.0;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2.0 * M_PI * i / 12.0;
        const glm::dvec3 rim =
            mark.place + 0.5 * mark.breadth * glm::dvec3(std::cos(angle), std::sin(angle), 0.0);
        const glm::dvec2 seen = project(camera, rim);
        most = std::max({most, std::abs(seen.x), std::abs(seen.y)});
    }
    return most;
}

TEST_P(FilmByRule, IsComposed) {
    constexpr double middle_four_fifths = 0.8;
    for (const FilmStyle style :
         {FilmStyle::talk, FilmStyle::social, FilmStyle::loop, FilmStyle::survey}) {
        const FilmRuns runs({run()}, 1);
        const Film film = parse_film(film_by_rule(runs, {style}, "out"), "rule.toml");
        const FilmStage stage = make_stage(film, runs.first(), film_size(film));
        for (std::size_t i = 0; i < film.shots.size(); ++i) {
            const StagedShot staged(film, i, stage, runs);
            for (const double share : {0.0, 0.3, 0.5, 0.8, 1.0}) {
                const auto bed = runs.first().heights(staged.bed_at(share));
                const CameraPose pose = staged.pose_at(share);
                HighestGround ground(stage);
                ground.add(*bed);
                EXPECT_GT(pose.eye.z, ground.at(pose.eye.x, pose.eye.y))
                    << GetParam().name << ", shot " << i << " at " << share;
                if (!stage.repeats && stage.scene.view.look.ground != Ground::endless) {
                    EXPECT_GT(ground_share(stage, *bed, pose), 2.0 / 3.0)
                        << GetParam().name << ", shot " << i << " at " << share << film_toml(film);
                }
                const Shot& shot = film.shots[i];
                // A dune that is followed is the largest at first.
                if (shot.subject.word.empty() || (shot.follow && share > 0.0)) continue;
                LandmarkOnStage mark = landmark_on_stage(
                    stage, shot.subject.word,
                    *runs.first().heights(shot.follow ? staged.bed_at(0.0) : staged.bed_at(1.0)));
                if (GetParam().name == std::string("ripples"))
                    mark.breadth = 0.0;  // crests go on across the picture
                EXPECT_LT(farthest_out(camera_of(stage, pose), mark), middle_four_fifths)
                    << GetParam().name << ", shot " << i << " at " << share;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Landforms, FilmByRule, ::testing::ValuesIn(small_runs),
                         [](const auto& one) {
                             std::string name = one.param.name;
                             std::erase(name, ' ');
                             return name;
                         });

class RuledLook : public ::testing::Test {
  protected:
    [[nodiscard]] std::string film_of(const std::string& scene) const {
        test::write_text(folder_ / "scene.toml", scene + stored);
        const Ended ran =
            fumon({"run", "scene.toml", "-o", "out", "--quiet", "--force"}, folder_.path());
        EXPECT_EQ(ran.status, 0) << ran.errors;
        return film_by_rule(FilmRuns({(folder_ / "out").string()}, 1), {FilmStyle::talk}, "out");
    }

    ScratchFolder folder_;
};

TEST_F(RuledLook, ASurveyStandsInLandAndKeepsATableThatItAsksFor) {
    const std::string land = film_of(small_runs[5].scene);
    for (const char* line : {"ground = \"endless\"", "cover = \"auto\"", "survey_edge = \"line\"",
                             "clouds = \"cumulus\"", "distance = \"fit\""})
        EXPECT_NE(land.find(line), std::string::npos) << line << "\n" << land;
    const std::string model = film_of(std::string(small_runs[5].scene) +
                                      "[look]\nlight = \"studio\"\nground = \"table\"\n");
    EXPECT_EQ(model.find("ground ="), std::string::npos) << model;
}

TEST_F(RuledLook, AFloodIsFollowedAtItsFrontAndASlopeStaysOnItsTable) {
    const std::string flood = film_of(
        "[model]\nname = \"water\"\ntime_step = 0.1\n[[water]]\nwindow = [0, 0, 20, 16]\ndepth = "
        "3\n[grid]\nnx = 48\nny = 16\n[run]\nsteps = 60\n");
    EXPECT_NE(flood.find("subject = \"flood front\""), std::string::npos) << flood;
    EXPECT_NE(flood.find("follow = true"), std::string::npos) << flood;
    EXPECT_NE(flood.find("pace = \"change\""), std::string::npos) << flood;
    EXPECT_EQ(flood.find("endless"), std::string::npos) << flood;
    EXPECT_EQ(flood.find("\"fill\""), std::string::npos) << "the basin is cut off\n" << flood;
    const std::string slope = film_of(
        "[model]\nname = \"gully\"\nslope = 0.1\nrain = 60\ninitial_water = \"dry\"\n[bed]\nhigh = "
        "0.1\n[grid]\nnx = 32\nny = 32\ncell_size = [1.0]\n[run]\nsteps = 8\n[look]\nexaggeration "
        "= 1\n");
    EXPECT_EQ(slope.find("endless"), std::string::npos) << "nobody surveyed it\n" << slope;
}

class RuledRun : public ::testing::Test {
  protected:
    void SetUp() override {
        test::write_text(folder_ / "scene.toml", std::string(small_runs[2].scene) + stored);
        ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet"}, folder_.path()).status, 0);
    }

    [[nodiscard]] Film ruled(const FilmRule& rule) const {
        const FilmRuns runs({(folder_ / "out").string()}, 1);
        return parse_film(film_by_rule(runs, rule, "out"), "rule.toml");
    }

    Ended film(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "film");
        return fumon(arguments, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(RuledRun, LastsAsLongAsItIsAskedTo) {
    for (const auto& [style, seconds] :
         {std::pair{FilmStyle::talk, 16.0}, std::pair{FilmStyle::social, 12.0},
          std::pair{FilmStyle::loop, 12.0}, std::pair{FilmStyle::survey, 18.0}}) {
        EXPECT_NEAR(static_cast<double>(Timeline(ruled({style})).frames()), 30.0 * seconds, 3.0);
        EXPECT_NEAR(static_cast<double>(Timeline(ruled({style, 7.5})).frames()), 225.0, 3.0);
    }
    EXPECT_THROW(static_cast<void>(ruled({FilmStyle::talk, 3.9})), InputError);
    EXPECT_EQ(film_size(ruled({FilmStyle::social})).height, 1920);
}

TEST_F(RuledRun, IsDrawnWithoutAFilmAndFromTheFileThatItPrints) {
    const std::vector<std::string> small{"--set", "film.size=\"96x54\"", "--set", "film.rate=2",
                                         "--set", "film.supersampling=1"};
    const auto with = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), small.begin(), small.end());
        return film(arguments);
    };
    const Ended made = with({"out", "-o", "one.mkv"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended printed = film({"out", "--print"});
    ASSERT_EQ(printed.status, 0) << printed.errors;
    EXPECT_EQ(printed.output.substr(0, 2), "# ");
    test::write_text(folder_ / "mine.toml", printed.output);
    ASSERT_EQ(with({"out", "mine.toml", "-o", "two.mkv"}).status, 0);
    const auto pixels = [&](const char* file) {
        const std::string text = test::read_text(folder_ / file);
        const std::size_t at = text.find("pixels-sha256");
        return text.substr(at, 90);
    };
    EXPECT_EQ(pixels("one.mkv.json"), pixels("two.mkv.json"));
    const Ended sides = with({"out", "out", "-o", "sides.png"});
    EXPECT_EQ(sides.status, 0) << sides.errors;
    const Ended refused = film({"out", "mine.toml", "--print"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.errors,
              "mine.toml: --print, --style and --seconds are for a film by rule; leave out FILM\n");
    EXPECT_EQ(film({"out", "--style", "tlk", "--print"}).errors,
              "--style: unknown style \"tlk\"; did you mean \"talk\"?\n");
}

}  // namespace
}  // namespace fumon
