// Films whose layers name files, made again.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_layouts.h"
#include "picture/exr.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* film_with_layer =
    "[film]\nwidth = 96\nheight = 64\nrate = 5\nsupersampling = 1\n"
    "[[shot]]\nseconds = 0.4\nfrom = \"end\"\n"
    "[[layer]]\nfile = \"line.geojson\"\ncolour = \"#ff0000\"\n";

std::string line(const std::string& from, const std::string& to) {
    return R"({"type":"LineString","coordinates":[)" + from + "," + to + "]}";
}

/// Films of a NetCDF file, and lines of one name in the folders "one" and "two".
class FilmLayers : public ::testing::Test {
  protected:
    void SetUp() override {
        write_sfincs(folder_ / "flood.nc");
        fs::create_directory(folder_ / "one");
        fs::create_directory(folder_ / "two");
        write_text(folder_ / "one" / "line.geojson", line("[500,900]", "[530,920]"));
        write_text(folder_ / "two" / "line.geojson", line("[500,920]", "[530,900]"));
        for (const char* name : {"one", "two"})
            write_text(folder_ / name / "film.toml", film_with_layer);
    }
    Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }
    /// What `fumon again` says of a picture, which is then "again.png".
    Ended again(const std::string& of, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"again", of, "-o", "again.png", "--force"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    void expect_same(const std::string& of) const {
        const Ended made = again(of);
        EXPECT_EQ(made.status, 0) << made.errors;
        EXPECT_EQ(read_text(folder_ / "again.png"), read_text(folder_ / of)) << made.errors;
    }
    ScratchFolder folder_;
};

TEST_F(FilmLayers, AreToldApartInTwoFolders) {
    write_text(folder_ / "both.toml",
               "[film]\nwidth = 96\nheight = 64\nrate = 5\nsupersampling = 1\n"
               "poster_second = 0.6\n"
               "[[excerpt]]\nfilm = \"one/film.toml\"\n[[excerpt]]\nfilm = \"two/film.toml\"\n");
    const Ended joined = run({"film", "flood.nc", "both.toml", "-o", "joined.png"});
    ASSERT_EQ(joined.status, 0) << joined.errors;
    expect_same("joined.png");
    // One more from the working folder, by the name that the film's own has, too.
    write_text(folder_ / "line.geojson", line("[515,900]", "[515,920]"));
    const Ended more = run({"film", "flood.nc", "one/film.toml", "-o", "more.png", "--set",
                            "layer.1.file=line.geojson"});
    ASSERT_EQ(more.status, 0) << more.errors;
    expect_same("more.png");
}

TEST_F(FilmLayers, AreThoseThatTheCommandLineNames) {
    ASSERT_EQ(run({"film", "flood.nc", "one/film.toml", "-o", "one.png"}).status, 0);
    ASSERT_EQ(run({"film", "flood.nc", "two/film.toml", "-o", "two.png"}).status, 0);
    fs::remove(folder_ / "one" / "line.geojson");
    EXPECT_EQ(again("one.png").status, 2) << "its file is gone";
    const Ended other = again("one.png", {"--set", "layer.0.file=two/line.geojson"});
    ASSERT_EQ(other.status, 0) << other.errors;
    write_text(folder_ / "one" / "line.geojson", line("[500,900]", "[530,920]"));
    const Ended missing = again("one.png", {"--set", "layer.0.file=line.geojson"});
    EXPECT_EQ(missing.status, 2) << "as seen from the working folder";
    EXPECT_TRUE(missing.errors.starts_with("--set 1:14: layer.0.file ")) << missing.errors;
    expect_same("one.png");
}

TEST_F(FilmLayers, AreRecordedInSequencesOfLight) {
    const Ended made = run({"film", "flood.nc", "one/film.toml", "-o", "light_%d.exr"});
    ASSERT_EQ(made.status, 0) << made.errors;
    std::string layers;
    for (const auto& [keyword, text] : read_exr_texts(folder_ / "light_1.exr"))
        if (keyword == "fumon:layers") layers = text;
    EXPECT_TRUE(contains(layers, "\"path\":\"line.geojson\"")) << layers;
    EXPECT_TRUE(contains(layers, "\"from\":\"one/line.geojson\"")) << layers;
    const Ended same = run({"again", "light_1.exr"});
    EXPECT_EQ(same.errors, "light_1-again.exr: the same bytes as light_1.exr\n");
    EXPECT_EQ(read_text(folder_ / "light_1-again.exr"), read_text(folder_ / "light_1.exr"));
    fs::remove(folder_ / "one" / "line.geojson");
    const Ended missing = run({"again", "light_1.exr", "--force"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_TRUE(missing.errors.starts_with("light_1.exr: line.geojson as it was when the film"))
        << missing.errors;
}

}  // namespace
}  // namespace fumon::test
