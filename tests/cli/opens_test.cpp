#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// Everything that declares tests: the sources and CMakeLists.txt of tests.
const std::string& declarations() {
    static const std::string all = [] {
        std::string text;
        for (const auto& entry : fs::recursive_directory_iterator(FUMON_TEST_FOLDER)) {
            const fs::path& file = entry.path();
            if (file.extension() == ".cpp" || file.filename() == "CMakeLists.txt")
                text += read_text(file);
        }
        return text;
    }();
    return all;
}

/// "Suite.Name", "Suite.*", "python.name", or "reach.Name".
bool is_a_test(const std::string& suite, const std::string& name) {
    const std::string parameter = suite + (name == "*" ? "," : ", " + name + ")");
    for (const char* kind : {"TEST(", "TEST_F(", "TEST_P("})
        if (declarations().find(kind + parameter) != std::string::npos) return true;
    if (suite == "python")
        return fs::exists(fs::path(FUMON_TEST_FOLDER) / "python" / ("test_" + name + ".py"));
    return declarations().find("NAME " + suite + "." + name + " ") != std::string::npos;
}

/// What a row of the page lacks; empty where nothing does.
std::string fault_of_row(const std::string& row) {
    const std::size_t end = row.rfind(" |");
    const std::string tried = row.substr(row.rfind("| ", end - 1) + 2);
    if (tried.starts_with("not tried")) return "";
    static const std::regex test("`([A-Za-z]+)\\.([A-Za-z]+|\\*)`");
    static const std::regex day("20[0-9][0-9]-[01][0-9]-[0-3][0-9]");
    bool named = std::regex_search(tried, day);
    for (std::sregex_iterator at(tried.begin(), tried.end(), test), none; at != none; ++at) {
        if (!is_a_test((*at)[1], (*at)[2])) return (*at)[0].str() + " is no test";
        named = true;
    }
    return named ? "" : "neither a test nor a day";
}

TEST(OpensPage, EveryRowNamesATestOrADay) {
    EXPECT_EQ(fault_of_row("| a | 1 | b | c | by hand, 2026-11-27 |"), "");
    EXPECT_EQ(fault_of_row("| a | 1 | b | c | by hand |"), "neither a test nor a day");
    EXPECT_EQ(fault_of_row("| a | 1 | b | c | test `OpensPage.Gone`; 2026-11-27 |"),
              "`OpensPage.Gone` is no test");
    std::istringstream page(read_text(fs::path(FUMON_GUIDE_FOLDER) / "opens.md"));
    int rows = 0;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| ") || line.starts_with("| program ")) continue;
        EXPECT_EQ(fault_of_row(line), "") << line;
        ++rows;
    }
    EXPECT_GT(rows, 20);
}

}  // namespace
}  // namespace fumon::test
