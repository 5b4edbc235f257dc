#include "verify/annotations.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "support/program.h"

namespace fumon::test {
namespace {

const std::vector<Annotation> some_cases{
    {"sub/p.toml:4:1", "fine", {Outcome::as_recorded, "strict: state and pixels as recorded"}},
    {"sub/p.toml:5:1", "map", {Outcome::differs, "3 % of its pixels differ, by 9\nat most"}},
    {"a:b,c.toml:6:7", "odd", {Outcome::missing, "nothing is | recorded <b> `x`"}},
    {"sub/p.toml:8:1", "bad", {Outcome::wrong_input, "wrong"}}};

TEST(Annotations, OfGitHubAreEscapedAsItsDocumentationSays) {
    EXPECT_EQ(
        github_annotations(some_cases, ""),
        "::error file=sub/p.toml,line=5,col=1,title=map%3A differs::3 %25 of its pixels "
        "differ, by 9%0Aat most\n"
        "::error file=a%3Ab%2Cc.toml,line=6,col=7,title=odd%3A missing::nothing is | recorded "
        "<b> `x`\n"
        "::error file=sub/p.toml,line=8,col=1,title=bad%3A wrong-input::wrong\n");
    EXPECT_EQ(github_fault("p.toml:3:9: unknown key: x", ""),
              "::error file=p.toml,line=3,col=9,title=fumon verify::unknown key: x\n");
    EXPECT_EQ(github_fault("p.toml: is not there; 5 %", ""),
              "::error title=fumon verify::p.toml: is not there; 5 %25\n");
}

TEST(Annotations, FilesAreNamedFromTheCheckout) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "work/sub");
    const std::string place = (folder / "work/sub/p.toml").string() + ":5:1";
    const std::vector<Annotation> one{{place, "map", {Outcome::differs, "x"}}};
    EXPECT_TRUE(
        github_annotations(one, folder / "work").starts_with("::error file=sub/p.toml,line=5,"));
    EXPECT_TRUE(contains(github_annotations(one, folder / "other"), "work/sub/p.toml,line=5,"));
}

TEST(Annotations, TheSummaryIsATableOfWhatDoesNotPass) {
    EXPECT_EQ(github_summary(some_cases, "out/index.html"),
              "## fumon verify: 1 of 4 as recorded\n\n"
              "| picture | baseline | outcome | what was found |\n|---|---|---|---|\n"
              "| map | sub/p.toml:5:1 | **differs** | 3 % of its pixels differ, by 9 at most |\n"
              "| odd | a:b,c.toml:6:7 | **missing** | nothing is \\| recorded &lt;b&gt; \\`x\\` |\n"
              "| bad | sub/p.toml:8:1 | **wrong-input** | wrong |\n"
              "\nExpected, got and difference of each: out/index.html\n");
    EXPECT_EQ(github_summary(std::span(some_cases).first(1), ""),
              "## fumon verify: 1 of 1 as recorded\n\n");
    const std::vector<Annotation> many(
        3000, {"p.toml:1:1", "x", {Outcome::differs, std::string(1000, 'y')}});
    const std::string long_one = github_summary(many, "");
    EXPECT_LT(long_one.size(), std::size_t{1} << 20U);
    EXPECT_TRUE(contains(long_one, " more\n"));
}

/// What GitLab's documentation asks of a Code Quality report: an array of objects with a
/// description, a check's name, a fingerprint of its own, one of five severities, and a location of
/// a path inside the repository, without "./", and the line where it begins.
void check_code_quality(const nlohmann::json& report) {
    const std::set<std::string> severities{"info", "minor", "major", "critical", "blocker"};
    ASSERT_TRUE(report.is_array());
    std::set<std::string> fingerprints;
    for (const auto& issue : report) {
        ASSERT_TRUE(issue.is_object());
        for (const char* key : {"description", "check_name", "fingerprint", "severity"}) {
            ASSERT_TRUE(issue.at(key).is_string()) << key;
            EXPECT_FALSE(issue.at(key).get<std::string>().empty()) << key;
        }
        EXPECT_TRUE(fingerprints.insert(issue["fingerprint"]).second);
        EXPECT_TRUE(severities.contains(issue["severity"])) << issue["severity"];
        const std::string path = issue.at("location").at("path");
        EXPECT_FALSE(path.empty() || path.starts_with("./") || path.starts_with("/")) << path;
        const auto& begin = issue["location"].at("lines").at("begin");
        ASSERT_TRUE(begin.is_number_integer());
        EXPECT_GE(begin.get<int>(), 1);
    }
}

