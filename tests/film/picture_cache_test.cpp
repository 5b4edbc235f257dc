#include "film/cache/picture_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/hash.h"
#include "support/program.h"

namespace fumon {
namespace {

namespace fs = std::filesystem;

using test::contains;
using test::Ended;
using test::fumon;
using test::ScratchFolder;
using test::write_text;

/// A picture that compression leaves as large as it is.
CachedPicture rough_picture(std::uint64_t seed, bool transparent = false) {
    CachedPicture picture{Image(40, 30), {-1.5, 2.5, true, false, false}};
    if (transparent) picture.image = with_alpha(std::move(picture.image));
    for (auto* values : {&picture.image.rgb, &picture.image.alpha}) {
        for (std::uint8_t& value : *values) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            value = static_cast<std::uint8_t>(seed >> 56U);
        }
    }
    return picture;
}

Sha256 key_of_name(const std::string& name) {
    return text_hash(name);
}

void keep(const fs::path& folder, const std::vector<std::string>& names, std::int64_t most_bytes) {
    PictureCache cache(folder, most_bytes);
    for (const std::string& name : names) cache.add(key_of_name(name), rough_picture(name.size()));
}

TEST(PictureCache, GivesBackWhatItWasGiven) {
    const ScratchFolder folder;
    const CachedPicture opaque = rough_picture(1);
    const CachedPicture open = rough_picture(2, true);
    {
        PictureCache cache(folder / "kept", 1'000'000);
        EXPECT_FALSE(cache.find(key_of_name("opaque")));
        cache.add(key_of_name("opaque"), opaque);
        cache.add(key_of_name("open"), open);
    }
    PictureCache cache(folder / "kept", 1'000'000);
    const auto found = cache.find(key_of_name("opaque"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->image, opaque.image);
    EXPECT_EQ(found->colours.low, -1.5);
    EXPECT_EQ(found->colours.high, 2.5);
    EXPECT_TRUE(found->colours.values_below);
    EXPECT_FALSE(found->colours.values_above);
    const auto found_open = cache.find(key_of_name("open"));
    ASSERT_TRUE(found_open);
    EXPECT_EQ(found_open->image, open.image);
    EXPECT_FALSE(cache.find(key_of_name("another")));
    EXPECT_EQ(cache.finish().found, 2);
}

TEST(PictureCache, TakesNoFileThatIsDamagedOrOfAnotherKey) {
    const ScratchFolder folder;
    keep(folder.path(), {"a"}, 1'000'000);
    const auto file_of = [&](const std::string& name) {
        return folder.path() / (hex(key_of_name(name)) + ".picture");
    };
    const std::string whole = test::read_text(file_of("a"));
    fs::copy_file(file_of("a"), file_of("b"));
    PictureCache cache(folder.path(), 1'000'000);
    EXPECT_FALSE(cache.find(key_of_name("b")));
    for (const std::size_t place : {std::size_t{3}, std::size_t{20}, whole.size() - 1}) {
        std::string damaged = whole;
        damaged[place] = static_cast<char>(damaged[place] ^ 1);
        write_text(file_of("a"), damaged);
        EXPECT_FALSE(cache.find(key_of_name("a"))) << place;
    }
    write_text(file_of("a"), whole.substr(0, whole.size() / 2));
    EXPECT_FALSE(cache.find(key_of_name("a")));
    write_text(file_of("a"), "");
    EXPECT_FALSE(cache.find(key_of_name("a")));
    write_text(file_of("a"), whole);
    EXPECT_TRUE(cache.find(key_of_name("a")));
}

TEST(PictureCache, LetsGoOfWhatWasUsedLeastRecently) {
    const ScratchFolder folder;
    constexpr std::int64_t room_for_three = 13'000;  // of 3600 bytes and a header each
    keep(folder.path(), {"a", "bb", "ccc"}, room_for_three);
    const auto now = fs::file_time_type::clock::now();
    int hours = 3;
    for (const char* name : {"a", "bb", "ccc"})
        fs::last_write_time(folder.path() / (hex(key_of_name(name)) + ".picture"),
                            now - std::chrono::hours(hours--));
    {
        PictureCache cache(folder.path(), room_for_three);
        EXPECT_TRUE(cache.find(key_of_name("a"))) << "it counts as used now";
        cache.add(key_of_name("dddd"), rough_picture(4));
    }
    const PictureCache cache(folder.path(), room_for_three);
    EXPECT_TRUE(cache.holds(key_of_name("a")));
    EXPECT_FALSE(cache.holds(key_of_name("bb")));
    EXPECT_TRUE(cache.holds(key_of_name("ccc")));
    EXPECT_TRUE(cache.holds(key_of_name("dddd")));
}

TEST(PictureCache, KeepsTheBeginningOfAFilmThatIsLargerThanIt) {
    const ScratchFolder folder;
    constexpr std::int64_t room_for_three = 13'000;
    PictureCache cache(folder.path(), room_for_three);
    for (const char* name : {"a", "bb", "ccc", "dddd", "eeeee"})
        cache.add(key_of_name(name), rough_picture(5));
    EXPECT_TRUE(cache.finish().full);
    for (const char* name : {"a", "bb", "ccc"}) EXPECT_TRUE(cache.holds(key_of_name(name)));
    EXPECT_FALSE(cache.holds(key_of_name("eeeee")));
}

constexpr const char* two_shots =
    "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\n"
    "[[shot]]\nseconds = 1\nmove = \"orbit\"\nturn = 60\n"
    "[[shot]]\nseconds = 1\nfrom = 4\nto = 8\nazimuth = 100\n"
    "[[overlay]]\nkind = \"time\"\n";

/// Films of a run, with a cache of the test's own.
class CachedFilms : public testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", test::small_scene());
        write_text(folder_ / "film.toml", two_shots);
        simulate("out", "5");
    }

