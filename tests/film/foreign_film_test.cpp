// Films and stills of the results of other models, as a user makes them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_layouts.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* film_of_dates =
    "[film]\nwidth = 240\nheight = 180\nrate = 5\nsupersampling = 1\n"
    "[[shot]]\nseconds = 1\nfrom = \"start\"\nto = \"end\"\nmove = \"orbit\"\nturn = 20\n"
    "[[overlay]]\nkind = \"time\"\n";

class ForeignFilm : public ::testing::Test {
  protected:
    void SetUp() override {
        write_sfincs(folder_ / "flood.nc");
        write_text(folder_ / "film.toml", film_of_dates);
    }
    Ended run(const std::vector<std::string>& arguments) {
        return fumon(arguments, folder_.path());
    }
    ScratchFolder folder_;
};

TEST_F(ForeignFilm, IsMadeOfAFileAndAgain) {
    const Ended made = run({"film", "flood.nc", "film.toml", "-o", "a.mp4"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended again = run({"again", "a.mp4", "-o", "b.mp4"});
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_NE(again.errors.find("b.mp4: the same bytes as a.mp4"), std::string::npos)
        << again.errors;
    write_sfincs(folder_ / "flood.nc", 0.8, 0.6);
    const Ended other = run({"again", "a.mp4", "-o", "c.mp4"});
    EXPECT_NE(other.errors.find("flood.nc: is not the file that the film was made of"),
              std::string::npos)
        << other.errors;
}

TEST_F(ForeignFilm, AStillIsOfARecord) {
    const std::vector<std::string> small{"--set", "image.width=320", "--set", "image.height=240"};
    const auto still = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), small.begin(), small.end());
        return run(arguments);
    };
    const Ended first = still({"still", "flood.nc", "--step", "0", "-o", "first.png"});
    ASSERT_EQ(first.status, 0) << first.errors;
    const Ended last = still({"still", "flood.nc", "--time", "58", "-o", "last.png"});
    ASSERT_EQ(last.status, 0) << last.errors;
    EXPECT_NE(last.errors.find("step 2, at 60, is the nearest to --time 58"), std::string::npos)
        << last.errors;
    EXPECT_NE(read_text(folder_ / "first.png"), read_text(folder_ / "last.png"));
}

TEST_F(ForeignFilm, FieldsOfFumonNeedNoFolder) {
    write_text(folder_ / "scene.toml", small_scene());
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.frames=false",
                   "--set", "output.movie=false", "--set", "output.fields_every=2"})
                  .status,
              0);
    write_text(folder_ / "film.toml", std::string(film_of_dates) + "text = \"{step}\"\n");
    ASSERT_EQ(run({"film", "out", "film.toml", "-o", "folder_%02d.png"}).status, 0);
    fs::rename(folder_ / "out/fields.nc", folder_ / "alone.nc");
    const Ended alone = run({"film", "alone.nc", "film.toml", "-o", "alone_%02d.png"});
    ASSERT_EQ(alone.status, 0) << alone.errors;
    EXPECT_TRUE(fs::exists(folder_ / "alone_04.png"));
}

TEST_F(ForeignFilm, DescribeTakesSeveralFields) {
    const Ended told =
        run({"describe", "flood.nc", "--field", "depth=hmax", "--field", "level=zs"});
    ASSERT_EQ(told.status, 0) << told.errors;
    EXPECT_NE(told.output.find("\ndepth      hmax (timemax, n, m): water depth, by --field"),
              std::string::npos)
        << told.output;
    EXPECT_NE(told.output.find("\nlevel      zs (time, n, m): water level, by --field"),
              std::string::npos);
}

TEST_F(ForeignFilm, RecordsAreMeasuredARowEach) {
    const Ended measured = run({"measure", "flood.nc"});
    ASSERT_EQ(measured.status, 0) << measured.errors;
    EXPECT_TRUE(measured.output.starts_with("step,time_min,date,")) << measured.output;
    EXPECT_NE(measured.output.find("\n2,60,2019-08-31 15:00 UTC,"), std::string::npos);
}

TEST_F(ForeignFilm, WhatIsNotReadIsOneLineAndWritesNothing) {
    write_aeolis(folder_ / "bad.nc", {0, 3600, 60});
    for (const char* file : {"bad.nc", "film.toml", "none_*.nc", "https://a.org/a.nc"}) {
        const Ended ended = run({"film", file, "film.toml", "-o", "no.mp4"});
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "no.mp4"));
    }
}

}  // namespace
}  // namespace fumon::test
