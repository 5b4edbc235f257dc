#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "picture/exr.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* short_film =
    "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\ncap_height = 90\n"
    "[[shot]]\nseconds = 1\nmove = \"orbit\"\nturn = 60\n[[caption]]\nfrom = 0.2\nto = 1\ntext = "
    "\"seed {seed}\"\n";

/// A run that stored every second bed, and a film of it.
class FilmCommandTest : public ::testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", small_scene());
        write_text(folder_ / "film.toml", short_film);
        ASSERT_EQ(run({"output.fields_every=2"}).status, 0);
    }

    Ended run(const std::vector<std::string>& settings) {
        std::vector<std::string> arguments{"run",     "scene.toml",
                                           "-o",      "out",
                                           "--quiet", "--force",
                                           "--set",   "output.frames=false",
                                           "--set",   "output.movie=false",
                                           "--set",   "look.ground=table"};
        for (const std::string& setting : settings) {
            arguments.emplace_back("--set");
            arguments.push_back(setting);
        }
        return fumon(arguments, folder_.path());
    }

    Ended film(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"film", "out", "film.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(FilmCommandTest, MakesTheSameFilmOnAnyNumberOfThreads) {
    write_text(folder_ / "film.toml", std::string(short_film) +
                                          "[[card]]\nplace = \"end\"\nground = \"dark\"\nseconds = "
                                          "0.6\nlines = [\"{remake}\"]\n");
    const Ended one = film({"-o", "one.mp4", "--threads", "1"});
    ASSERT_EQ(one.status, 0) << one.errors;
    EXPECT_NE(one.errors.find("one.mp4: 7 frames of 64 x 48 pixels, 1.4 s"), std::string::npos)
        << one.errors;
    ASSERT_EQ(film({"-o", "two.mp4", "--threads", "2"}).status, 0);
    EXPECT_EQ(read_text(folder_ / "one.mp4"), read_text(folder_ / "two.mp4"));
    EXPECT_EQ(read_text(folder_ / "one.srt"), "1\n00:00:00,200 --> 00:00:01,000\nseed 5\n\n");
    std::string kept;
    for (const auto& [keyword, text] : read_movie_texts(folder_ / "one.mp4"))
        if (keyword == "fumon:film") kept = text;
    EXPECT_NE(kept.find("turn = 60"), std::string::npos);
    const Ended again = fumon({"film", "out", "one.mp4"}, folder_.path());
    ASSERT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(read_text(folder_ / "one.mp4"), read_text(folder_ / "one-again.mp4"));
    EXPECT_EQ(film({"-o", "one.mp4"}).status, 0) << "its own file is replaced";
    write_text(folder_ / "mine.mp4", "mine");
    EXPECT_EQ(film({"-o", "mine.mp4"}).status, 2);
}

TEST_F(FilmCommandTest, IsCheckedWithItsRun) {
    write_text(folder_ / "wrong.toml", "[[shot]]\nto = 21\n");
    const auto check = [&](const std::string& file, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"check", file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_.path());
    };
    EXPECT_EQ(check("wrong.toml").status, 0) << "of the runs it could be cut from none is known";
    const Ended wrong = check("wrong.toml", {"--run", "out"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.errors, "wrong.toml:2:6: shot.0.to = 21: the stored beds have steps 0 to 20\n");
    const Ended fits = check("film.toml", {"--run", "out"});
    EXPECT_EQ(fits.status, 0) << fits.errors;
    EXPECT_EQ(fits.output, "film.toml: fine (a film of 5 frames, 1 s, which fits out)\n");
    EXPECT_EQ(check("scene.toml", {"--run", "out"}).status, 2);
}

