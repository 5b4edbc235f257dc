#include <gtest/gtest.h>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A run with a movie and a still, made once; each test has folders of its own.
const ScratchFolder& shown_results() {
    static const ScratchFolder folder;
    static const bool made = [] {
        write_text(folder / "scene.toml", small_scene() + "[output]\nfields_every = 10\n");
        write_text(folder / "film.toml",
                   "[film]\nwidth = 32\nheight = 32\nrate = 2\n[[shot]]\nseconds = 1\n");
        return fumon({"run", "scene.toml", "-o", "out/dunes", "--quiet", "--set",
                      "title=\"a <b> & c\""},
                     folder.path())
                       .status == 0 &&
               fumon({"still", "scene.toml", "-o", "out/still.png"}, folder.path()).status == 0 &&
               fumon({"film", "out/dunes", "film.toml", "-o", "out/cut.webp"}, folder.path())
                       .status == 0;
    }();
    EXPECT_TRUE(made);
    write_text(folder / "out/notes.txt", "mine");
    return folder;
}

TEST(GalleryCommand, HoldsAllThatFumonMadeAndNeedsNoNetwork) {
    const ScratchFolder& folder = shown_results();
    const Ended ended = fumon({"gallery", "out", "-o", "site", "--title", "<mine>"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(ended.errors, "site/index.html: 3 pictures and films\n");
    const std::string page = read_text(folder / "site/index.html");
    for (const char* wanted :
         {"<h1>&lt;mine&gt;</h1>", "a &lt;b&gt; &amp; c", "fumon again files/still.png",
          "fumon run files/dunes.toml -o out/dunes", "fumon film out/cut files/cut.webp.json",
          "<th scope=\"row\">model.creep_rate</th>", "files/dunes-plot-1.svg", "files/dunes.mp4"})
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    for (const char* file : {"dunes.mp4", "dunes.csv", "dunes.toml", "still.png", "cut.webp"})
        EXPECT_TRUE(fs::exists(folder / "site/files" / file)) << file;
    EXPECT_FALSE(fs::exists(folder / "site/files/notes.txt"));
    for (const char* file : {"index.html", "gallery.css", "gallery.js"}) {
        const std::string text = read_text(folder / "site" / file);
        EXPECT_EQ(text.find("http://"), std::string::npos) << file;
        EXPECT_EQ(text.find("https://"), std::string::npos) << file;
    }
    EXPECT_EQ(fumon({"gallery", "out", "-o", "site", "--title", "<mine>"}, folder.path()).status, 0)
        << "its own is replaced";
    EXPECT_EQ(read_text(folder / "site/index.html"), page);
    // What is said of making it again works from the gallery's folder.
    const Ended again =
        fumon({"again", "files/still.png", "-o", "again.png"}, folder.path() / "site");
    EXPECT_EQ(again.errors, "again.png: the same pixels as files/still.png\n");
}

TEST(GalleryCommand, SaysWhatIsWrongAndWritesNothing) {
    const ScratchFolder& folder = shown_results();
    EXPECT_EQ(fumon({"gallery"}, folder.path()).errors,
              "fumon gallery: FROM is missing; try `fumon gallery --help`\n");
    EXPECT_EQ(fumon({"gallery", "nowhere"}, folder.path()).errors,
              "nowhere: there is no such file or folder\n");
    EXPECT_EQ(fumon({"gallery", "out/notes.txt"}, folder.path()).errors,
              "out/notes.txt: holds no run, picture or film that fumon made\n");
    fs::create_directory(folder / "other");
    write_text(folder / "other/index.html", "mine");
    EXPECT_EQ(fumon({"gallery", "out", "-o", "other"}, folder.path()).status, 2);
    EXPECT_FALSE(fs::exists(folder / "other/files"));
    EXPECT_FALSE(fs::exists(folder / "gallery"));
}

TEST(GalleryCommand, AnInstalledProgramHasThePicturesInItsDocumentation) {
    const ScratchFolder& folder = shown_results();
    const fs::path tree = folder / "tree";
    fs::create_directories(tree / "bin");
    fs::create_directories(tree / "share/doc/fumon/scenes/pictures");
    fs::copy_file(FUMON_PROGRAM, tree / "bin/fumon");
    fs::copy_file(folder / "out/still.png", tree / "share/doc/fumon/scenes/pictures/still.png");
    const Ended ended = fumon({"gallery", "--shipped", "-o", "shipped"}, folder.path(), {},
                              (tree / "bin/fumon").string());
    EXPECT_EQ(ended.errors, "shipped/index.html: 1 pictures and films\n");
}

}  // namespace
}  // namespace fumon::test