    void simulate(const std::string& name, const std::string& seed) {
        const Ended run =
            fumon({"run", "scene.toml", "-o", name, "--quiet", "--set", "seed=" + seed, "--set",
                   "output.frames=false", "--set", "output.movie=false", "--set",
                   "output.fields_every=2", "--set", "look.ground=table"},
                  folder_.path());
        ASSERT_EQ(run.status, 0) << run.errors;
    }

    /// How many pictures were kept, by what a film says of it.
    std::string film(std::vector<std::string> more,
                     const std::vector<std::string>& environment = {}) {
        more.insert(more.begin(), {"film", "out", "film.toml", "--force"});
        std::vector<std::string> all{"FUMON_CACHE_SIZE=10MB",
                                     "XDG_CACHE_HOME=" + (folder_ / "cache").string()};
        all.insert(all.end(), environment.begin(), environment.end());
        const Ended made = fumon(more, folder_.path(), all);
        EXPECT_EQ(made.status, 0) << made.errors;
        const std::size_t end = made.errors.find(" pictures were drawn before");
        if (end == std::string::npos) return "0";
        const std::size_t begin = made.errors.rfind('\n', end) + 1;
        return made.errors.substr(begin, end - begin);
    }

    [[nodiscard]] std::string bytes(const std::string& name) const {
        return test::read_text(folder_ / name);
    }

    ScratchFolder folder_;
};

TEST_F(CachedFilms, HaveTheSameBytesAndTakeOverWhatDidNotChange) {
    EXPECT_EQ(film({"-o", "drawn.mp4", "--no-cache"}), "0");
    EXPECT_FALSE(fs::exists(folder_ / "cache/fumon"));
    EXPECT_EQ(film({"-o", "first.mp4"}), "0");
    EXPECT_EQ(film({"-o", "again.mp4"}), "8 of 8");
    EXPECT_EQ(bytes("drawn.mp4"), bytes("first.mp4"));
    EXPECT_EQ(bytes("drawn.mp4"), bytes("again.mp4"));

    const std::vector<std::string> moved{"--set", "overlay.0.corner=lower-right",
                                         "--set", "film.quality=30",
                                         "--set", "film.title=another"};
    auto with = [&](std::vector<std::string> first) {
        first.insert(first.end(), moved.begin(), moved.end());
        return first;
    };
    EXPECT_EQ(film(with({"-o", "moved.mp4"})), "8 of 8");
    EXPECT_EQ(film(with({"-o", "moved-drawn.mp4", "--no-cache"})), "0");
    EXPECT_EQ(bytes("moved.mp4"), bytes("moved-drawn.mp4"));

    EXPECT_EQ(film({"-o", "shot.mp4", "--set", "shot.1.azimuth=110"}), "5 of 8");
    EXPECT_EQ(film({"-o", "sun.mp4", "--set", "sun.elevation=9"}), "0");
    EXPECT_EQ(film({"-o", "size.mp4", "--set", "film.width=80"}), "0");
    simulate("out2", "6");
    fs::remove_all(folder_ / "out");
    fs::rename(folder_ / "out2", folder_ / "out");
    EXPECT_EQ(film({"-o", "seed.mp4"}), "0");
}

TEST_F(CachedFilms, DrawWhatIsDamagedAndGoOnWithoutRoom) {
    EXPECT_EQ(film({"-o", "first.mp4"}), "0");
    const auto pictures = folder_ / "cache/fumon/pictures";
    for (const auto& entry : fs::directory_iterator(pictures)) {
        if (entry.path().extension() != ".picture") continue;
        write_text(entry.path(), "broken");
        break;
    }
    EXPECT_EQ(film({"-o", "mended.mp4"}), "7 of 8");
    EXPECT_EQ(bytes("first.mp4"), bytes("mended.mp4"));
    EXPECT_EQ(film({"-o", "whole.mp4"}), "8 of 8");
    write_text(folder_ / "file", "no folder");
    const std::string nowhere = "XDG_CACHE_HOME=" + (folder_ / "file").string();
    EXPECT_EQ(film({"-o", "nowhere.mp4"}, {nowhere}), "0");
    EXPECT_EQ(bytes("first.mp4"), bytes("nowhere.mp4"));
    EXPECT_EQ(film({"-o", "none.mp4"}, {"FUMON_CACHE_SIZE=0"}), "0");
}

TEST_F(CachedFilms, AreForgottenWhenAsked) {
    EXPECT_EQ(film({"-o", "first.mp4"}), "0");
    const std::vector<std::string> here{"XDG_CACHE_HOME=" + (folder_ / "cache").string()};
    const Ended cleared = fumon({"film", "--clear-cache"}, folder_.path(), here);
    EXPECT_EQ(cleared.status, 0);
    EXPECT_TRUE(contains(cleared.errors, "bytes of pictures deleted")) << cleared.errors;
    EXPECT_EQ(fumon({"film", "--clear-cache"}, folder_.path(), here).errors,
              "no pictures are kept\n");
    EXPECT_EQ(film({"-o", "again.mp4"}), "0");
    EXPECT_EQ(fumon({"film", "out", "--clear-cache"}, folder_.path(), here).status, 2);
    EXPECT_EQ(fumon({"film", "out", "film.toml", "-o", "x.mp4"}, folder_.path(),
                    {"FUMON_CACHE_SIZE=much"})
                  .status,
              2);
}

}  // namespace
}  // namespace fumon
