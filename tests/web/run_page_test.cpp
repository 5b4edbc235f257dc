// `fumon export … -o page.html` as a user runs it: what the page holds, and what is refused.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "figure/canvas/packed_text.h"
#include "files/hash.h"
#include "support/html_page.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* harm = "</script><script>harm()</script><b a=\"'&";

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return "";
    const std::size_t start = from + begin.size();
    return text.substr(start, text.find(end, start) - start);
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

std::string hash_of(const std::string& text) {
    const Sha256 hash = text_hash(text);
    return "'sha256-" + base64_text(std::string(hash.begin(), hash.end())) + "'";
}

class RunPageTest : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        place_ = new ScratchFolder();
        const std::string title = std::string("title='''") + harm + "'''";
        const Ended ended =
            fumon({"run", "terada-ripples", "-o", "run", "-q", "--set", "grid.nx=24", "--set",
                   "grid.ny=16", "--set", "run.steps=40", "--set", "output.fields_every=10",
                   "--set", "output.frames=false", "--set", "output.movie=false", "--set", title},
                  place_->path());
        ASSERT_EQ(ended.status, 0) << ended.errors;
    }
    static void TearDownTestSuite() {
        delete place_;
        place_ = nullptr;
    }

    static Ended write(const std::string& input, const std::string& output,
                       const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"export", input, "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        return fumon(words, place_->path());
    }
    static nlohmann::json data_of(const std::string& page) {
        return nlohmann::json::parse(between(page, "id=\"data\">", "</script>"));
    }

    static ScratchFolder* place_;
};

ScratchFolder* RunPageTest::place_ = nullptr;

TEST_F(RunPageTest, HoldsTheBedsOfARun) {
    const Ended ended = write("run", "page.html");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_TRUE(contains(ended.errors, "5 beds, heights in steps of ")) << ended.errors;
    const std::string page = read_text(*place_ / "page.html");
    const nlohmann::json data = data_of(page);
    ASSERT_EQ(data["beds"].size(), 5U);
    EXPECT_EQ(data["beds"][2]["step"], 20);
    EXPECT_EQ(data["beds"][2]["label"], "20 steps");
    EXPECT_EQ(data["cells"], nlohmann::json({24, 16}));
    EXPECT_FALSE(data.contains("depths"));
    EXPECT_TRUE(contains(page, "Terada"));
    EXPECT_TRUE(contains(page, "\nnx = 24\n"));
    EXPECT_FALSE(contains(page, place_->path().string())) << "tells of folders of this machine";
    const std::vector<std::string> faults = faults_of_page(page);
    EXPECT_TRUE(faults.empty()) << faults.front();
}

TEST_F(RunPageTest, RunsNoScriptButItsOwn) {
    ASSERT_EQ(write("run", "safe.html").status, 0);
    const std::string page = read_text(*place_ / "safe.html");
    EXPECT_FALSE(contains(page, harm));
    EXPECT_EQ(count(page, "<script"), 2U);
    EXPECT_EQ(count(page, "</script"), 2U);
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_TRUE(policy.starts_with("default-src 'none'; img-src data:; style-src ")) << policy;
    EXPECT_TRUE(contains(policy, "script-src " + hash_of(between(page, "<script>", "</script>"))));
    EXPECT_TRUE(contains(policy, "style-src " + hash_of(between(page, "<style>", "</style>"))));
    EXPECT_FALSE(contains(page, "http://") || contains(page, "src=\"http"));
    EXPECT_FALSE(contains(page, " style=\"")) << "which the policy forbids";
}

