#include "files/avalanche_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "support/full_disk.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

const std::string table_head = "grain,size,duration,topplings,lost\n";

void expect_same(const Avalanche& found, const Avalanche& expected) {
    EXPECT_EQ(found.grain, expected.grain);
    EXPECT_EQ(found.size, expected.size);
    EXPECT_EQ(found.duration, expected.duration);
    EXPECT_EQ(found.topplings, expected.topplings);
    EXPECT_EQ(found.lost, expected.lost);
}

TEST(AvalancheTable, IsWrittenRowByRow) {
    const TemporaryFolder folder;
    AvalancheFile file(folder / "avalanches.csv");
    file.add(std::vector<Avalanche>{{5, 4, 1, 1, 0}, {9, 12, 3, 5, 2}});
    file.add({});
    file.add(std::vector<Avalanche>{{60000, 256, 40, 2000, 31}});
    EXPECT_FALSE(std::filesystem::exists(folder / "avalanches.csv"));
    file.commit();
    EXPECT_EQ(bytes_of(folder / "avalanches.csv"),
              table_head + "5,4,1,1,0\n9,12,3,5,2\n60000,256,40,2000,31\n");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AvalancheTable, OfARunWithoutAvalanchesIsItsHeader) {
    const TemporaryFolder folder;
    AvalancheFile file(folder / "a.csv");
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.csv"), table_head);
    EXPECT_TRUE(read_avalanches(folder / "a.csv").empty());
}

