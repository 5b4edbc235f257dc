#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "support/command.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// What src/build_date.cmake says of a source folder, with variables before the command.
std::string build_date(const fs::path& root, const std::string& variables) {
    const std::string command = "env -u SOURCE_DATE_EPOCH " + variables +
                                " '" FUMON_CMAKE "' -D ROOT='" + root.string() +
                                "' -P '" FUMON_SOURCES_FOLDER "/build_date.cmake'";
    std::string said = run_command(command).words;
    while (said.ends_with('\n')) said.pop_back();
    return said;
}

/// A source folder with a change log that ends in the release of 2024-05-06.
class BuildDate : public ::testing::Test {
  protected:
    void write_log(const std::string& first_heading) const {
        fs::create_directories(folder_ / "assets/guide");
        write_text(folder_ / "assets/guide/CHANGELOG.md",
                   "# Changes\n\n" + first_heading + "\n\n* a\n\n## 0.1.0 (2024-05-06)\n");
    }

    ScratchFolder folder_;
};

TEST_F(BuildDate, IsThatOfTheReleaseOrOfSourceDateEpoch) {
    write_log("## 0.2.0 (2025-07-08)");
    EXPECT_EQ(build_date(folder_.path(), ""), "2025-07-08");
    EXPECT_EQ(build_date(folder_.path(), "SOURCE_DATE_EPOCH=86399"), "1970-01-01");
    EXPECT_EQ(build_date(folder_.path(), "TZ=Asia/Tokyo SOURCE_DATE_EPOCH=86399"), "1970-01-01");
    write_log("## 0.2.0 (not released yet)");
    EXPECT_EQ(build_date(folder_.path(), ""), "2024-05-06") << "no checkout";
}

TEST_F(BuildDate, OfAnUnreleasedCheckoutIsThatOfItsCommit) {
    if (std::system("command -v git > /dev/null") != 0) GTEST_SKIP() << "no git here";
    write_log("## 0.2.0 (not released yet)");
    const std::string git = "git -C '" + folder_.path().string() + "' ";
    const std::string made = "env GIT_COMMITTER_DATE='2025-01-02T23:30:00 -0500' " + git +
                             "-c user.name=a -c user.email=a@b commit -q --allow-empty -m a";
    ASSERT_EQ(std::system((git + "init -q && " + made).c_str()), 0);
    EXPECT_EQ(build_date(folder_.path(), ""), "2025-01-03") << "in UTC";
    EXPECT_EQ(build_date(folder_.path(), "TZ=America/New_York"), "2025-01-03");
    EXPECT_EQ(build_date(folder_.path(), "SOURCE_DATE_EPOCH=0"), "1970-01-01");
    write_log("## 0.2.0 (2025-07-08)");
    EXPECT_EQ(build_date(folder_.path(), ""), "2025-07-08");
}

TEST(ManPage, HasTheDayOfItsBuild) {
    static const std::regex head("\n\\.TH FUMON 1 \"20[0-9][0-9]-[01][0-9]-[0-3][0-9]\" \"fumon ");
    const std::string page = fumon({"man"}, fs::current_path()).output;
    EXPECT_TRUE(std::regex_search(page, head)) << page.substr(0, 200);
}

}  // namespace
}  // namespace fumon::test