TEST(Annotations, GitLabsReportIsOfItsSchema) {
    const auto report = nlohmann::json::parse(gitlab_report(some_cases, ""));
    check_code_quality(report);
    ASSERT_EQ(report.size(), 3U);
    EXPECT_EQ(report[0]["description"], "map: 3 % of its pixels differ, by 9\nat most");
    EXPECT_EQ(report[0]["check_name"], "fumon-verify/differs");
    EXPECT_EQ(report[0]["severity"], "major");
    EXPECT_EQ(report[0]["location"]["path"], "sub/p.toml");
    EXPECT_EQ(report[0]["location"]["lines"]["begin"], 5);
    EXPECT_EQ(report[2]["severity"], "critical");
    auto moved = some_cases;
    moved[1].place = "sub/p.toml:50:1";
    EXPECT_EQ(nlohmann::json::parse(gitlab_report(moved, ""))[0]["fingerprint"],
              report[0]["fingerprint"])
        << "the same finding, further down";
    EXPECT_EQ(gitlab_report({}, ""), "[]\n");
}

TEST(Annotations, AreWrittenByTheCommand) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    write_text(folder / "b.toml", "[cases]\na = {scene = \"scene.toml\", step = 0}\n");
    const std::string workspace = "GITHUB_WORKSPACE=" + folder.path().parent_path().string();
    const std::string summary = "GITHUB_STEP_SUMMARY=" + (folder / "summary.md").string();
    write_text(folder / "summary.md", "of an earlier step\n");
    const std::string name = folder.path().filename().string();
    const Ended missing =
        fumon({"verify", "b.toml", "--format", "github"}, folder.path(), {workspace, summary});
    EXPECT_EQ(missing.status, 1) << missing.errors;
    EXPECT_TRUE(contains(missing.output, "MISSING  b a: "));
    EXPECT_TRUE(contains(missing.output,
                         "\n::error file=" + name + "/b.toml,line=2,col=1,title=a%3A missing::"))
        << missing.output;
    EXPECT_TRUE(read_text(folder / "summary.md")
                    .starts_with("of an earlier step\n## fumon verify: 0 of 1 as recorded\n"));
    const Ended gitlab = fumon({"verify", "b.toml", "--format", "gitlab"}, folder.path());
    EXPECT_EQ(gitlab.status, 1);
    check_code_quality(nlohmann::json::parse(gitlab.output));
    EXPECT_EQ(fumon({"verify", "b.toml", "--format", "gitlab", "--json"}, folder.path()).status, 2);
    EXPECT_EQ(fumon({"verify", "b.toml", "--format", "none"}, folder.path()).status, 2);
    const Ended nowhere = fumon({"verify", "b.toml", "--format", "github"}, folder.path(),
                                {"GITHUB_STEP_SUMMARY=/nowhere/summary.md"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_TRUE(contains(nowhere.errors, "/nowhere/summary.md: the job summary cannot be written"));

    ASSERT_EQ(fumon({"verify", "b.toml", "--update", "--pinned"}, folder.path()).status, 0);
    EXPECT_EQ(fumon({"verify", "b.toml", "--format", "gitlab"}, folder.path()).output, "[]\n");
    EXPECT_FALSE(contains(fumon({"verify", "b.toml", "--format", "github"}, folder.path()).output,
                          "::error"));
    write_text(folder / "b.toml", "[cases]\na = {scene = \"scene.toml\", stop = 0}\n");
    const Ended wrong = fumon({"verify", "b.toml", "--format", "github"}, folder.path());
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(
        contains(wrong.output, "\n::error file=b.toml,line=2,col=28,title=a%3A wrong-input::"))
        << wrong.output;
}

}  // namespace
}  // namespace fumon::test
