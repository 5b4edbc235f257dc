#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "foreign/calendar.h"
#include "foreign/file_numbers.h"
#include "foreign/open_run.h"
#include "foreign/run_times.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

std::string grid(double height) {
    return fmt::format(
        "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\nNODATA_value -9\n"
        "{} {}\n{} -9\n",
        height, height + 1, height + 2);
}

/// Names of files as CAESAR-Lisflood has them, with minutes: elev_720.asc, waterdepth720.txt.
class RasterSeries : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    void SetUp() override {
        for (const int minutes : {0, 720, 10080}) {
            folder.file(fmt::format("elev_{}.asc", minutes), grid(10 + minutes));
            folder.file(fmt::format("waterdepth{}.txt", minutes), grid(0.5 + minutes));
        }
    }
    [[nodiscard]] std::string at(const std::string& name) const { return (folder / name).string(); }
};

TEST_F(RasterSeries, IsOrderedByTheNumbersInItsNames) {
    const ForeignRun run = open_foreign_run(at("elev_*.asc"), {.time_unit = "min"});
    ASSERT_EQ(run.times.times.size(), 3U);
    EXPECT_EQ(run.times.unit, "d");
    EXPECT_DOUBLE_EQ(run.times.times[1], 0.5);
    EXPECT_DOUBLE_EQ(run.times.times[2], 7.0);
    const Snapshot last = foreign_snapshot(run, 2);
    EXPECT_DOUBLE_EQ(last.bed(0, 1), 10090.0);
    EXPECT_DOUBLE_EQ(last.bed(0, 0), 10092.0);
    EXPECT_EQ(last.nodata(1, 0), 1);
    EXPECT_DOUBLE_EQ(last.scale.dx, 5.0);
}

TEST_F(RasterSeries, BedsAndDepthsArePairedByNumber) {
    folder.file("waterdepth99.txt", grid(3));
    const ForeignRun run =
        open_foreign_run(at("elev_*.asc"), {.fields = {"depth=" + at("waterdepth*.txt")}});
    const Snapshot middle = foreign_snapshot(run, 1);
    const Grid& depth = *field_of(middle.fields, "water_depth");
    EXPECT_DOUBLE_EQ(depth(0, 1), 720.5);
    EXPECT_DOUBLE_EQ(depth(1, 1), 721.5);
    EXPECT_DOUBLE_EQ(depth(1, 0), 0.0);
    std::filesystem::remove(folder / "waterdepth720.txt");
    EXPECT_EQ(message_of<InputError>([&] {
                  (void)open_foreign_run(at("elev_*.asc"),
                                         {.fields = {"depth=" + at("waterdepth*.txt")}});
              }),
              at("waterdepth*.txt") + ": no file has the number or date of " + at("elev_720.asc"));
}

TEST_F(RasterSeries, DepthsAloneNeedABed) {
    EXPECT_EQ(message_of<InputError>([&] { (void)open_foreign_run(at("waterdepth*.txt")); }),
              at("waterdepth*.txt") +
                  ": holds water depths and no bed; name one by --field "
                  "bed=FILE");
    const ForeignRun run =
        open_foreign_run(at("waterdepth*.txt"), {.fields = {"bed=" + at("elev_0.asc")}});
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 1).bed(0, 1), 10.0);
}

TEST_F(RasterSeries, DatesInNamesAreTimes) {
    folder.file("survey-01-03-2019.asc", grid(1));
    folder.file("survey-31-12-2018.asc", grid(2));
    const ForeignRun run = open_foreign_run(at("survey-*.asc"), {.time_pattern = "%d-%m-%Y"});
    EXPECT_EQ(run.times.date(run.times.times[0]), "2018-12-31");
    EXPECT_EQ(run.times.date(run.times.times[1]), "2019-03-01");
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 0).bed(0, 1), 2.0);
    EXPECT_NE(message_of<InputError>([&] {
                  (void)open_foreign_run(at("elev_*.asc"), {.time_pattern = "%Y-%m-%d"});
              }).find("its name has no date of the pattern \"%Y-%m-%d\""),
              std::string::npos);
}

