#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "film/camera/camera_distance.h"
#include "film/camera/followed.h"
#include "film/camera/kept_clear.h"
#include "film/camera/moves.h"
#include "film/film_painter.h"
#include "film/film_read.h"
#include "measure/bed/dunes.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::fumon;
using test::ScratchFolder;

/// A lone dune that wanders east, made once.
const std::string& wandering_dune() {
    static const ScratchFolder folder;
    static const std::string run = [] {
        test::write_text(folder / "scene.toml",
                         "[model]\nname = \"dunes\"\n[[wind]]\nfrom = 270\n[grid]\nnx = 64\nny = "
                         "32\n[bed]\nkind = \"heap\"\nheight = 3\nheap_radius = 8\n[run]\nsteps = "
                         "120\n[output]\nfields_every = 5\nframes = false\nmovie = "
                         "false\n[look]\nground = \"table\"\n");
        fumon({"run", "scene.toml", "-o", "out", "--quiet"}, folder.path());
        return (folder / "out").string();
    }();
    return run;
}

/// One shot of that run, ready.
struct StagedFilm {
    explicit StagedFilm(const std::string& shot)
        : film(parse_film("[film]\nwidth = 96\nheight = 54\n[[shot]]\n" + shot, "f.toml")),
          runs({wandering_dune()}, 1),
          stage(make_stage(film, runs.first(), film_size(film))),
          staged(film, 0, stage, runs) {}

    Film film;
    FilmRuns runs;
    FilmStage stage;
    StagedShot staged;
};

