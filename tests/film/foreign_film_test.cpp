// Films and stills of the results of other models, as a user makes them.

#include "support/foreign_film.h"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_layouts.h"
#include "picture/png.h"
#include "support/netcdf_file.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ForeignFilm, IsMadeOfAFileAndAgain) {
    const Ended made = run({"film", "flood.nc", "film.toml", "-o", "a.mp4"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended again = run({"again", "a.mp4", "-o", "b.mp4"});
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_NE(again.errors.find("b.mp4: the same bytes as a.mp4"), std::string::npos)
        << again.errors;
    write_sfincs(folder_ / "flood.nc", 0.8, 0.6);
    const Ended other = run({"again", "a.mp4", "-o", "c.mp4"});
    EXPECT_EQ(other.status, 2);
    EXPECT_NE(other.errors.find("flood.nc: is not the file that the film was made of"),
              std::string::npos)
        << other.errors;
    EXPECT_FALSE(fs::exists(folder_ / "c.mp4"));
    const Ended from = run({"again", "a.mp4", "-o", "c.mp4", "--from", "flood.nc"});
    EXPECT_EQ(from.status, 0) << from.errors;
    EXPECT_EQ(
        run({"again", "a.mp4", "-o", "d.mp4", "--from", "flood.nc", "--from", "flood.nc"}).status,
        2);
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

TEST_F(ForeignFilm, AStillIsMadeAgainFromItsFile) {
    fs::create_directory(folder_ / "data");
    fs::rename(folder_ / "flood.nc", folder_ / "data/flood.nc");
    const Ended made =
        run({"still", "data/flood.nc", "--step", "1", "-o", "a.png", "--colour", "hmax", "--field",
             "level=zs", "--set", "image.width=160", "--set", "image.height=120"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const auto again = [&](std::vector<std::string> more) {
        more.insert(more.begin(), "again");
        const Ended ended = run(more);
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
        return ended;
    };
    EXPECT_EQ(again({"a.png", "-o", "b.png"}).errors, "b.png: the same pixels as a.png\n");
    EXPECT_TRUE(read_text(folder_ / "a.png") == read_text(folder_ / "b.png"));
    for (const char* place : {"moved/flood.nc", "flood.nc"}) {  // beside the picture, here
        fs::create_directory(folder_ / "moved");
        fs::rename(folder_ / "data", folder_ / "gone");
        fs::rename(folder_ / "gone/flood.nc", folder_ / place);
        fs::copy(folder_ / "a.png", folder_ / "moved/a.png");
        EXPECT_EQ(again({"moved/a.png", "-o", "c.png", "--force"}).errors,
                  "c.png: the same pixels as moved/a.png\n");
        EXPECT_TRUE(read_text(folder_ / "a.png") == read_text(folder_ / "c.png"));
        fs::create_directory(folder_ / "data");
        fs::rename(folder_ / place, folder_ / "data/flood.nc");
        fs::remove_all(folder_ / "moved");
        fs::remove_all(folder_ / "gone");
    }
    write_sfincs(folder_ / "data/flood.nc", 0.8, 0.6);
    const Ended other = again({"a.png", "-o", "d.png"});
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.errors,
              "data/flood.nc: is not the file that the picture was made of: its content has "
              "changed; --from data/flood.nc takes it\n");
    EXPECT_FALSE(fs::exists(folder_ / "d.png"));
    const Ended from = run({"again", "a.png", "-o", "d.png", "--from", "data/flood.nc"});
    EXPECT_EQ(from.status, 0) << from.errors;
    EXPECT_NE(from.errors.find("its content has changed"), std::string::npos) << from.errors;
    EXPECT_TRUE(fs::exists(folder_ / "d.png"));
    fs::remove_all(folder_ / "data");
    EXPECT_EQ(again({"a.png", "-o", "e.png"}).errors,
              "a.png: flood.nc, of which the picture was made, is missing; copy it beside the "
              "picture, or name it by --from FILE\n");
    EXPECT_EQ(
        again({"a.png", "-o", "e.png", "--set", "bed.file=flood.nc"}).errors,
        "--set 1:10: bed.file: a.png shows another model's results; --from FILE takes another "
        "file of them\n");
}

TEST_F(ForeignFilm, AStillOfSeveralFilesIsMadeAgain) {
    fs::create_directory(folder_ / "s");
    const std::string head = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n";
    for (const int year : {1, 2}) {
        const std::string number = std::to_string(year);
        write_text(folder_ / ("s/elev_" + number + ".asc"), head + "0 1 2\n1 2 3\n");
        write_text(folder_ / ("s/depth_" + number + ".asc"), head + "0 1 0\n1 " + number + " 0\n");
    }
    const Ended made =
        run({"still", "s/elev_*.asc", "--step", "1", "-o", "a.png", "--field",
             "depth=s/depth_*.asc", "--set", "image.width=160", "--set", "image.height=120"});
    ASSERT_EQ(made.status, 0) << made.errors;
    fs::rename(folder_ / "s", folder_ / "t");
    fs::rename(folder_ / "a.png", folder_ / "t/a.png");
    const Ended again = run({"again", "t/a.png", "-o", "b.png"});
    EXPECT_EQ(again.errors, "b.png: the same pixels as t/a.png\n");
    EXPECT_TRUE(read_text(folder_ / "t/a.png") == read_text(folder_ / "b.png"));
    write_text(folder_ / "t/depth_2.asc", head + "0 1 0\n1 9 0\n");
    const Ended other = run({"again", "t/a.png", "-o", "c.png"});
    EXPECT_NE(other.errors.find("t/depth_2.asc: is not the file"), std::string::npos)
        << other.errors;
    fs::remove(folder_ / "t/depth_2.asc");
    const Ended missing = run({"again", "t/a.png", "-o", "c.png"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_NE(missing.errors.find(
                  "depth_2.asc: is one of the files that the picture was made of, and is missing"),
              std::string::npos)
        << missing.errors;
    for (const char* added : {"elev_3", "depth_2", "depth_3"})
        write_text(folder_ / ("t/" + std::string(added) + ".asc"), head + "0 1 0\n1 2 0\n");
    const Ended more = run({"again", "t/a.png", "-o", "c.png"});
    EXPECT_EQ(more.status, 2);
    EXPECT_TRUE(more.errors.starts_with(
        "t/elev_3.asc: is none of the files that the picture was made of; --from t/elev_*.asc "))
        << more.errors;
    const Ended own = run({"again", "b.png", "-o", "c.png", "--from", "x.nc"});
    EXPECT_EQ(own.status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "c.png"));
}

TEST_F(ForeignFilm, FromIsOneRunOfAnotherModel) {
    const std::vector<std::string> small{"--step",          "0",     "--set",
                                         "image.width=160", "--set", "image.height=120"};
    const auto still = [&](std::vector<std::string> all) {
        all.insert(all.end(), small.begin(), small.end());
        ASSERT_EQ(run(all).status, 0);
    };
    still({"still", "flood.nc", "-o", "a.png"});
    EXPECT_EQ(run({"again", "a.png", "--from", "flood.nc", "--from", "flood.nc"}).errors,
              "a.png: --from is given 2 times, but a picture shows one run; several files of it "
              "are a pattern of names ('elev_*.asc')\n");
    write_text(folder_ / "scene.toml", small_scene());
    still({"still", "scene.toml", "-o", "own.png"});
    EXPECT_EQ(run({"again", "own.png", "--from", "flood.nc"}).errors,
              "own.png: --from belongs to pictures and films of other models' results, and this is "
              "none\n");
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

TEST_F(ForeignFilm, FieldsOfFumonThatLackAKeyAreAsBeforeIt) {
    write_text(folder_ / "scene.toml", small_scene());
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.frames=false",
                   "--set", "output.movie=false", "--set", "output.fields_every=2"})
                  .status,
              0);
    fs::rename(folder_ / "out/fields.nc", folder_ / "alone.nc");
    int id = 0;
    std::size_t length = 0;
    must(nc_open((folder_ / "alone.nc").c_str(), NC_WRITE, &id));
    must(nc_inq_attlen(id, NC_GLOBAL, "scene", &length));
    std::string scene(length, ' ');
    must(nc_get_att_text(id, NC_GLOBAL, "scene", scene.data()));
    const std::string key = "\ncontrast = \"auto\"";
    ASSERT_NE(scene.find(key), std::string::npos);
    scene.erase(scene.find(key), key.size());
    must(nc_redef(id));
    must(nc_put_att_text(id, NC_GLOBAL, "scene", scene.size(), scene.data()));
    must(nc_close(id));
    write_text(folder_ / "film.toml", std::string(film_of_dates) + "text = \"{step}\"\n");
    ASSERT_EQ(run({"film", "alone.nc", "film.toml", "-o", "alone_%02d.png"}).status, 0);
    std::string filmed;
    for (const auto& [keyword, text] : read_png_texts(folder_ / "alone_00.png"))
        if (keyword == "fumon:scene") filmed = text;
    EXPECT_TRUE(contains(filmed, "\ncontrast = \"auto-0.2\"")) << filmed;
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

TEST_F(ForeignFilm, AMapOfTheFileColoursTheGround) {
    const auto still = [&](const std::string& file, std::vector<std::string> more) {
        std::vector<std::string> all{
            "still", "flood.nc", "--step",          "2",     "-o",
            file,    "--set",    "image.width=320", "--set", "image.height=240"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    ASSERT_EQ(still("plain.png", {}).status, 0);
    const Ended coloured = still("coloured.png", {"--colour", "hmax"});
    ASSERT_EQ(coloured.status, 0) << coloured.errors;
    ASSERT_EQ(still("set.png", {"--set", "look.colour_by=field", "--set", "look.field=hmax",
                                "--set", "look.palette=viridis"})
                  .status,
              0);
    EXPECT_NE(read_png(folder_ / "plain.png"), read_png(folder_ / "coloured.png"));
    EXPECT_EQ(read_png(folder_ / "set.png"), read_png(folder_ / "coloured.png"));
    const Ended unknown = still("no.png", {"--colour", "hmaxx"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.errors,
              "flood.nc: has no map \"hmaxx\" to colour by; did you mean \"hmax\"?\n");
    EXPECT_FALSE(fs::exists(folder_ / "no.png"));
}

TEST_F(ForeignFilm, AFilmByRuleIsPrintedAndColoured) {
    const Ended printed = run({"film", "flood.nc", "--print", "--colour", "hmax"});
    ASSERT_EQ(printed.status, 0) << printed.errors;
    for (const char* line : {"title = \"Flood\"", "colour_by = \"field\"", "field = \"hmax\"",
                             "kind = \"colour-bar\"", "text = \"{date}\""})
        EXPECT_NE(printed.output.find(line), std::string::npos) << line << "\n" << printed.output;
    write_text(folder_ / "printed.toml", printed.output);
    const Ended checked = run({"check", "printed.toml", "--run", "flood.nc"});
    EXPECT_EQ(checked.status, 0) << checked.errors;
}

TEST_F(ForeignFilm, TwoRunsAreNamedByTheirFilesAndTheirWatersDiffer) {
    const std::string one_frame =
        "[film]\nwidth = 160\nheight = 120\nrate = 5\nsupersampling = 1\n[[shot]]\n"
        "seconds = 0.2\n";
    write_text(folder_ / "film.toml", one_frame);
    fs::create_directory(folder_ / "b");
    fs::copy(folder_ / "flood.nc", folder_ / "b/flood.nc");
    fs::create_directory(folder_ / "c");
    fs::copy(folder_ / "flood.nc", folder_ / "c/flood.nc");
    const auto panes = [&](const std::string& one, const std::string& other,
                           std::vector<std::string> more) {
        more.insert(more.begin(), {"film", one, other, "film.toml", "--no-cache", "--force", "-o",
                                   "panes_%02d.png"});
        const Ended made = run(more);
        EXPECT_EQ(made.status, 0) << made.errors;
        return read_png(folder_ / "panes_00.png");
    };
    const std::vector<std::string> in_b{"--set", "panes.label=b/flood.nc"};
    EXPECT_EQ(panes("b/flood.nc", "b/flood.nc", {}), panes("flood.nc", "c/flood.nc", in_b));
    EXPECT_NE(panes("b/flood.nc", "c/flood.nc", {}), panes("b/flood.nc", "c/flood.nc", in_b))
        << "of one name in two folders";
    write_text(folder_ / "difference.toml",
               one_frame + "[[overlay]]\nkind = \"colour-bar\"\n[panes]\nshow = \"difference\"\n");
    const auto difference = [&](const std::string& name, std::vector<std::string> look) {
        look.insert(look.begin(), {"film", "flood.nc", "b/flood.nc", "difference.toml",
                                   "--no-cache", "-o", name + "_%02d.png"});
        const Ended made = run(look);
        EXPECT_EQ(made.status, 0) << made.errors;
        return read_png(folder_ / (name + "_00.png"));
    };
    const Image depth = difference("depth", {"--set", "look.colour_by=water-depth"});
    EXPECT_EQ(depth, difference("field", {"--set", "look.colour_by=field", "--set",
                                          "look.field=water_depth"}));
    EXPECT_NE(depth, difference("heights", {}));
    const Ended slopes = run({"film", "flood.nc", "b/flood.nc", "difference.toml", "--set",
                              "look.colour_by=slope", "-o", "no_%02d.png"});
    EXPECT_EQ(slopes.status, 2);
    EXPECT_NE(slopes.errors.find("in height, water depth or a field"), std::string::npos)
        << slopes.errors;
}

TEST_F(ForeignFilm, AHeapOnAFlatIsWhatAFilmByRuleShows) {
    const std::string head = "ncols 12\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 5\n";
    for (const int record : {1, 2}) {
        std::string heights = head;
        std::string depths = head;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 12; ++x) {
                const int low = 3 - std::max(std::abs(x - 4 - record), std::abs(y - 4));
                heights += std::to_string(std::max(0, low)) + " ";
                depths += "0 ";
            }
        }
        write_text(folder_ / ("sand_" + std::to_string(record) + ".asc"), heights);
        write_text(folder_ / ("water_" + std::to_string(record) + ".asc"), depths);
    }
    const Ended printed = run({"film", "sand_*.asc", "--field", "depth=water_*.asc", "--print"});
    EXPECT_NE(printed.output.find("# close to the highest"), std::string::npos) << printed.output;
    for (const char* absent : {"stream", "cover ="})
        EXPECT_EQ(printed.output.find(absent), std::string::npos) << printed.output;
    EXPECT_NE(printed.output.find("title = \"Sand\""), std::string::npos) << printed.output;
}

TEST_F(ForeignFilm, AMountainOnAPlainIsNoSand) {
    std::string heights = "ncols 12\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 500\n";
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 12; ++x)
            heights +=
                std::to_string(500 * std::max(0, 3 - std::max(std::abs(x - 5), std::abs(y - 4)))) +
                " ";
    for (const char* file : {"land_1.asc", "land_2.asc"}) write_text(folder_ / file, heights);
    const Ended printed = run({"film", "land_*.asc", "--print"});
    EXPECT_NE(printed.output.find("cover = \"auto\""), std::string::npos) << printed.output;
}

TEST_F(ForeignFilm, AColouredFilmIsMadeAgainFromItsFile) {
    const Ended made = run({"film", "flood.nc", "film.toml", "--colour", "hmax", "-o", "a.mp4"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended again = run({"again", "a.mp4", "-o", "b.mp4"});
    EXPECT_NE(again.errors.find("b.mp4: the same bytes as a.mp4"), std::string::npos)
        << again.errors;
    write_text(folder_ / "difference.toml",
               std::string(film_of_dates) +
                   "[panes]\nshow = \"difference\"\n[look]\ncolour_by = "
                   "\"field\"\nfield = \"hmax\"\n");
    fs::copy(folder_ / "flood.nc", folder_ / "other.nc");
    const Ended two = run({"film", "flood.nc", "other.nc", "difference.toml", "-o", "c.mp4"});
    EXPECT_EQ(two.status, 0) << two.errors;
}

TEST_F(ForeignFilm, UnevenSurveysAreHeldWithTheirDates) {
    for (const char* day : {"2001-05-01", "2003-01-01", "2010-07-01"}) {
        write_text(folder_ / (std::string("a-") + day + ".asc"),
                   "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n0 1 2\n1 2 3\n");
        write_text(folder_ / (std::string("b-") + day + ".asc"),
                   "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n0 1 2\n1 2 4\n");
    }
    fs::rename(folder_ / "b-2003-01-01.asc", folder_ / "b-2009-01-01.asc");
    write_text(folder_ / "surveys.toml",
               "[film]\nwidth = 160\nheight = 120\nrate = 10\nsupersampling = 1\n"
               "[[shot]]\nseconds = 1\nfrom = \"start\"\nto = \"end\"\nclock = \"time\"\n"
               "[[overlay]]\nkind = \"time\"\n");
    const Ended one = run({"film", "a-*.asc", "surveys.toml", "--time-pattern", "%Y-%m-%d", "-o",
                           "one_%02d.png", "--no-cache"});
    ASSERT_EQ(one.status, 0) << one.errors;
    const auto frame = [&](const std::string& name) { return read_png(folder_ / (name + ".png")); };
    EXPECT_NE(frame("one_00"), frame("one_01"));  // the beds are alike, the dates are not
    EXPECT_EQ(frame("one_01"), frame("one_05"));
    EXPECT_NE(frame("one_05"), frame("one_06"));
    EXPECT_EQ(frame("one_06"), frame("one_09"));
    const Ended two = run({"film", "a-*.asc", "b-*.asc", "surveys.toml", "--time-pattern",
                           "%Y-%m-%d", "-o", "two_%02d.png", "--no-cache"});
    ASSERT_EQ(two.status, 0) << two.errors;
    EXPECT_NE(frame("two_05"), frame("two_06"));
}

TEST_F(ForeignFilm, BlendsBetweenRecordsWhereThatIsAskedFor) {
    for (const auto& [day, height] : {std::pair{"2001-01-01", "0"}, {"2001-01-03", "2"}}) {
        write_text(folder_ / (std::string("a-") + day + ".asc"),
                   std::string("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n0 1 2\n") +
                       "1 2 " + height + "\n");
    }
    write_text(folder_ / "film.toml",
               "[film]\nwidth = 160\nheight = 120\nrate = 5\nsupersampling = 1\n"
               "[[shot]]\nseconds = 1\nclock = \"time\"\n[[overlay]]\nkind = \"time\"\n");
    const auto film = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> all{"film",     "a-*.asc",    "film.toml", "--time-pattern",
                                     "%Y-%m-%d", "--no-cache", "-o",        name + "_%02d.png"};
        all.insert(all.end(), more.begin(), more.end());
        const Ended made = run(all);
        EXPECT_EQ(made.status, 0) << made.errors;
    };
    const auto frame = [&](const std::string& name) { return read_png(folder_ / (name + ".png")); };
    film("usual", {});
    film("held", {"--set", "film.between=held"});
    film("blended", {"--set", "film.between=blend"});
    EXPECT_EQ(read_text(folder_ / "usual_01.png"), read_text(folder_ / "held_01.png"));
    EXPECT_EQ(frame("held_00"), frame("held_01"));
    EXPECT_NE(frame("blended_00"), frame("blended_01"));
    EXPECT_NE(frame("blended_00"), frame("held_00"));  // the plate says what is blended
    EXPECT_NE(read_text(folder_ / "blended_00.png").find("fumon:between-records"),
              std::string::npos);
    EXPECT_EQ(run({"again", "blended_01.png", "-o", "again.png"}).errors,
              "again.png: the same bytes as blended_01.png\n");
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
