// What leaves this machine tells nothing of its folders: pictures, movies, figures with their
// captions, meshes and fields of a scene and a terrain that both are named from the root.

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// The streams of a PDF file, unpacked.
std::string streams_of(std::string_view pdf) {
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflate(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    std::string all;
    constexpr std::string_view begin = "stream\n";
    for (std::size_t at = 0; (at = pdf.find(begin, at)) != std::string_view::npos;) {
        at += begin.size();
        std::string unpacked(std::size_t{1} << 24, '\0');
        std::size_t size = 0;
        std::size_t read = 0;
        if (libdeflate_zlib_decompress_ex(inflate.get(), pdf.data() + at, pdf.size() - at,
                                          unpacked.data(), unpacked.size(), &read,
                                          &size) == LIBDEFLATE_SUCCESS)
            all += unpacked.substr(0, size);
    }
    return all;
}

/// A text as PDF may write it: UTF-16 in hexadecimal digits.
std::string in_utf16(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string hexadecimal;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        hexadecimal += {'0', '0', digits[code >> 4U], digits[code & 15U]};
    }
    return hexadecimal;
}

class LocalPaths : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(folder_ / "there");
        write_text(terrain_,
                   "ncols 8\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
                   "9 8 7 6 5 4 3 2\n9 8 7 6 5 4 3 2\n9 8 7 5 5 4 3 2\n"
                   "9 8 7 5 5 4 3 2\n9 8 7 6 5 4 3 2\n9 8 7 6 5 4 3 2\n");
        const std::string common =
            "title = \"Paths\"\n[model]\nname = \"gully\"\n[bed]\nfile = \"" + terrain_.string() +
            "\"\n[run]\nsteps = 2\n";
        write_text(scene_, common +
                               "[image]\nwidth = 96\nheight = 64\nsupersampling = 1\n"
                               "[output]\nfields_every = 2\n");
        write_text(figure_, common +
                                "[figure]\ndots_per_inch = 60\n[[figure.panel]]\n"
                                "kind = \"map\"\nsteps = [2]\n[[figure.panel]]\nkind = \"map\"\n"
                                "scene = \"" +
                                scene_.string() + "\"\nsteps = [2]\n");
    }

    [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_ / "there");
    }
    [[nodiscard]] std::string out(const std::string& name) const {
        return (folder_ / "there" / name).string();
    }

    const ScratchFolder folder_{};
    const fs::path terrain_ = folder_ / "dem.asc";
    const fs::path scene_ = folder_ / "scene.toml";
    const fs::path figure_ = folder_ / "figure.toml";
};

TEST_F(LocalPaths, StandInNothingThatLeavesAndPicturesAreMadeAgainAllTheSame) {
    for (const char* ending : {"png", "jpg", "webp", "exr"}) {
        const Ended still =
            run({"still", scene_.string(), "-q", "-o", out(std::string("still.") + ending)});
        ASSERT_EQ(still.status, 0) << still.errors;
    }
    const Ended made = run({"run", scene_.string(), "-q", "-o", out("run")});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended figure = run({"figure", figure_.string(), "-q", "-o", out("figure")});
    ASSERT_EQ(figure.status, 0) << figure.errors;
    for (const char* ending : {"glb", "stl", "vts", "ply", "obj"}) {
        const Ended mesh =
            run({"export", out("run"), "-q", "-o", out(std::string("mesh.") + ending)});
        EXPECT_EQ(mesh.status, 0) << mesh.errors;
    }
    // Which go on with a run or a sweep where it lies.
    const std::set<std::string> stay{"run.json", "job.json", "sweep.json", "checkpoint.fumon"};
    const std::string name = folder_.path().filename().string();
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "there")) {
        if (!entry.is_regular_file() || stay.contains(entry.path().filename().string())) continue;
        const std::string bytes = read_text(entry.path());
        EXPECT_EQ(bytes.find(name), std::string::npos) << entry.path();
        EXPECT_EQ(bytes.find(in_utf16(name)), std::string::npos) << entry.path();
        if (entry.path().extension() == ".pdf") {
            EXPECT_EQ(streams_of(bytes).find(name), std::string::npos) << entry.path();
        }
        ++files;
    }
    EXPECT_GT(files, 15);
    for (const char* picture :
         {"still.png", "still.jpg", "figure/figure.pdf", "figure/figure.svg"}) {
        const Ended again = run({"again", picture});
        EXPECT_NE(again.errors.find("-again"), std::string::npos) << again.errors;
        EXPECT_NE(again.errors.find(": the same "), std::string::npos) << again.errors;
    }
}

TEST_F(LocalPaths, ATerrainThatLiesElsewhereIsGivenByAnOption) {
    ASSERT_EQ(run({"still", scene_.string(), "-q", "-o", "still.png"}).status, 0);
    fs::create_directories(folder_ / "other");
    fs::rename(terrain_, folder_ / "other" / "moved.asc");
    const Ended lost = run({"again", "still.png"});
    EXPECT_EQ(lost.status, 2);
    EXPECT_NE(lost.errors.find("dem.asc as it was when the picture was made"), std::string::npos)
        << lost.errors;
    const Ended given = run({"again", "still.png", "--set", "bed.file=../other/moved.asc"});
    EXPECT_EQ(given.status, 0) << given.errors;
}

}  // namespace
}  // namespace fumon::test
