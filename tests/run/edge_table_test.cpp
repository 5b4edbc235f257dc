// The tables that [[edge]] names, as hydrographs come from other programs.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace fumon::test {
namespace {

class EdgeTable : public ::testing::Test {
  protected:
    /// A run of one step whose western edge has this table.
    Ended run_with(const std::string& table) {
        write_text(folder_ / "table.csv", table);
        write_text(folder_ / "scene.toml",
                   "[model]\nname = \"water\"\n[grid]\nnx = 8\nny = 4\ncell_size = [5.0]\n[bed]\n"
                   "kind = \"flat\"\n[run]\nsteps = 1\n[output]\nframes = false\nmovie = false\n"
                   "[[edge]]\nside = \"west\"\nkind = \"discharge\"\ntable = \"table.csv\"\n");
        return fumon({"run", "scene.toml", "-o", "out", "-q", "--force"}, folder_.path());
    }

    ScratchFolder folder_;
};

TEST_F(EdgeTable, IsReadWithOrWithoutAHeaderInAnySeparator) {
    const std::vector<std::string> tables{"0,0.5\n600,5.5\n",
                                          "seconds,value\n0,0.5\n600,5.5\n",
                                          "t;Q\n0;0,5\n600;5,5\n",
                                          "0;0,5\r\n600;5,5\r\n",
                                          "# gauge 7\nt\tQ\n0\t0.5\n600\t5.5\n",
                                          "\xEF\xBB\xBFt,Q\n0,0.5\n\n600,5.5\n"};
    for (const std::string& table : tables) {
        const Ended ended = run_with(table);
        ASSERT_EQ(ended.status, 0) << table << ended.errors;
        const auto edge = read_manifest(folder_ / "out")["scene"]["edge"][0];
        EXPECT_EQ(edge["times"], (std::vector<double>{0.0, 600.0})) << table;
        EXPECT_EQ(edge["values"], (std::vector<double>{0.5, 5.5})) << table;
    }
}

TEST_F(EdgeTable, IsRefusedInOneLineWithItsReason) {
    const std::vector<std::pair<std::string, std::string>> tables{
        {"t,Q\n0,inf\n", "table.csv:2"},
        {"t,Q\n0,nan\n", "table.csv:2"},
        {"t,Q\n0,much\n", "table.csv:2"},
        {"t,Q,R\n0,1,2\n", "it takes two columns"},
        {"", "table.csv"},
    };
    for (const auto& [table, reason] : tables) {
        const Ended ended = run_with(table);
        EXPECT_EQ(ended.status, 2) << table;
        EXPECT_NE(ended.errors.find(reason), std::string::npos) << table << ended.errors;
        EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
    }
}

}  // namespace
}  // namespace fumon::test
