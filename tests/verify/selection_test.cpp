#include <gtest/gtest.h>

#include "support/verify_folder.h"
#include "verify/case_selection.h"

namespace fumon::test {
namespace {

class VerifySelection : public ::testing::Test, public VerifyFolder {
  protected:
    VerifySelection() {
        write_baseline("b.toml", "young = {}\nold = {}\nold_map = {}\nolder = {}\n");
        write_baseline("c.toml", "young = {}\n");
    }

    [[nodiscard]] std::string listed(std::vector<std::string> words) const {
        words.emplace_back("--list");
        const Ended ended = verify(words);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return ended.output;
    }
};

TEST_F(VerifySelection, NamesPatternsAndShardsChoose) {
    EXPECT_EQ(listed({"b.toml", "c.toml"}),
              "b.toml young\nb.toml old\nb.toml old_map\nb.toml older\nc.toml young\n");
    EXPECT_EQ(listed({"b.toml", "c.toml", "old", "young"}),
              "b.toml young\nb.toml old\nc.toml young\n");
    EXPECT_EQ(listed({"b.toml", "c.toml", "c/young"}), "c.toml young\n");
    EXPECT_EQ(listed({"b.toml", "-k", "old"}), "b.toml old\nb.toml old_map\nb.toml older\n");
    EXPECT_EQ(listed({"b.toml", "-k", "old?*", "-k", "youn*"}),
              "b.toml young\nb.toml old_map\nb.toml older\n");
    EXPECT_EQ(listed({"b.toml", "--shard", "1/3"}), "b.toml young\nb.toml older\n");
    EXPECT_EQ(listed({"b.toml", "--shard", "2/3"}), "b.toml old\n");
    EXPECT_EQ(listed({"b.toml", "--shard", "3/3", "-k", "old"}), "b.toml older\n");
    const Ended none = verify({"b.toml", "-k", "yuong"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.errors, "no case has a name like \"yuong\"; did you mean \"young\"?\n");
    EXPECT_EQ(verify({"young"}).errors,
              "fumon verify: \"young\" is not a file; name a baseline (TOML), then its cases\n");
    EXPECT_FALSE(has("verify-out"));
}

TEST_F(VerifySelection, ChosenCasesAloneAreRecordedAndCompared) {
    const Ended update = verify({"b.toml", "old", "--update"});
    EXPECT_EQ(update.output, "new      b old: recorded; look at it before you keep it\n");
    EXPECT_TRUE(contains(text("b.lock"), "[recorded.old]"));
    EXPECT_FALSE(contains(text("b.lock"), "[recorded.older]"));
    EXPECT_EQ(verify({"b.toml", "old"}).status, 0);
    EXPECT_TRUE(contains(verify({"b.toml", "-k", "old*", "-q"}).output, "MISSING  b older: "));
    write_baseline("b.toml", "young = {}\n");
    EXPECT_EQ(verify({"b.toml", "young", "--update"}).status, 0);
    EXPECT_TRUE(contains(text("b.lock"), "[recorded.old]")) << "it was not meant";
    EXPECT_EQ(verify({"b.toml", "--shard", "1/2", "--update"}).status, 2);
}

TEST_F(VerifySelection, OnePictureIsAcceptedFromTheLastResults) {
    const std::string cases = "young = {picture = true}\nold = {}\n";
    write_baseline("b.toml", cases);
    ASSERT_EQ(verify({"b.toml", "--update", "--pinned"}).status, 0);
    write_baseline("b.toml", cases, "settings = [\"sun.azimuth=320\"]\n");
    ASSERT_EQ(verify({"b.toml"}).status, 1);
    const std::string page = text("verify-out/index.html");
    EXPECT_TRUE(contains(page, "<code>fumon verify b.toml --accept young</code>")) << page.size();
    const Ended accepted = verify({"b.toml", "--accept", "young"});
    EXPECT_EQ(accepted.status, 0) << accepted.errors;
    EXPECT_TRUE(accepted.output.starts_with("accepted b young: the pixels change, "))
        << accepted.output;
    EXPECT_EQ(text("b/young.png"), text("verify-out/b/young-got.png"));
    const Ended now = verify({"b.toml", "-o", "out 2"});
    EXPECT_TRUE(contains(now.output, "ok       b young: strict: ")) << now.output;
    EXPECT_TRUE(contains(now.output, "DIFFERS  b old: ")) << now.output;
    EXPECT_TRUE(contains(text("out 2/index.html"), "--accept old -o &apos;out 2&apos;") ||
                contains(text("out 2/index.html"), "--accept old -o &#39;out 2&#39;"));
    EXPECT_TRUE(contains(verify({"b.toml", "--accept", "young", "-o", "out 2"}).errors,
                         "have no new picture of young of b.toml"));
    EXPECT_EQ(verify({"b.toml", "--accept", "old", "-o", "out 2"}).status, 0);
    EXPECT_EQ(verify({"b.toml"}).status, 0);
}

TEST_F(VerifySelection, ReportsTellBaselinesOfOneNameApart) {
    std::filesystem::create_directory(folder_ / "sub");
    std::filesystem::copy(folder_ / "scene.toml", folder_ / "sub/scene.toml");
    write_baseline("p.toml", "one = {}\n");
    write_baseline("sub/p.toml", "one = {}\n");
    ASSERT_EQ(verify({"p.toml", "--update"}).status, 0);
    ASSERT_EQ(verify({"p.toml", "sub/p.toml", "--junit", "j.xml"}).status, 1);
    const std::string xml = text("j.xml");
    EXPECT_TRUE(contains(xml, "<testcase classname=\"p\" name=\"one\"")) << xml;
    EXPECT_TRUE(contains(xml, "<testcase classname=\"sub.p\" name=\"one\"")) << xml;
    EXPECT_TRUE(contains(xml, "<failure type=\"missing\"")) << xml;
    EXPECT_TRUE(contains(xml, " timestamp=\"2"));
    for (const char* which : {"expected", "got"})
        EXPECT_TRUE(contains(xml, std::string("name=\"one.") + which + "-pixels-sha256\"")) << xml;
}

}  // namespace
}  // namespace fumon::test
