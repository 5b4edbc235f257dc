// `fumon gallery --pages`.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/html_page.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

Ended run_small(const ScratchFolder& place, const std::string& name, const std::string& every) {
    return fumon(
        {"run", "terada-ripples", "-o", name, "-q", "--set", "grid.nx=24", "--set", "grid.ny=16",
         "--set", "run.steps=20", "--set", "output.fields_every=" + every, "--set",
         "output.movie=false", "--set", "image.width=320", "--set", "image.height=180"},
        place.path());
}

TEST(GalleryPages, TurnRunsThatStoredBeds) {
    const ScratchFolder place;
    ASSERT_EQ(run_small(place, "out/kept", "10").status, 0);
    ASSERT_EQ(run_small(place, "out/bare", "0").status, 0);
    Ended ended = fumon({"gallery", "out", "--pages", "-o", "gallery"}, place.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_TRUE(contains(ended.errors, "bare: no page to turn: ")) << ended.errors;
    const std::string page = read_text(place / "gallery/index.html");
    EXPECT_TRUE(contains(page, "<iframe src=\"files/kept.html\" loading=\"lazy\" title=\""));
    EXPECT_TRUE(contains(page, "<a href=\"files/kept.html\">"));
    EXPECT_FALSE(contains(page, "files/bare.html"));
    EXPECT_TRUE(contains(read_text(place / "gallery/files/kept.html"), "id=\"data\">"));
    EXPECT_TRUE(faults_of_page(page).empty()) << faults_of_page(page).front();
    ended = fumon({"gallery", "out", "--pages", "-o", "gallery", "-q"}, place.path());
    EXPECT_EQ(ended.status, 0) << "its own: " << ended.errors;
    EXPECT_EQ(ended.errors, "");
    ASSERT_EQ(fumon({"gallery", "out", "-o", "plain"}, place.path()).status, 0);
    EXPECT_FALSE(fs::exists(place / "plain/files/kept.html"));
}

}  // namespace
}  // namespace fumon::test
