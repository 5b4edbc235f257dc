#include <gtest/gtest.h>

#include <array>

#include "support/html_page.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr double least_contrast_of_text = 4.5;  // WCAG 2.2, 1.4.3

using Pairs = std::vector<std::array<const char*, 2>>;

void expect_contrasts(const std::string& style, const Pairs& pairs) {
    for (const bool rule : {false, true}) {
        for (const auto& [letters, ground] : pairs) {
            const std::string one = colour_of(style, letters, rule);
            const std::string other = colour_of(style, ground, rule);
            ASSERT_EQ(one.size(), 7U) << letters;
            ASSERT_EQ(other.size(), 7U) << ground;
            EXPECT_GE(contrast(one, other), least_contrast_of_text)
                << letters << " on " << ground << (rule ? ", other scheme" : "");
        }
    }
}

TEST(Pages, ContrastIsThatOfWcag) {
    EXPECT_NEAR(contrast("#ffffff", "#000000"), 21.0, 1e-12);
    EXPECT_NEAR(contrast("#767676", "#ffffff"), 4.54, 0.005);  // the lightest grey that passes
}

TEST(Pages, FaultsAreSeen) {
    const std::string head =
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>t</title><meta "
        "name=\"viewport\" content=\"width=device-width\"><meta name=\"color-scheme\" "
        "content=\"dark light\"></head><body>";
    const auto count = [&](const std::string& body) {
        return faults_of_page(head + body + "</body></html>").size();
    };
    EXPECT_EQ(count("<main><h1>t</h1><img src=\"a\" alt=\"b\"></main>"), 0U);
    EXPECT_EQ(count("<main><h1>t</h1><img src=\"a\" alt=\"\"></main>"), 1U);
    EXPECT_EQ(count("<main><h1>t</h1><h3>u</h3></main>"), 1U);
    EXPECT_EQ(count("<main><p id=\"a\"></p><p id=\"a\"></p></main>"), 1U);
    EXPECT_EQ(count("<main><a href=\"#a\">b</a></main>"), 1U);
    EXPECT_EQ(count("<h1>t</h1>"), 2U);
    EXPECT_GE(count("<main><b><i></b></i></main>"), 1U);
}

TEST(Pages, VerifyWritesOneWithoutFaults) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    write_text(folder / "b.toml",
               "scene = \"scene.toml\"\nstep = 10\n[cases]\nkept = {picture = true}\nthumbnail = "
               "{settings = [\"camera.projection=map\"]}\n");
    ASSERT_EQ(fumon({"verify", "b.toml", "--update", "--pinned", "-q"}, folder.path()).status, 0);
    write_text(
        folder / "b.toml",
        "scene = \"scene.toml\"\nstep = 10\nsettings = [\"sun.azimuth=320\"]\n[cases]\nkept = "
        "{picture = true}\nthumbnail = {settings = [\"camera.projection=map\"]}\nnew = "
        "{}\nbroken = {step = 999}\n");
    ASSERT_EQ(fumon({"verify", "b.toml", "-o", "out", "-q"}, folder.path()).status, 2);
    const std::string page = read_text(folder / "out/index.html");
    EXPECT_EQ(faults_of_page(page), std::vector<std::string>{});
    EXPECT_NE(page.find("alt=\"b kept: expected\""), std::string::npos);
    EXPECT_NE(page.find("alt=\"b thumbnail: got (thumbnail)\""), std::string::npos);
    EXPECT_NE(page.find("<h2>b broken</h2>"), std::string::npos);
    expect_contrasts(page, {{"letters", "ground"}, {"mark", "ground"}});
}

TEST(Pages, AGallerysPageHasNoFaultsAndAFigureIsOneItem) {
    const ScratchFolder folder;
    write_text(folder / "cards.toml",
               small_scene() +
                   "[output]\nframes = false\n[figure]\ndots_per_inch = 60\n[[figure.panel]]\n"
                   "kind = \"map\"\n");
    ASSERT_EQ(fumon({"figure", "cards.toml", "-o", "out/figures", "-q"}, folder.path()).status, 0);
    ASSERT_EQ(fumon({"run", "cards.toml", "-o", "out/run", "-q"}, folder.path()).status, 0);
    ASSERT_EQ(
        fumon({"still", "cards.toml", "--step", "10", "-o", "out/still.png"}, folder.path()).status,
        0);
    const Ended ended = fumon({"gallery", "out", "-o", "site"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(ended.errors, "site/index.html: 3 pictures and films\n");
    const std::string page = read_text(folder / "site/index.html");
    EXPECT_EQ(faults_of_page(page), std::vector<std::string>{});
    for (const char* file : {"png", "svg", "pdf", "caption.txt"})
        EXPECT_TRUE(fs::exists(folder / "site/files" / (std::string("cards-2.") + file))) << file;
    EXPECT_NE(
        page.find("data-kind=\"figure\"><img src=\"files/cards-2.png\" alt=\"Figure of one panel, "
                  "made from "),
        std::string::npos);
    EXPECT_NE(page.find(" by fumon " FUMON_VERSION ".</p>"), std::string::npos) << "its caption";
    EXPECT_NE(page.find("alt=\"3-D view of "), std::string::npos);
    EXPECT_NE(page.find(" at step 10, seen from the south-west: "), std::string::npos);
    EXPECT_NE(page.find("alt=\"Plot of the "), std::string::npos);
    expect_contrasts(read_text(folder / "site/gallery.css"), {{"letters", "ground"},
                                                              {"letters", "plate"},
                                                              {"quiet", "ground"},
                                                              {"quiet", "plate"},
                                                              {"mark", "ground"}});
}

}  // namespace
}  // namespace fumon::test