TEST_F(RasterSeries, DatesWithoutAPatternAreNotOrderedByTheirDays) {
    folder.file("survey-2018-12-31.asc", grid(1));
    folder.file("survey-2019-03-01.asc", grid(2));
    EXPECT_NE(message_of<InputError>([&] {
                  (void)open_foreign_run(at("survey-*.asc"));
              }).find("no one of them orders the files; of dates, --time-pattern"),
              std::string::npos);
}

TEST_F(RasterSeries, MatricesWithoutAHeaderHaveTheirFirstRowInTheNorth) {
    folder.file("h.100.dat", "1 2 3\n4 5 6\n");
    folder.file("h.200.dat", "7 8 9\n10 11 12\n");
    const ForeignRun run = open_foreign_run(at("h.*.dat"), {.cell_size = 2.0});
    EXPECT_EQ(run.nx, 3);
    EXPECT_EQ(run.ny, 2);
    EXPECT_DOUBLE_EQ(run.scale.dx, 2.0);
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 1).bed(0, 0), 10.0);
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 1).bed(2, 1), 9.0);
    folder.file("h.200.dat", "7 8 9\n10 11\n");
    EXPECT_EQ(message_of<InputError>([&] { (void)foreign_snapshot(run, 1); }),
              at("h.200.dat") + ":2: the line has 2 numbers, those before it 3");
}

TEST_F(RasterSeries, GridsMustNotDiffer) {
    folder.file("elev_720.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 5\n3\n");
    const ForeignRun run = open_foreign_run(at("elev_*.asc"));
    EXPECT_NE(message_of<InputError>([&] {
                  (void)foreign_snapshot(run, 1);
              }).find("has 1 x 1 cells, the bed 2 x 2; all fields of a run need the same grid"),
              std::string::npos);
}

TEST(Calendar, DatesGoBothWays) {
    const auto kinds = {CalendarKind::gregorian, CalendarKind::years_of_365_days,
                        CalendarKind::years_of_360_days};
    for (const CalendarKind kind : kinds) {
        for (const std::int64_t day : {-800'000, -1, 0, 59, 60, 18'321, 40'000}) {
            const std::int64_t seconds = day * 86'400 + 5;
            EXPECT_EQ(seconds_of(date_of(seconds, kind), kind), seconds);
        }
    }
    EXPECT_EQ(seconds_of(*parse_date("2000-03-01"), CalendarKind::gregorian), 951'868'800);
    EXPECT_EQ(seconds_of(*parse_date("1970-01-01T02:00:00 +02:00"), CalendarKind::gregorian), 0);
    EXPECT_EQ(seconds_of(*parse_date("1970-1-1 0:0:30.5 -0030"), CalendarKind::gregorian), 1'830);
    EXPECT_FALSE(parse_date("00:00:00 UTC"));
    EXPECT_EQ(date_text(date_of(86'400 * 59, CalendarKind::years_of_360_days), DateText::days),
              "1970-02-30");
    EXPECT_EQ(find_date("run_20190831_1400.tif", "%Y%m%d_%H%M"), 1'567'260'000);
    EXPECT_FALSE(find_date("run_2019.tif", "%Y%m%d"));
}

TEST(Calendar, DatesOfLongRunsAreExact) {
    RawTimes raw;
    raw.values = {0.0, 12'729 * 86'400.0};
    raw.origin = seconds_of(*parse_date("1900-01-01"), CalendarKind::gregorian);
    const ForeignTimes times = run_times(raw, "run");
    EXPECT_EQ(times.date(times.times[1]), "1934-11-08");
}

TEST(Calendar, StandardDatesBefore1582AreJulian) {
    const DateTime first = *parse_date("1-1-1 00:00:00");
    const std::int64_t origin =
        seconds_of(first, CalendarKind::gregorian) + seconds_to_julian(first);
    EXPECT_EQ(date_text(date_of(origin + 17'522'904 * std::int64_t{3'600}, CalendarKind::gregorian),
                        DateText::days),
              "2000-01-01");
    EXPECT_EQ(seconds_to_julian(*parse_date("1582-10-15")), 0);
}

}  // namespace
}  // namespace fumon::test
