#include "files/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

Table read(std::string_view text) {
    return parse_csv_table({"points.csv", text});
}

TEST(CsvTable, ReadsNumbersWordsAndEmptyCells) {
    const Table table = read(
        "\xEF\xBB\xBF# measured\r\nx,kind,\"y, m\"\r\n1,dune,2.5\r\n\r\n -2e3 ,"
        "\"a \"\"big\"\" one\",\r\n3,4,nan\n");
    EXPECT_EQ(table.names(), (std::vector<std::string>{"x", "kind", "y, m"}));
    ASSERT_EQ(table.rows(), 3U);
    EXPECT_EQ(table.find("x")->values, (std::vector<double>{1.0, -2000.0, 3.0}));
    EXPECT_TRUE(table.find("x")->words.empty());
    EXPECT_EQ(table.find("kind")->words, (std::vector<std::string>{"dune", "a \"big\" one", "4"}));
    EXPECT_EQ(table.find("y, m")->values[0], 2.5);
    EXPECT_TRUE(std::isnan(table.find("y, m")->values[1]));
    EXPECT_TRUE(std::isnan(table.find("y, m")->values[2]));
    EXPECT_EQ(table.find("z"), nullptr);
}

TEST(CsvTable, JoinsNumbersToWords) {
    Table table = read("kind\n1\n2\n");
    table.append(read("kind\nbarchan\n"));
    table.append(read("kind\n3\n"));
    ASSERT_EQ(table.rows(), 4U);
    EXPECT_EQ(table.columns[0].words, (std::vector<std::string>{"1", "2", "barchan", "3"}));
    EXPECT_EQ(table.columns[0].text(1), "2");
}

TEST(CsvTable, WritesWhatItReads) {
    const std::vector<std::string> cells{"a,b", "say \"x\"", "two\nlines", ""};
    EXPECT_EQ(read(csv_line(cells)).names(), cells);
}

TEST(CsvTable, ATextIsNoFormulaToASpreadsheetAndReadsBackAsItWas) {
    const std::vector<std::string> texts{"=1+1", "+a",  "-x.asc",   "@SUM(1)",  "\t=1", "\r=1",
                                         "'=1",  "''@", "=1,\"2\"", "'quoted'", "a=1"};
    EXPECT_EQ(csv_line(texts),
              "'=1+1,'+a,'-x.asc,'@SUM(1),'\t=1,\"'\r=1\",''=1,'''@,\"'=1,\"\"2\"\"\",'quoted',"
              "a=1\n");
    EXPECT_EQ(read(csv_line(texts)).names(), texts);
    EXPECT_EQ(read("kind\n" + csv_line({"=1+1"})).columns[0].words.front(), "=1+1");
}

TEST(CsvTable, NumbersStayNumbers) {
    const std::vector<std::string> numbers{"-0.5", "+3", "-1e-5", "-inf", "-.5", "7"};
    EXPECT_EQ(csv_line(numbers), "-0.5,+3,-1e-5,-inf,-.5,7\n");
}

TEST(CsvTable, SaysWhatIsWrong) {
    const auto refusal = [](std::string_view text) {
        return message_of<InputError>([&] { read(text); });
    };
    EXPECT_EQ(refusal("\n# nothing\n"),
              "points.csv:2: there is no header line; begin with the columns' names");
    EXPECT_EQ(refusal("x,x\n"), "points.csv:1: column 'x' is there twice; rename one");
    EXPECT_EQ(refusal("x,y\n1,2\n1\n"), "points.csv:3: 1 cells; the header has 2 columns");
    EXPECT_EQ(refusal("x\n\"1\n"), "points.csv:2: a quote has no end; close it");
}

TEST(CsvTable, AFirstCellThatWouldHideItsLineIsQuoted) {
    EXPECT_EQ(csv_line({"#1", "#2"}), "\"#1\",#2\n");
    EXPECT_EQ(csv_line({""}), "\"\"\n");
    EXPECT_EQ(csv_line({"", ""}), ",\n");
    const std::string text = csv_line({"\xEF\xBB\xBF"
                                       "a"}) +
                             csv_line({"#1"}) + csv_line({""});
    const Table table = read(text);
    EXPECT_EQ(table.names(), (std::vector<std::string>{"\xEF\xBB\xBF"
                                                       "a"}));
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.columns[0].text(0), "#1");
    EXPECT_EQ(table.columns[0].text(1), "");
}

}  // namespace
}  // namespace fumon::test
