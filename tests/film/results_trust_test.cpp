// Pictures and films of other models' results may come from anyone.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/atomic_file.h"
#include "files/hash.h"
#include "picture/png.h"
#include "support/foreign_film.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* head_of_grid = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n";

class ResultsTrust : public ForeignFilm {
  protected:
    /// A still of someone's making, with fields of its run ("depth=h.asc").
    void forge(const std::string& name, const std::vector<std::string>& listed,
               const std::vector<std::string>& fields) {
        nlohmann::json files = nlohmann::json::array();
        for (const std::string& file : listed)
            files.push_back({{"path", file}, {"sha256", hex(file_hash(folder_ / file))}});
        const nlohmann::json query{{"fields", fields},
                                   {"time_pattern", ""},
                                   {"time_unit", ""},
                                   {"cell_size", 0.0},
                                   {"scalars", nlohmann::json::array()}};
        const PictureText texts{
            {"fumon:scene", "[model]\nname = \"static\"\n[bed]\nfile = \"" + name + "\"\n"},
            {"fumon:step", "0"},
            {"fumon:inputs", files.dump()},
            {"fumon:results",
             nlohmann::json{{"name", name}, {"files", files}, {"query", query}}.dump()}};
        write_file(folder_ / "forged.png", encode_png(Image(16, 16), 96, texts));
    }

    std::string refusal(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "again");
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        return ended.errors;
    }

    static std::vector<std::string> still_of(const std::string& what,
                                             const std::vector<std::string>& more) {
        std::vector<std::string> all{
            "still", what,    "--step",          "0",     "-o",
            "a.png", "--set", "image.width=160", "--set", "image.height=120"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

/// A file that is not listed is refused by its hash alone: whether it is a grid is not seen.
TEST_F(ResultsTrust, NoFileIsReadThatIsNotListed) {
    write_text(folder_ / "elev_1.asc", std::string(head_of_grid) + "0 1 2\n1 2 3\n");
    write_text(folder_ / "grid.asc", std::string(head_of_grid) + "0 1 0\n1 2 0\n");
    write_text(folder_ / "words.asc", "the first line\n");
    const auto message = [&](const std::string& file) {
        forge("elev_*.asc", {"elev_1.asc"}, {"depth=" + file});
        std::string text = refusal({"forged.png"});
        if (const std::size_t at = text.find(file); at != std::string::npos)
            text.replace(at, file.size(), "FILE");
        return text;
    };
    const std::string words = message("words.asc");
    EXPECT_EQ(words,
              "FILE: is none of the files that the picture was made of; --from elev_*.asc takes "
              "those that are there\n");
    EXPECT_EQ(message("grid.asc"), words);
    EXPECT_EQ(message("/etc/passwd"), words);
    EXPECT_EQ(message("/proc/self/mem"), words);
    // The file itself, changed.
    forge("elev_*.asc", {"elev_1.asc"}, {});
    write_text(folder_ / "elev_1.asc", "the first line\n");
    EXPECT_EQ(refusal({"forged.png"}),
              "elev_1.asc: is not the file that the picture was made of: its content has changed; "
              "--from elev_*.asc takes it\n");
}

TEST_F(ResultsTrust, NothingOfAListedFileIsPrinted) {
    write_text(folder_ / "elev_1.asc", "the first line\n");
    forge("elev_*.asc", {"elev_1.asc"}, {});
    EXPECT_EQ(refusal({"forged.png"}),
              "elev_*.asc: is the file that the picture was made of, but cannot be read as the "
              "picture says; --trust gives details\n");
    EXPECT_TRUE(refusal({"forged.png", "--trust"}).starts_with("elev_1.asc:1: "));
}

TEST_F(ResultsTrust, AGivenFileBringsNoOthersThatThePictureNames) {
    for (const char* folder : {"s", "t", "u"}) fs::create_directory(folder_ / folder);
    for (const char* number : {"1", "2"}) {
        const std::string grid = std::string(head_of_grid) + "0 1 2\n1 2 " + number + "\n";
        write_text(folder_ / (std::string("s/elev_") + number + ".asc"), grid);
        write_text(folder_ / (std::string("u/elev_") + number + ".asc"), grid);
        write_text(folder_ / (std::string("t/depth_") + number + ".asc"), grid);
    }
    ASSERT_EQ(run(still_of("s/elev_*.asc", {"--field", "depth=t/depth_*.asc"})).status, 0);
    const std::vector<std::string> given{"again",   "a.png",  "-o",          "b.png",
                                         "--force", "--from", "u/elev_*.asc"};
    EXPECT_EQ(run(given).status, 0) << "the depths are those of then";
    write_text(folder_ / "t/depth_2.asc", std::string(head_of_grid) + "0 1 2\n1 5 2\n");
    const Ended other = run(given);
    EXPECT_EQ(other.status, 2);
    EXPECT_EQ(other.errors,
              "a.png: takes a field from t/depth_2.asc, which is not one of the files that it "
              "lists; copy a file of this name beside u/elev_*.asc, or trust the picture: "
              "--trust\n");
    std::vector<std::string> trusted = given;
    trusted.emplace_back("--trust");
    EXPECT_EQ(run(trusted).status, 0);
    for (const char* number : {"1", "2"})
        fs::rename(folder_ / (std::string("t/depth_") + number + ".asc"),
                   folder_ / (std::string("u/depth_") + number + ".asc"));
    EXPECT_EQ(run(given).status, 0) << "beside the file that is given";
}

TEST_F(ResultsTrust, WhatNamesOtherFilesIsReadByItsUsersWord) {
    write_text(folder_ / "grid.asc", std::string(head_of_grid) + "0 1 2\n1 2 3\n");
    for (const char* number : {"1", "2"})
        write_text(folder_ / (std::string("elev_") + number + ".vrt"),
                   "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\"><GeoTransform>0,5,0,10,0,-5"
                   "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource>"
                   "<SourceFilename relativeToVRT=\"1\">grid.asc</SourceFilename><SourceBand>1"
                   "</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
    const Ended made = run(still_of("elev_*.vrt", {}));
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_EQ(refusal({"a.png", "-o", "b.png"}),
              "elev_1.vrt: is read only with --trust, since a VRT names other files: fumon again "
              "--trust a.png\n");
    EXPECT_FALSE(fs::exists(folder_ / "b.png"));
    EXPECT_EQ(run({"again", "a.png", "-o", "b.png", "--trust"}).errors,
              "b.png: the same pixels as a.png\n");
}

TEST_F(ResultsTrust, LayersOfFilmsKeepTheLimits) {
    write_text(folder_ / "line.kml",
               "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Placemark><LineString><coordinates>"
               "2,2 12,8</coordinates></LineString></Placemark></kml>");
    write_text(folder_ / "film.toml",
               "[film]\nwidth = 96\nheight = 64\nrate = 5\nsupersampling = 1\n[[shot]]\nseconds = "
               "0.4\nfrom = \"end\"\n[[layer]]\nfile = \"line.kml\"\n");
    for (const char* name : {"elev_1.asc", "elev_2.asc"})
        write_text(folder_ / name, std::string(head_of_grid) + "0 1 2\n1 2 3\n");
    const Ended made = run({"film", "elev_*.asc", "film.toml", "-o", "a.png"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const std::string refused = refusal({"a.png", "-o", "b.png"});
    EXPECT_TRUE(contains(refused, "line.kml is not a readable layer; --trust gives details"))
        << refused;
    EXPECT_EQ(run({"again", "a.png", "-o", "b.png", "--trust"}).errors,
              "b.png: the same bytes as a.png\n");
}

}  // namespace
}  // namespace fumon::test