TEST(AvalancheTable, LeavesNothingWhenNotCommitted) {
    const TemporaryFolder folder;
    {
        AvalancheFile file(folder / "a.csv");
        file.add(std::vector<Avalanche>(10'000, Avalanche{1, 1, 1, 1, 0}));
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AvalancheTable, SaysThatTheDiskIsFull) {
    const TemporaryFolder folder;
    const test::FileSizeLimit limit(100'000);
    AvalancheFile file(folder / "a.csv");
    const std::vector<Avalanche> many(20'000, Avalanche{1, 1, 1, 1, 0});
    EXPECT_EQ(message_of<Error>([&] { file.add(many); }),
              "cannot write " + (folder / "a.csv").string() + ": File too large");
}

TEST(AvalancheTable, ComesBackAsItWasWrittenAlsoWhenLarge) {
    const TemporaryFolder folder;
    std::vector<Avalanche> written;
    for (std::int64_t i = 1; i <= 200'000; ++i)
        written.push_back({i, 1 + i * i % 4096, 1 + i % 97, 1 + i * 7919 % 100'003, i % 5});
    written.push_back({1'000'000'000'000'000, 1'000'000'000'000'000, 1'000'000'000'000'000,
                       1'000'000'000'000'000, 1'000'000'000'000'000});
    AvalancheFile file(folder / "a.csv");
    for (std::size_t i = 0; i < written.size(); i += 1000)
        file.add(std::span(written).subspan(i, std::min<std::size_t>(1000, written.size() - i)));
    file.commit();
    const auto read = read_avalanches(folder / "a.csv");
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        expect_same(read[i], written[i]);
        if (HasFailure()) break;
    }
}

struct Spelling {
    std::string name;
    std::string text;
};

class AcceptedTable : public ::testing::TestWithParam<Spelling> {};

TEST_P(AcceptedTable, IsRead) {
    const auto read = parse_avalanches({"a.csv", GetParam().text});
    ASSERT_EQ(read.size(), 2U);
    expect_same(read[0], {3, 4, 1, 1, 0});
    expect_same(read[1], {7, 12, 3, 5, 2});
}

const std::vector<Spelling> spellings{
    {"Unix", table_head + "3,4,1,1,0\n7,12,3,5,2\n"},
    {"Dos", "grain,size,duration,topplings,lost\r\n3,4,1,1,0\r\n7,12,3,5,2\r\n"},
    {"CarriageReturns", "grain,size,duration,topplings,lost\r3,4,1,1,0\r7,12,3,5,2\r"},
    {"NoLastLineEnd", table_head + "3,4,1,1,0\n7,12,3,5,2"},
    {"BlankLinesAtTheEnd", table_head + "3,4,1,1,0\n7,12,3,5,2\n\n \r\n\t\n"},
    {"BlanksBesideNumbers", table_head + " 3, 4,\t1 ,1,0 \n7,12,3,5,2\n"},
    {"ByteOrderMark", "\xEF\xBB\xBF" + table_head + "3,4,1,1,0\n7,12,3,5,2\n"},
};

INSTANTIATE_TEST_SUITE_P(AvalancheTable, AcceptedTable, ::testing::ValuesIn(spellings),
                         [](const auto& spelling) { return spelling.param.name; });

struct BrokenTable {
    std::string name;
    std::string text;
    std::string expected;  ///< behind the file's name
};

class RefusedTable : public ::testing::TestWithParam<BrokenTable> {};

TEST_P(RefusedTable, SaysWhereAndWhy) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.csv", GetParam().text);
    EXPECT_EQ(message_of<InputError>([&] { read_avalanches(file); }),
              file.string() + GetParam().expected);
}

const std::string first_line = "; its first line is 'grain,size,duration,topplings,lost'";
const std::string five = "; write 5 whole numbers: grain,size,duration,topplings,lost";
const std::string from_one = "; write a whole number from 1 to 1000000000000000";
const std::string from_none = "; write a whole number from 0 to 1000000000000000";

const std::vector<BrokenTable> broken_tables{
    {"Empty", "",
     ":1:1: the file is empty; a table of avalanches starts with "
     "'grain,size,duration,topplings,lost'"},
    {"Blank", "\r\n \n",
     ":1:1: the file is empty; a table of avalanches starts with "
     "'grain,size,duration,topplings,lost'"},
    {"OtherHeader", "grain,size\n1,2\n",
     ":1:1: 'grain,size' does not start a table of avalanches" + first_line},
    {"OtherOrder", "size,grain,duration,topplings,lost\n",
     ":1:1: 'size,grain,duration,topplings,lost' does not start a table of avalanches" +
         first_line},
    {"Semicolons", "grain;size;duration;topplings;lost\n",
     ":1:1: 'grain;size;duration;topplings;lost' does not start a table of avalanches" +
         first_line},
    {"NoHeader", "5,4,1,1,0\n",
     ":1:1: '5,4,1,1,0' does not start a table of avalanches" + first_line},
    {"HeaderOnTheSecondLine", "\n" + table_head,
     ":1:1: '' does not start a table of avalanches" + first_line},
    {"TooFewFields", table_head + "5,4,1,1,0\n9,12,3\n", ":3:1: 3 fields in '9,12,3'" + five},
    {"TooManyFields", table_head + "5,4,1,1,0,\n", ":2:1: 6 fields in '5,4,1,1,0,'" + five},
    {"SemicolonsInARow", table_head + "5;4;1;1;0\n", ":2:1: 1 fields in '5;4;1;1;0'" + five},
    {"BlankLineBetween", table_head + "5,4,1,1,0\r\n\r\n9,12,3,5,2\r\n",
     ":3:1: a blank line between rows; take it out, or the rows below it"},
    {"Word", table_head + "5,four,1,1,0\n", ":2:3: size is 'four'" + from_one},
    {"EmptyField", table_head + "5,4,,1,0\n", ":2:5: duration is ''" + from_one},
    {"EmptyLastField", table_head + "5,4,1,1,\n", ":2:9: lost is ''" + from_none},
    {"Fraction", table_head + "5,4,1,1.5,0\n", ":2:7: topplings is '1.5'" + from_one},
    {"Exponent", table_head + "1e3,4,1,1,0\n", ":2:1: grain is '1e3'" + from_one},
    {"TwoNumbers", table_head + "5,4 4,1,1,0\n", ":2:3: size is '4 4'" + from_one},
    {"ZeroGrain", table_head + "0,4,1,1,0\n", ":2:1: grain is '0'" + from_one},
    {"ZeroSize", table_head + "5,0,1,1,0\n", ":2:3: size is '0'" + from_one},
    {"ZeroDuration", table_head + "5,4,0,1,0\n", ":2:5: duration is '0'" + from_one},
    {"ZeroTopplings", table_head + "5,4,1,0,0\n", ":2:7: topplings is '0'" + from_one},
    {"NegativeLost", table_head + "5,4,1,1, -1\n", ":2:10: lost is '-1'" + from_none},
    {"TooLarge", table_head + "5,1000000000000001,1,1,0\n",
     ":2:3: size is '1000000000000001'" + from_one},
    {"FarTooLarge", table_head + "5,4,99999999999999999999,1,0\n",
     ":2:5: duration is '99999999999999999999'" + from_one},
    {"DosLines", "grain,size,duration,topplings,lost\r\n5,4,1,1,0\r\n6,x,1,1,0\r\n",
     ":3:3: size is 'x'" + from_one},
};

INSTANTIATE_TEST_SUITE_P(AvalancheTable, RefusedTable, ::testing::ValuesIn(broken_tables),
                         [](const auto& broken) { return broken.param.name; });

TEST(AvalancheTable, SaysThatThereIsNoFile) {
    const TemporaryFolder folder;
    const auto file = folder / "none.csv";
    EXPECT_EQ(message_of<InputError>([&] { read_avalanches(file); }),
              file.string() +
                  ": cannot be read: No such file or directory; name a file that "
                  "exists and that you may read");
}

}  // namespace
}  // namespace fumon