TEST_F(RunPageTest, TakesTheBedsThatAreAskedFor) {
    Ended ended = write("run", "few.html", {"--beds", "3"});
    EXPECT_TRUE(contains(ended.errors, "3 of 5 stored beds, evenly (--beds allows more)\n"))
        << ended.errors;
    nlohmann::json data = data_of(read_text(*place_ / "few.html"));
    ASSERT_EQ(data["beds"].size(), 3U);
    EXPECT_EQ(data["beds"][1]["step"], 20);
    ended = write("run", "one.html", {"--step", "30", "-q"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(ended.errors, "");
    data = data_of(read_text(*place_ / "one.html"));
    ASSERT_EQ(data["beds"].size(), 1U);
    EXPECT_EQ(data["beds"][0]["step"], 30);
    ASSERT_EQ(write("run", "coarse.html", {"--triangles", "200"}).status, 0);
    data = data_of(read_text(*place_ / "coarse.html"));
    EXPECT_EQ(data["cells"], nlohmann::json({12, 8}));
}

TEST_F(RunPageTest, TakesTerrainWithHoles) {
    std::string text =
        "ncols 20\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n";
    for (int row = 0; row < 12; ++row)
        for (int x = 0; x < 20; ++x)
            text += row == 4 && x == 6 ? "-9999 " : std::to_string(100 + 0.5 * row + 0.1 * x) + " ";
    write_text(*place_ / "dem.asc", text);
    const Ended ended = write("dem.asc", "dem.html", {"--exaggeration", "2"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const std::string page = read_text(*place_ / "dem.html");
    const nlohmann::json data = data_of(page);
    EXPECT_NE(data["nodata"], "");
    EXPECT_EQ(data["length"], "m");
    EXPECT_NEAR(data["heights"]["low"].get<double>(), 100.0, 0.01);
    EXPECT_TRUE(contains(page, "heights × 2"));
    EXPECT_TRUE(contains(page, "<title>dem</title>"));
    ASSERT_EQ(write((*place_ / "dem.asc").string(), "far.html").status, 0);
    const std::string far = read_text(*place_ / "far.html");
    EXPECT_TRUE(contains(far, "dem.asc"));
    EXPECT_FALSE(contains(far, place_->path().string())) << "tells of folders of this machine";
    ASSERT_EQ(write("dem.asc", "coast.html", {"--set", "look.sea_level=101"}).status, 0);
    EXPECT_TRUE(data_of(read_text(*place_ / "coast.html")).contains("depths"));
}

TEST_F(RunPageTest, HoldsTheWaterOfARun) {
    Ended ended = fumon({"run", "dam-break", "-o", "dam", "-q", "--set", "grid.nx=64", "--set",
                         "grid.ny=16", "--set", "run.steps=4", "--set", "output.fields_every=2",
                         "--set", "output.frames=false", "--set", "output.movie=false"},
                        place_->path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    ended = write("dam/fields.nc", "dam.html");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const nlohmann::json data = data_of(read_text(*place_ / "dam.html"));
    EXPECT_EQ(data["depths"]["fields"].size(), 3U);
    EXPECT_NEAR(data["depths"]["step"].get<double>() * 65535.0, 5.0, 0.1);
    EXPECT_NE(data["water"][3], data["walls"][3]);
}

TEST_F(RunPageTest, KeepsTheRulesOfOutputs) {
    write_text(*place_ / "others.html", "<p>mine</p>");
    Ended ended = write("run", "others.html");
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.errors, "others.html: already exists and was not made by fumon"))
        << ended.errors;
    EXPECT_EQ(read_text(*place_ / "others.html"), "<p>mine</p>");
    EXPECT_EQ(write("run", "others.html", {"--force", "--beds", "1"}).status, 0);
    EXPECT_EQ(write("run", "others.html", {"--beds", "1"}).status, 0) << "its own";
    for (const auto& [more, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--field", "slope"}, "--field slope: a field is written as a grid"},
             {{"--step", "15"}, "stored no bed of step 15"},
             {{"--beds", "0"}, "--beds"},
             {{"--beds", "401"}, "--beds"},
             {{"--set", "look.palette=\"none\""}, "palette"}}) {
        ended = write("run", "refused.html", more);
        EXPECT_EQ(ended.status, 2) << said;
        EXPECT_TRUE(contains(ended.errors, said)) << ended.errors;
        EXPECT_FALSE(fs::exists(*place_ / "refused.html"));
    }
    ended = write("run", "-", {"--as", "html"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(contains(ended.errors, "a page needs a name")) << ended.errors;
    ended = write("nothing", "refused.html");
    EXPECT_EQ(ended.status, 2);
}

TEST_F(RunPageTest, IsTheSameOnAnyNumberOfThreads) {
    ASSERT_EQ(write("run", "a.html", {"--threads", "1", "--beds", "2"}).status, 0);
    ASSERT_EQ(write("run", "b.html", {"--threads", "3", "--beds", "2"}).status, 0);
    EXPECT_EQ(read_text(*place_ / "a.html"), read_text(*place_ / "b.html"));
}

}  // namespace
}  // namespace fumon::test
