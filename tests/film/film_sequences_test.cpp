// Frames of sequences, made again.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

TEST(FilmSequences, AFrameIsMadeAgainAlone) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.frames=false",
                     "--set", "output.movie=false", "--set", "output.fields_every=2"},
                    folder.path())
                  .status,
              0);
    const auto film = [&](const std::string& output) {
        return fumon({"film", "out", "film.toml", "-o", output}, folder.path()).status;
    };
    write_text(folder / "film.toml",
               "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\n"
               "[[shot]]\nseconds = 1\n[[shot]]\nseconds = 1\ntransition = \"cross-fade\"\n"
               "transition_seconds = 0.4\n");
    ASSERT_EQ(film("light_%02d.exr"), 0);
    ASSERT_EQ(film("frame_%02d.png"), 0);
    fs::rename(folder / "out", folder / "gone");
    const auto again = [&](const std::string& of, const std::vector<std::string>& more = {}) {
        std::vector<std::string> all{"again", of};
        all.insert(all.end(), more.begin(), more.end());
        const Ended ended = fumon(all, folder.path());
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return ended.errors;
    };
    for (const std::string number : {"03", "05"}) {  // of one shot, and of two
        const std::string light = "light_" + number;
        const std::string frame = "frame_" + number;
        EXPECT_EQ(again(light + ".exr"),
                  light + "-again.exr: the same bytes as " + light + ".exr\n");
        EXPECT_EQ(again(frame + ".png"),
                  frame + "-again.png: the same bytes as " + frame + ".png\n");
        // Each as the other.
        EXPECT_EQ(again(light + ".exr", {"-o", light + ".png"}), light + ".png: made\n");
        EXPECT_EQ(read_text(folder / (light + ".png")), read_text(folder / (frame + ".png")));
        EXPECT_EQ(again(frame + ".png", {"-o", frame + ".exr"}), frame + ".exr: made\n");
        EXPECT_EQ(read_text(folder / (frame + ".exr")), read_text(folder / (light + ".exr")));
    }
    EXPECT_NE(read_text(folder / "light_03.exr"), read_text(folder / "light_05.exr"));
    const Ended movie = fumon({"again", "light_03.exr", "-o", "a.mp4"}, folder.path());
    EXPECT_EQ(movie.status, 2);
    EXPECT_TRUE(movie.errors.starts_with("a.mp4: the name of this film must end in"))
        << movie.errors;
}

}  // namespace
}  // namespace fumon::test
