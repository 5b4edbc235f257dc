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
    EXPECT_EQ(refusal("x,x\n"), "points.csv:1: column 'x' occurs twice; rename one");
    EXPECT_EQ(refusal("x,y\n1,2\n1\n"), "points.csv:3: 1 cell; the header has 2 columns");
    EXPECT_EQ(refusal("x\n1,5\n"),
              "points.csv:2: 2 cells; the header has 1 column; decimal commas take semicolons or "
              "tabs between cells");
    EXPECT_EQ(refusal("x;y\n1;2;3\n"), "points.csv:2: 3 cells; the header has 2 columns");
    EXPECT_EQ(refusal("x;y\n1,5;2\n1.5;2\n"),
              "points.csv:3: numbers mix decimal commas and decimal points; write one of them");
    EXPECT_EQ(refusal("\xFF\xFEx\n"), "points.csv:1: the text is UTF-16; save it as UTF-8");
    EXPECT_EQ(refusal("\n\xFE\xFF\n"), "points.csv:2: the text is UTF-16; save it as UTF-8");
    EXPECT_EQ(refusal("x\n\"1\n"),
              "points.csv:2: a quoted cell is not closed; write its closing quote");
}

/// Two columns, t and q, with 0 to 10 s and 0 to 2.5.
void expect_hydrograph(std::string_view text, const WantedHeader& wanted = {}) {
    SCOPED_TRACE(text);
    const Table table = parse_csv_table({"flood.csv", text}, wanted);
    EXPECT_EQ(table.names(), (std::vector<std::string>{"t", "q"}));
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].values, (std::vector<double>{0.0, 10.0}));
    EXPECT_EQ(table.columns[1].values, (std::vector<double>{0.0, 2.5}));
    EXPECT_TRUE(table.columns[1].words.empty());
}

TEST(CsvTable, CellsStandBetweenCommasSemicolonsOrTabs) {
    expect_hydrograph("t,q\n0,0\n10,2.5\n");
    expect_hydrograph("t, q\r\n0, 0\r\n10, 2.5\r\n \r\n");
    expect_hydrograph("t;q\n0;0\n10;2.5\n");
    expect_hydrograph("t;q\n0;0,0\n10,0;2,5\n");
    expect_hydrograph("t\tq\r0\t0\r10\t2,5\r");
    expect_hydrograph("\xEF\xBB\xBF# from a gauge; daily\n\"t\";q\n0;\"0\"\n# later\n10;2,5");
    EXPECT_EQ(read("t (s), since noon;q\n0;1,5\n").columns[1].values, std::vector<double>{1.5});
    EXPECT_EQ(read("what;why,n\na;b,3\n").columns[1].values, std::vector<double>{3.0});
}

TEST(CsvTable, AFirstLineOfNumbersIsDataWhereTheOrderIsClear) {
    const WantedHeader wanted{{"t", "q"}, "it takes two columns"};
    expect_hydrograph("0,0\n10,2.5\n", wanted);
    expect_hydrograph("# t, q\n0,0\n10,2.5\n", wanted);
    expect_hydrograph("0;0,0\n10;2,5\n", wanted);
    expect_hydrograph("0\t0,0\n10\t2,5\n", wanted);
    expect_hydrograph("t,q\n0,0\n10,2.5\n", wanted);
    const auto refusal = [&](std::string_view text, const WantedHeader& header) {
        return message_of<InputError>([&] { parse_csv_table({"flood.csv", text}, header); });
    };
    EXPECT_EQ(refusal("0,0,0\n", wanted),
              "flood.csv:1: 3 columns of numbers and no header line; it takes two columns");
    EXPECT_EQ(refusal("\n0,nan\n", {}),
              "flood.csv:2: 2 columns of numbers and no header line; begin with the columns' "
              "names");
}

TEST(CsvTable, NumbersThatAreNoneAreNamed) {
    const auto refusal = [](std::string_view text) {
        return message_of<InputError>([&] {
            const TextSource source{"flood.csv", text};
            const Table table = parse_csv_table(source);
            numbers_of(source, table, table.columns[1], 0.0, 10.0);
        });
    };
    EXPECT_EQ(refusal("t,q\n0,1\n# a gap\n\n1,inf\n"),
              "flood.csv:5: q is 'inf'; it takes a number from 0 to 10");
    EXPECT_EQ(refusal("t,q\r\n0,1\r\n1,NaN\r\n"),
              "flood.csv:3: q is 'NaN'; it takes a number from 0 to 10");
    EXPECT_EQ(refusal("t,q\n0,\n"), "flood.csv:2: q is empty; it takes a number from 0 to 10");
    EXPECT_EQ(refusal("t;q\n0;11,5\n"), "flood.csv:2: q is '11.5'; it takes a number from 0 to 10");
    EXPECT_EQ(refusal("t,q\n0,high\n"), "flood.csv:2: q is 'high'; it takes a number from 0 to 10");
    EXPECT_EQ(refusal("t,q\n0,1\n"), "");
}

TEST(CsvTable, WhatIsWrittenIsReadAgainWhateverItsCellsHold) {
    for (const std::vector<std::string>& cells : {std::vector<std::string>{"a;b"},
                                                  {"a\tb"},
                                                  {"a;b", "c"},
                                                  {" a", "b "},
                                                  {"a\tb", "c\td"}}) {
        EXPECT_EQ(read(csv_line(cells)).names(), cells);
        EXPECT_EQ(read(csv_line(cells) + csv_line(cells)).columns[0].words.front(), cells[0]);
    }
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
