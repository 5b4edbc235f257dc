// Layers and drapes of pictures that may come from anyone.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "files/atomic_file.h"
#include "files/hash.h"
#include "picture/png.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* small_hill =
    "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n1 2 4\n1 2 3\n";
constexpr const char* line = R"({"type":"LineString","coordinates":[[5,5],[20,25]]})";

class TrustOfLayers : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directory(folder_ / "in");
        write_text(folder_ / "in/hill.asc", small_hill);
        write_text(folder_ / "in/line.geojson", line);
        write_file(folder_ / "in/map.png", encode_png(Image(8, 8), 96, {}));
        write_text(folder_ / "in/scene.toml",
                   "[model]\nname = \"static\"\n[bed]\nfile = \"hill.asc\"\n[look]\ndrape = "
                   "\"map.png\"\n[image]\nwidth = 64\nheight = 48\n[[layer]]\nfile = "
                   "\"line.geojson\"\n");
    }
    Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }
    /// What `fumon again` says of a forged picture whose scene names a file of a key besides its
    /// bed; `hash`: as the picture lists it.
    std::string of_forged(const std::string& key, const std::string& file, const std::string& hash,
                          const std::vector<std::string>& more = {}) const {
        const std::string bed = hex(file_hash(folder_ / "in/hill.asc"));
        std::string inputs = R"([{"path": "in/hill.asc", "sha256": ")" + bed + R"("})";
        if (!hash.empty()) inputs += R"(, {"path": ")" + file + R"(", "sha256": ")" + hash + "\"}";
        const std::string scene = "[model]\nname = \"static\"\n[bed]\nfile = \"in/hill.asc\"\n" +
                                  key + " = \"" + file + "\"\n";
        write_file(folder_ / "forged.png", encode_png(Image(16, 16), 96,
                                                      {{"fumon:scene", scene},
                                                       {"fumon:step", "0"},
                                                       {"fumon:inputs", inputs + "]"}}));
        std::vector<std::string> all{"again", "forged.png", "-o", "made.png", "-q"};
        all.insert(all.end(), more.begin(), more.end());
        const Ended ended = run(all);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "made.png"));
        return ended.errors;
    }
    ScratchFolder folder_;
};

constexpr const char* drape_key = "[look]\ndrape";
constexpr const char* layer_key = "[[layer]]\nfile";

TEST_F(TrustOfLayers, FilesAreTakenByTheirHashes) {
    ASSERT_EQ(run({"still", "in/scene.toml", "-o", "a.png", "-q"}).status, 0);
    fs::create_directory(folder_ / "moved");
    fs::rename(folder_ / "in", folder_ / "moved/in");
    fs::rename(folder_ / "a.png", folder_ / "moved/a.png");
    const auto again = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"again", "moved/a.png", "-o", "b.png", "--force"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    EXPECT_TRUE(contains(again({}).errors, "b.png: the same pixels as moved/a.png"));
    for (const auto& [file, key, other] :
         {std::tuple{"moved/in/line.geojson", "layer.0.file",
                     R"({"type":"LineString","coordinates":[[5,5],[25,25]]})"},
          std::tuple{"moved/in/map.png", "look.drape", "no picture"}}) {
        fs::rename(folder_ / file, folder_ / "kept");
        const std::string missing = again({}).errors;
        EXPECT_TRUE(contains(missing, std::string("give it with --set ") + key + "=FILE"))
            << missing;
        write_text(folder_ / file, other);
        EXPECT_EQ(again({}).errors, missing) << "one that has changed is missing";
        EXPECT_EQ(again({"--trust"}).status, 2) << "trust is not in other files";
        EXPECT_EQ(again({"--set", std::string(key) + "=kept"}).status, 0);
        fs::remove(folder_ / file);
        fs::rename(folder_ / "kept", folder_ / file);
    }
}

TEST_F(TrustOfLayers, NoOtherFileIsReadOrToldOf) {
    write_text(folder_ / "secret", "the first line\n");
    for (const char* key : {drape_key, layer_key}) {
        const auto message = [&](const std::string& file, const std::string& hash) {
            std::string text = of_forged(key, file, hash);
            const std::size_t at = text.find(file);
            return at == std::string::npos ? text : text.replace(at, file.size(), "FILE");
        };
        EXPECT_TRUE(contains(message("secret", ""), "which its metadata does not list"));
        EXPECT_EQ(message("secret", "0123456789abcdef"), message("none", "0123456789abcdef"));
        EXPECT_EQ(message("secret", "0123456789abcdef"),
                  message("/etc/passwd", "0123456789abcdef"));
        const std::string listed = of_forged(key, "secret", hex(file_hash(folder_ / "secret")));
        EXPECT_TRUE(contains(listed, "secret is not a readable ")) << listed;
        EXPECT_FALSE(contains(listed, "first line")) << listed;
    }
    write_text(folder_ / "layer.vrt", "<OGRVRTDataSource></OGRVRTDataSource>");
    const std::string vrt =
        of_forged(layer_key, "layer.vrt", hex(file_hash(folder_ / "layer.vrt")));
    EXPECT_TRUE(contains(vrt, "layer.vrt is read only with --trust, since a VRT names other files"))
        << vrt;
}

}  // namespace
}  // namespace fumon::test