TEST_F(FilmCommandTest, APictureOfEachFrame) {
    const Ended made = film({"-o", "shot_%03d.png"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_EQ(made.errors, "shot_000.png to shot_004.png: 5 pictures of 64 x 48 pixels, 1 s\n");
    EXPECT_FALSE(fs::exists(folder_ / "shot_005.png"));
    ASSERT_EQ(film({"-o", "poster.png", "--set", "film.poster_second=0.2"}).status, 0);
    EXPECT_EQ(read_png(folder_ / "poster.png"), read_png(folder_ / "shot_001.png"));
    EXPECT_NE(read_png(folder_ / "poster.png"), read_png(folder_ / "shot_002.png"));
    EXPECT_EQ(fumon({"again", "shot_003.png", "-o", "third.png"}, folder_.path()).status, 0);
    EXPECT_EQ(read_text(folder_ / "third.png"), read_text(folder_ / "shot_003.png"));
    EXPECT_EQ(film({"-o", "shot_%03d.png"}).status, 0) << "its own files are replaced";
    write_text(folder_ / "mine_2.png", "mine");
    const Ended refused = film({"-o", "mine_%d.png"});
    EXPECT_EQ(refused.status, 2) << refused.errors;
    EXPECT_FALSE(fs::exists(folder_ / "mine_0.png"));
    EXPECT_EQ(film({"-o", "shot_%d.png", "--draft"}).status, 2);
}

TEST_F(FilmCommandTest, APictureOfEachFrameInAFolder) {
    const Ended made = film({"-o", "frames/"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_TRUE(made.errors.starts_with("frames/frame_00000.png to frames/frame_00004.png: 5 "))
        << made.errors;
    ASSERT_EQ(film({"-o", "shot_%d.png"}).status, 0);
    EXPECT_EQ(read_png(folder_ / "frames/frame_00002.png"), read_png(folder_ / "shot_2.png"));
    ASSERT_EQ(film({"-o", "new/shot_%d.png"}).status, 0) << "in a folder that was not there";
    EXPECT_TRUE(fs::exists(folder_ / "new/shot_4.png"));
}

TEST_F(FilmCommandTest, TheLightOfEachFrame) {
    write_text(folder_ / "film.toml",
               "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\n"
               "[[shot]]\nseconds = 1\nfrom = 4\nto = 4\n"
               "[[shot]]\nseconds = 1\nfrom = 4\nto = 4\ntransition = \"cross-fade\"\n"
               "transition_seconds = 0.4\n[shot.sun]\nelevation = 8\n"
               "[[overlay]]\nkind = \"time\"\n");
    const Ended made = film({"-o", "light_%02d.exr"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_TRUE(made.errors.starts_with("light_00.exr to light_")) << made.errors;
    const PictureText texts = read_exr_texts(folder_ / "light_00.exr");
    EXPECT_TRUE(std::ranges::any_of(texts, [](const auto& text) {
        return text.first == "fumon:film" && contains(text.second, "elevation = 8");
    }));
    EXPECT_EQ(film({"-o", "light_%02d.exr"}).status, 0) << "its own files are replaced";
    const std::string first = read_text(folder_ / "light_00.exr");
    ASSERT_EQ(film({"-o", "light_%02d.exr", "--threads", "1"}).status, 0);
    EXPECT_EQ(read_text(folder_ / "light_00.exr"), first);
    EXPECT_NE(read_text(folder_ / "light_05.exr"), first) << "the sun is another by then";
    const Ended one = film({"-o", "light.exr"});
    EXPECT_EQ(one.status, 2);
    EXPECT_EQ(one.errors, "light.exr: OpenEXR holds one frame a file; name it light_%05d.exr\n");
    write_text(folder_ / "film.toml",
               std::string(short_film) + "[[card]]\nground = \"dark\"\nseconds = 0.6\n");
    EXPECT_EQ(film({"-o", "card_%d.exr"}).status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "card_0.exr"));
}

TEST_F(FilmCommandTest, AgainSimulatesItsRunsAndGivesTheSameBytes) {
    ASSERT_EQ(film({"-o", "f.mp4"}).status, 0);
    ASSERT_EQ(film({"-o", "f.webp", "--max-size", "2500"}).status, 0);
    ASSERT_EQ(fumon({"film", "out", "out", "film.toml", "-o", "two.mp4", "--set",
                     "film.cap_height=40", "--set", "film.width=128"},
                    folder_.path())
                  .status,
              0);
    fs::remove_all(folder_ / "out");
    ASSERT_EQ(run({"output.bed_every=3", "output.bed_at=[1]"}).status, 0);
    ASSERT_EQ(film({"-o", "beds.mp4"}).status, 0);
    fs::remove_all(folder_ / "out");
    for (const char* name : {"f.mp4", "f.webp", "two.mp4", "beds.mp4"}) {
        const fs::path made =
            fs::path(name).stem().string() + "-again" + fs::path(name).extension().string();
        const Ended again = fumon({"again", name, "--threads", "2", "--force"}, folder_.path());
        EXPECT_TRUE(again.errors.ends_with(made.string() + ": the same bytes as " + name + "\n"))
            << again.errors;
        EXPECT_EQ(read_text(folder_ / made.string()), read_text(folder_ / name)) << name;
    }
    fs::remove(folder_ / "f.webp.json");
    EXPECT_EQ(fumon({"again", "f.webp"}, folder_.path()).status, 2);
}

TEST_F(FilmCommandTest, AgainTakesTheLayersThatItsMetadataLists) {
    const std::string line = R"({"type":"LineString","coordinates":[[2,2],[20,15]]})";
    fs::create_directory(folder_ / "cut");
    write_text(folder_ / "cut" / "line.geojson", line);
    write_text(
        folder_ / "cut" / "film.toml",
        std::string(short_film) + "[[layer]]\nfile = \"line.geojson\"\ncolour = \"#ff0000\"\n");
    const Ended made =
        fumon({"film", "out", "cut/film.toml", "-o", "cut/f.png", "--set", "film.format=poster"},
              folder_.path());
    ASSERT_EQ(made.status, 0) << made.errors;
    const auto again = [&] {
        return fumon({"again", "cut/f.png", "-o", "again.png", "--force"}, folder_.path());
    };
    const Ended same = again();
    EXPECT_EQ(same.status, 0) << same.errors;
    EXPECT_EQ(read_text(folder_ / "again.png"), read_text(folder_ / "cut" / "f.png"));
    write_text(folder_ / "cut" / "line.geojson", line + "\n");
    const Ended changed = again();
    EXPECT_EQ(changed.status, 2);
    EXPECT_NE(changed.errors.find("line.geojson as it was when the film was made (SHA-256 "),
              std::string::npos)
        << changed.errors;
}

TEST_F(FilmCommandTest, MakesSheetsPostersAndFilesThatFit) {
    const Ended ended =
        film({"-o", "f.mp4", "--formats", "sheet,poster,webp", "--set", "shot.0.seconds=2"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    ASSERT_EQ(film({"-o", "free.gif"}).status, 0);
    const auto bytes = fs::file_size(folder_ / "free.gif");
    const Ended fitted = film({"-o", "f.gif", "--max-size", std::to_string(bytes / 2)});
    ASSERT_EQ(fitted.status, 0) << fitted.errors;
    EXPECT_LE(fs::file_size(folder_ / "f.gif"), bytes / 2);
    EXPECT_GT(fs::file_size(folder_ / "f.gif"), bytes / 8);
    const Image sheet = read_png(folder_ / "f-sheet.png");
    EXPECT_EQ(sheet.width, 3 * 64 + 2 * 4);  // seconds 0 and 1, and the last frame
    EXPECT_EQ(sheet.height, 48);
    EXPECT_EQ(read_png(folder_ / "f-poster.png").width, 64);
    EXPECT_TRUE(fs::exists(folder_ / "f-webp.webp.json"));
    EXPECT_EQ(film({"-o", "f.mp4", "--formats", "webp"}).status, 0) << "known by its sidecar";
}

TEST_F(FilmCommandTest, ADraftIsSmallAndHasASheet) {
    const Ended ended = film({"-o", "f.mp4", "--draft", "--set", "film.width=256", "--set",
                              "film.height=192", "--set", "film.rate=20"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("f-draft.mp4: 2 frames of 64 x 48 pixels"), std::string::npos)
        << ended.errors;
    EXPECT_NE(ended.errors.find("f-draft.png: 2 frames of 64 x 48 pixels"), std::string::npos)
        << ended.errors;
    const Image sheet = read_png(folder_ / "f-draft.png");
    EXPECT_EQ(sheet.width, 2 * 64 + 4);
    for (const std::string name : {"f-draft.mp4", "f-draft.png"}) {
        const Ended again = fumon({"again", name}, folder_.path());
        EXPECT_TRUE(again.errors.ends_with(": the same bytes as " + name + "\n")) << again.errors;
    }
}

TEST_F(FilmCommandTest, ADraftSaysWhatTheWholeFilmWouldShowAndWhichEndingItTakes) {
    // The run of 20 steps stored 11 beds.
    const std::string note =
        "its 60 frames show 11 stored beds, each as it is, so that the ground moves in jumps; ";
    const std::vector<std::string> sixty{"--set", "film.rate=30", "--set", "shot.0.seconds=2",
                                         "--set", "film.width=64"};
    std::vector<std::string> draft{"-o", "f.mp4", "--draft"};
    draft.insert(draft.end(), sixty.begin(), sixty.end());
    const Ended drafted = film(draft);
    EXPECT_EQ(drafted.status, 0);
    EXPECT_NE(drafted.errors.find(note + "for a smoother film shorten the shot"), std::string::npos)
        << drafted.errors;
    const Ended smooth = film({"-o", "f.mp4", "--draft", "--set", "film.rate=16"});
    EXPECT_EQ(smooth.errors.find("in jumps"), std::string::npos) << smooth.errors;
    const std::vector<std::string> thirty{"-o",           "f.mp4", "--draft",         "--set",
                                          "film.rate=10", "--set", "shot.0.seconds=3"};
    EXPECT_EQ(film(thirty).errors.find("in jumps"), std::string::npos);
    std::vector<std::string> uneven = thirty;
    uneven.insert(uneven.end(), {"--set", "shot.0.pace=change"});
    const Ended change = film(uneven);
    EXPECT_NE(change.errors.find("10 of its 30 frames show 3 stored beds"), std::string::npos)
        << change.errors;
    ASSERT_EQ(run({"output.fields_every=5"}).status, 0);
    const Ended sparse = film({"-o", "f.mp4", "--set", "film.rate=16"});
    EXPECT_NE(sparse.errors.find("its 16 frames show 5 stored beds, each as it is, so that the "
                                 "ground moves in jumps; for a smoother film run the scene with "
                                 "--set output.fields_every=2"),
              std::string::npos)
        << sparse.errors;

    const Ended avi = film({"-o", "g.avi", "--draft"});
    EXPECT_EQ(avi.status, 2);
    EXPECT_EQ(avi.errors, "g.avi: --draft makes an MP4 and a sheet of pictures; name it g.mp4\n");
    EXPECT_FALSE(fs::exists(folder_ / "g-draft.mp4"));
}

TEST_F(FilmCommandTest, ADraftHasLessOfItsGroundRefined) {
    const auto still = [&](const std::string& draft) {
        const Ended ended = film({"-o", draft + ".png", "--set", "film.width=320", "--set",
                                  "film.height=240", "--set", "film.draft=" + draft});
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return read_png(folder_ / (draft + ".png"));
    };
    const Image whole = still("false");
    const Image draft = still("true");
    double sum = 0.0;
    for (std::size_t i = 0; i < whole.rgb.size(); ++i) sum += std::abs(whole.rgb[i] - draft.rgb[i]);
    const double mean = sum / static_cast<double>(whole.rgb.size());
    EXPECT_GT(mean, 0.0);
    EXPECT_LT(mean, 2.0) << "of one framing, light and colours";
}

TEST_F(FilmCommandTest, SaysWhatIsMissingAndWritesNothing) {
    EXPECT_EQ(film({"--set", "shot.0.from=1e4"}).errors,
              "--set 1: shot.0.from = 10000: the stored beds have steps 0 to 20\n");
    write_text(folder_ / "film.toml", "[[shot]]\nsecond = 1\n");
    const Ended wrong = film({});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.errors,
              "film.toml:2:1: unknown key shot.0.second; did you mean "
              "\"shot.0.seconds\"?\n");
    write_text(folder_ / "film.toml", short_film);
    ASSERT_EQ(run({}).status, 0);
    const Ended none = film({});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.errors,
              "out: its run stored no beds to cut a film from; run the scene again with "
              "--set output.fields_every=N (all fields) or output.bed_every=N (beds alone), every "
              "N steps\n");
    EXPECT_EQ(fumon({"film", "nowhere", "film.toml"}, folder_.path()).status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
}

/// Of a movie that plays up to its last one, one a second.
int fragments_of(const fs::path& movie) {
    const std::string bytes = read_text(movie);
    int fragments = 0;
    for (std::size_t at = bytes.find("moof"); at != std::string::npos;
         at = bytes.find("moof", at + 1))
        ++fragments;
    return fragments;
}

TEST_F(FilmCommandTest, ARunCalledAsAShippedFilmIsNotTakenForItself) {
    fs::copy(folder_ / "out", folder_ / "barchans", fs::copy_options::recursive);
    const Ended film = fumon({"film", "barchans", "barchans", "--print"}, folder_.path());
    EXPECT_NE(film.errors.find("barchans: --print, --style and --seconds are for a film by rule"),
              std::string::npos)
        << film.errors;
    const Ended two = fumon({"film", "out", "barchans", "--print"}, folder_.path());
    EXPECT_EQ(two.status, 0) << two.errors;
    EXPECT_NE(two.errors.find("barchans: the run in that folder; barchans.toml is the film"),
              std::string::npos)
        << two.errors;
}

TEST_F(FilmCommandTest, OneThatIsKilledLeavesNoHalfFile) {
    for (const int signal : {SIGINT, SIGKILL}) {
        Program long_film(
            {"film", "out", "film.toml", "-o", "f.mp4", "--set", "shot.0.seconds=3000"},
            folder_.path());
        const fs::path part = folder_ / "f.mp4.part";
        for (int i = 0; i < 12000 && !(fs::exists(part) && fragments_of(part) >= 2); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ASSERT_TRUE(fs::exists(part));
        EXPECT_GE(fragments_of(part), 2) << "what a killed film leaves plays";
        long_film.send(signal);
        const Ended ended = long_film.wait();
        EXPECT_EQ(ended.status, 128 + signal);
        EXPECT_EQ(contains(ended.errors, "and not written; with --resume the same command would"),
                  signal == SIGINT)
            << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "f.mp4"));
        EXPECT_EQ(fs::exists(part), signal == SIGKILL);
    }
    EXPECT_EQ(film({"-o", "f.mp4", "--force"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "f.mp4.part"));
    EXPECT_FALSE(fs::exists(folder_ / "f.mp4.whole.part"));
}

TEST_F(FilmCommandTest, OneThatWasStoppedGoesOnAndHasTheSameBytes) {
    const std::vector<std::string> longer{"--set", "shot.0.seconds=16"};  // 80 frames
    const auto arguments = [&](const std::string& file, const std::string& how) {
        std::vector<std::string> all{"film", "out", "film.toml", "-o", file};
        if (!how.empty()) all.push_back(how);
        all.insert(all.end(), longer.begin(), longer.end());
        return all;
    };
    ASSERT_EQ(fumon(arguments("whole.mp4", ""), folder_.path()).status, 0);
    const fs::path kept = folder_ / "f.mp4.frames";
    int frame = 32;  // the encoder holds some back
    for (const int signal : {SIGKILL, SIGINT}) {
        Program stopped(arguments("f.mp4", "--resume"), folder_.path());
        const fs::path drawn = kept / ("frame_0000" + std::to_string(frame) + ".png");
        for (int i = 0; i < 12000 && !fs::exists(drawn); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ASSERT_TRUE(fs::exists(drawn));
        stopped.send(signal);
        const Ended ended = stopped.wait();
        ASSERT_EQ(ended.status, 128 + signal) << "it ended before it was stopped";
        EXPECT_EQ(contains(ended.errors, "and not written; the same command goes on there"),
                  signal == SIGINT)
            << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "f.mp4"));
        EXPECT_GE(fragments_of(kept / "so-far.mp4"), signal == SIGKILL ? 2 : 8);
        frame += 6;
    }
    write_text(kept / "frame_000003.png", read_text(kept / "frame_000004.png"));
    ASSERT_EQ(fumon(arguments("f.mp4", "--resume"), folder_.path()).status, 0);
    EXPECT_NE(read_text(folder_ / "f.mp4"), read_text(folder_ / "whole.mp4")) << "none was kept";
    EXPECT_FALSE(fs::exists(kept));
    Program again(arguments("f.mp4", "--resume"), folder_.path());
    for (int i = 0; i < 12000 && !fs::exists(kept / "frame_000009.png"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    again.send(SIGKILL);
    again.wait();
    ASSERT_EQ(fumon(arguments("f.mp4", "--resume"), folder_.path()).status, 0);
    EXPECT_EQ(read_text(folder_ / "f.mp4"), read_text(folder_ / "whole.mp4"));
    fs::create_directory(folder_ / "g.mp4.frames");
    const Ended refused = fumon(arguments("g.mp4", "--resume"), folder_.path());
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(refused.errors.ends_with(
        "g.mp4.frames: already exists and holds no frames of a film; move it away\n"))
        << refused.errors;
}

}  // namespace
}  // namespace fumon::test
