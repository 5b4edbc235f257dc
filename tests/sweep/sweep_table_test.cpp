#include "sweep/sweep_table.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "files/csv_table.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

TEST(SweepTable, QuotesOnlyWhatNeedsIt) {
    EXPECT_EQ(csv_line({"a", "", "b c"}), "a,,b c\n");
    EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}),
              "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

TEST(SweepTable, PutsTheRunBeforeEachRow) {
    const TemporaryFolder folder;
    const auto one = folder.file("1.csv", "step,time,mean\n0,0,1.5\n10,10,\n");
    const auto two = folder.file("2.csv", "step,time,mean\n0,0,2.5\n");
    write_table(folder / "all.csv", {"run", "key"}, {{{"1", "a,b"}, one}, {{"2", "c"}, two}});
    EXPECT_EQ(bytes_of(folder / "all.csv"),
              "run,key,step,time,mean\n1,\"a,b\",0,0,1.5\n1,\"a,b\",10,10,\n2,c,0,0,2.5\n");
}

TEST(SweepTable, ColumnsThatARunDoesNotHaveStayEmpty) {
    const TemporaryFolder folder;
    const auto bed = folder.file("bed.csv", "step,time,wavelength,mean\n0,0,7,1\n");
    const auto pile = folder.file("pile.csv", "step,time,mean,grains\n0,5,2,\n3,8,3,30\n");
    write_table(folder / "all.csv", {"run"}, {{{"1"}, bed}, {{"2"}, pile}, {{"3"}, bed}});
    EXPECT_EQ(bytes_of(folder / "all.csv"),
              "run,step,time,wavelength,mean,grains\n1,0,0,7,1,\n2,0,5,,2,\n2,3,8,,3,30\n"
              "3,0,0,7,1,\n");
}

TEST(SweepTable, AHeaderThatIsAnEmptyLineIsAColumnWithoutAName) {
    const TemporaryFolder folder;
    const auto damaged = folder.file("1.csv", "\n5\n");
    const auto whole = folder.file("2.csv", "step,mean\n0,1\n");
    write_table(folder / "all.csv", {"run"}, {{{"1"}, damaged}, {{"2"}, whole}});
    EXPECT_EQ(bytes_of(folder / "all.csv"), "run,,step,mean\n1,5,,\n2,,0,1\n");
}

TEST(SweepTable, ALineWithOtherCellsThanItsHeaderIsRefused) {
    const TemporaryFolder folder;
    for (const char* rows : {"0\n", "0,1,2\n", "0,1\n\n"}) {
        const auto damaged = folder.file("1.csv", std::string("step,mean\n") + rows);
        EXPECT_EQ(message_of<Error>([&] {
                      write_table(folder / "all.csv", {"run"}, {{{"1"}, damaged}});
                  }),
                  "cannot read " + damaged.string() +
                      ": it has a line with more or fewer cells than its header");
        EXPECT_FALSE(std::filesystem::exists(folder / "all.csv"));
    }
}

TEST(SweepTable, WithoutRunsIsItsNames) {
    const TemporaryFolder folder;
    write_table(folder / "all.csv", {"run", "seed"}, {});
    EXPECT_EQ(bytes_of(folder / "all.csv"), "run,seed\n");
}

TEST(SweepTable, AMissingFileIsAnErrorAndMakesNoTable) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_table(folder / "all.csv", {"run"}, {{{"1"}, folder / "gone.csv"}}), Error);
    EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace fumon::test