std::string fault_of_shot(const std::string& shot) {
    try {
        const StagedFilm at(shot);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "";
}

TEST(FilmShot, StandsFartherWhereABlockWouldMeetWhatIsKeptClear) {
    const std::vector<glm::dvec2> diamond{{0.0, -0.5}, {0.5, 0.0}, {0.0, 0.5}, {-0.5, 0.0}};
    EXPECT_FALSE(hull_meets_box(diamond, {{-0.9, -0.9}, {-0.26, -0.26}}));
    EXPECT_TRUE(hull_meets_box(diamond, {{-0.9, -0.9}, {-0.24, -0.24}}));
    EXPECT_TRUE(hull_meets_box(diamond, {{-0.1, -0.1}, {0.1, 0.1}}));
    EXPECT_FALSE(hull_meets_box(diamond, {{-0.9, -0.9}, {0.9, -0.51}}));

    StagedFilm at("seconds = 1\n");
    CameraPose above;
    above.eye = fit_distance(at.stage, above.look_at, 180.0, 80.0, 50.0) * towards(180.0, 80.0);
    const auto moved = [&](const PictureBox& box) {
        at.stage.kept_clear = {box};
        return clear_poses(at.stage, {above}).front();
    };
    const auto away = [](const CameraPose& pose) { return glm::length(pose.eye - pose.look_at); };
    EXPECT_EQ(moved({{-0.9, -0.99}, {-0.6, -0.98}}), above)
        << "the block reaches to its sides, not as far down";
    EXPECT_EQ(moved({{-0.8, -0.8}, {0.8, 0.8}}), above) << "there is no room";
    const CameraPose lower = moved({{-0.2, 0.76}, {0.2, 0.9}});
    EXPECT_EQ(away(lower), away(above)) << "there is room below";
    EXPECT_GT(project(camera_of(at.stage, above), lower.look_at).y, 0.03);
    const CameraPose farther = moved({{-0.9, -0.9}, {-0.75, 0.9}});
    EXPECT_GT(away(farther), 1.02 * away(above));
    EXPECT_LT(away(farther), 1.4 * away(above));
}

TEST(FilmShot, SaysThatItsKeysLieInTheGround) {
    const std::string keys = "move = \"keys\"\nclearance = 0.5\n[[shot.key]]\nat = [10, 16, ";
    const auto note = [&](const std::string& height) {
        return StagedFilm(keys + height + "]\n[[shot.key]]\nat = [50, 16, " + height + "]\n")
            .staged.note();
    };
    EXPECT_EQ(note("9"), "");
    EXPECT_TRUE(
        note("-20").starts_with("shot 1: the way through its keys (shot.key.at) lies up to "))
        << note("-20");
    EXPECT_TRUE(
        note("-20").ends_with("below the ground, and was lifted to shot.clearance, 0.5 "
                              "above it"))
        << note("-20");
}

TEST(FollowDune, KeepsTheDuneInTheMiddleAndGoesSmoothly) {
    const StagedFilm at("move = \"follow-dune\"\n");
    double way = 0.0;
    double last_step = 0.0;
    glm::dvec3 before = at.staged.pose_at(0.0).eye;
    constexpr int looks = 48;
    for (int i = 0; i <= looks; ++i) {
        const double share = static_cast<double>(i) / looks;
        const CameraPose pose = at.staged.pose_at(share);
        const auto bed = at.runs.first().snapshot(at.staged.bed_at(share));
        const DuneField field = separate_dunes(bed->bed, bed->periodic);
        ASSERT_EQ(field.dunes.size(), 1U);
        const Block& block = at.stage.block;
        const glm::dvec3 dune(
            ((field.dunes[0].centre_x + 0.5) / bed->bed.nx() - 0.5) * block.width_x,
            ((field.dunes[0].centre_y + 0.5) / bed->bed.ny() - 0.5) * block.width_y,
            block.z(0.5 * field.dunes[0].height));
        const glm::dvec2 seen = project(camera_of(at.stage, pose), dune);
        EXPECT_LT(std::max(std::abs(seen.x), std::abs(seen.y)), 0.12) << share;
        const double step = glm::length(pose.eye - before);
        if (i > 2) {
            EXPECT_LT(std::abs(step - last_step), 0.35 * std::max(step, last_step)) << i;
        }
        last_step = step;
        way += step;
        before = pose.eye;
    }
    EXPECT_GT(way, 0.05) << "the dune wanders";
}

TEST(FollowDune, SaysWhatIsMissing) {
    EXPECT_EQ(
        fault_of_shot("move = \"follow-dune\"\ndune = 2\n"),
        "f.toml:6:8: shot.0.dune: there is no dune number 2 at step 0, which has 1 isolated dunes");
    const StagedFilm standing("move = \"follow-dune\"\nfrom = 50\nto = 50\n");
    EXPECT_EQ(glm::length(standing.staged.pose_at(1.0).eye - standing.staged.pose_at(0.0).eye),
              0.0);
}

TEST(FollowStream, GoesDownTheStreamThatDrainsMost) {
    const StagedFilm at("move = \"follow-stream\"\nfrom = 0\nto = 0\ndistance = 0.2\n");
    const auto bed = at.runs.first().snapshot(0);
    const std::vector<glm::dvec3> places = followed_stream(at.film, 0, at.stage, *bed);
    ASSERT_GT(places.size(), 5U);
    EXPECT_LT(places.back().z, places.front().z + 1e-9);
    const CameraPose begin = at.staged.pose_at(0.0);
    EXPECT_LT(glm::length(glm::dvec2(begin.eye) - glm::dvec2(places.front())), 1e-6);
    EXPECT_NEAR(begin.eye.z, places.front().z + 0.2, 1e-6);
    EXPECT_LT(begin.look_at.z, begin.eye.z);
}

/// The mean difference of two frames of a film over the bed's top, the first one warped by what is
/// known of the camera's motion; without, where `moved` is false.
double change_after_warp(const FilmPainter& painter, const Image& one, const Image& other,
                         double share_of_one, double share_of_other, bool moved) {
    const FilmStage& stage = painter.stage();
    const StagedShot& shot = painter.shots().front();
    const Camera from = camera_of(stage, shot.pose_at(share_of_one));
    const Camera to = camera_of(stage, shot.pose_at(share_of_other));
    double sum = 0.0;
    double count = 0.0;
    for (int y = 1; y + 1 < other.height; ++y) {
        for (int x = 1; x + 1 < other.width; ++x) {
            const glm::dvec2 place(2.0 * (x + 0.5) / other.width - 1.0,
                                   1.0 - 2.0 * (y + 0.5) / other.height);
            const glm::dvec3 ray =
                to.forward + place.x * to.half.x * to.right + place.y * to.half.y * to.up;
            const glm::dvec3 point = to.eye + ray * ((stage.block.surface - to.eye.z) / ray.z);
            if (ray.z >= 0.0 || std::abs(point.x) > 0.45 * stage.block.width_x ||
                std::abs(point.y) > 0.45 * stage.block.width_y)
                continue;
            const glm::dvec2 was = moved ? project(from, point) : place;
            const double u =
                std::clamp(0.5 * (was.x + 1.0) * one.width - 0.5, 0.0, one.width - 2.0);
            const double v =
                std::clamp(0.5 * (1.0 - was.y) * one.height - 0.5, 0.0, one.height - 2.0);
            const int left = static_cast<int>(u);
            const int top = static_cast<int>(v);
            for (int c = 0; c < 3; ++c) {
                const auto at = [&](int i, int j) {
                    return static_cast<double>(one.row(top + j)[3 * (left + i) + c]);
                };
                const double warped = std::lerp(std::lerp(at(0, 0), at(1, 0), u - left),
                                                std::lerp(at(0, 1), at(1, 1), u - left), v - top);
                sum += std::abs(warped - other.row(y)[3 * x + c]);
                count += 1.0;
            }
        }
    }
    return sum / std::max(count, 1.0);
}

TEST(FilmPainter, ASlowMoveChangesNothingButWhereThingsAreSeen) {
    const ScratchFolder folder;
    test::write_text(folder / "scene.toml", test::small_scene());
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.fields_at=[20]",
                     "--set", "look.ground=table", "--set", "output.frames=false", "--set",
                     "output.movie=false"},
                    folder.path())
                  .status,
              0);
    const Film film = parse_film(
        "[film]\nwidth = 320\nheight = 180\nrate = 30\n[[shot]]\nseconds = 2\nmove = "
        "\"orbit\"\nturn = 12\nspeed = \"constant\"\nelevation = 40\n",
        "f.toml");
    const FilmRuns runs({(folder / "out").string()}, 1);
    WorkerPool pool(1);
    FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    constexpr std::int64_t frame = 30;
    const auto change_to = [&](std::int64_t other, bool moved) {
        return change_after_warp(painter, painter.paint(frame), painter.paint(other), frame / 59.0,
                                 static_cast<double>(other) / 59.0, moved);
    };
    EXPECT_LT(change_to(frame + 1, true), 1.0) << "levels of 255";
    EXPECT_GT(change_to(frame + 12, false), 3.0) << "there is something to see";
    EXPECT_LT(change_to(frame + 12, true), 0.7 * change_to(frame + 12, false));
}

}  // namespace
}  // namespace fumon
