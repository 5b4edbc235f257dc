// Maps of other models that are shown by their own names, and records that share a chunk.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/snapshots/ground_range.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/foreign_layouts.h"
#include "foreign/open_run.h"
#include "foreign/records_ahead.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

class ForeignScalars : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path path = folder / "run.nc";

    [[nodiscard]] ForeignRun open(const ForeignQuery& query = {}) const {
        return open_foreign_run(path.string(), query);
    }
    [[nodiscard]] static ForeignQuery shown(const std::string& name) {
        ForeignQuery query;
        query.scalars = {name};
        return query;
    }
};

/// A bed that is constant, and `tau` over three records, in the second of which the first cell has
/// none.
void write_stress(const std::filesystem::path& file, double missing_bed = 0.0) {
    const NetcdfMaker maker(file);
    const int time = maker.dimension("time", 3);
    const int y = maker.dimension("y", 3);
    const int x = maker.dimension("x", 4);
    const int t = described(maker, "time", {time}, "s");
    const int bed = described(maker, "zb", {time, y, x}, "m");
    const int tau = described(maker, "tau", {time, y, x}, "Pa");
    maker.text(tau, "long_name", "bed_shear__stress");
    maker.number(tau, "_FillValue", NC_FLOAT, {-999.0});
    maker.number(bed, "_FillValue", NC_FLOAT, {-999.0});
    std::vector<double> heights = numbered(3, 3, 4);
    std::vector<double> stress = numbered(3, 3, 4, 0.5);
    stress[12] = -999.0;
    for (std::size_t i = 12; i < 24 && missing_bed != 0.0; ++i) heights[i] = missing_bed;
    maker.values(t, {3}, {0, 60, 120});
    maker.values(bed, {3, 3, 4}, heights);
    maker.values(tau, {3, 3, 4}, stress);
}

TEST_F(ForeignScalars, AreFieldsByTheirNames) {
    write_stress(path);
    const ForeignRun run = open(shown("tau"));
    const Snapshot second = foreign_snapshot(run, 1);
    const SnapshotField* tau = find_named(second.fields, "tau");
    ASSERT_NE(tau, nullptr);
    EXPECT_EQ(tau->long_name, "bed shear stress");
    EXPECT_EQ(tau->unit, "Pa");
    EXPECT_TRUE(std::isnan(tau->values(0, 0)));
    EXPECT_DOUBLE_EQ(tau->values(3, 2), 123.5);
    EXPECT_EQ(beyond_ground(second), "");
    EXPECT_TRUE(foreign_snapshot(open(), 1).fields.empty());
}

TEST_F(ForeignScalars, OneThatIsNotThereIsOneLine) {
    write_stress(path);
    EXPECT_EQ(message_of<InputError>([&] { (void)open(shown("tua")); }),
              path.string() + ": has no map \"tua\" to colour by; did you mean \"tau\"?");
}

TEST_F(ForeignScalars, ABedThatIsMissingInTheMiddleIsOneLine) {
    write_stress(path, -999.0);
    const ForeignRun run = open();
    EXPECT_NO_THROW((void)foreign_snapshot(run, 0));
    EXPECT_EQ(message_of<InputError>([&] { (void)foreign_snapshot(run, 1); }),
              path.string() + ": record 2 has no bed in any cell; is it cut short?");
}

TEST_F(ForeignScalars, AFileThatGrowsWhileItIsReadIsOneLine) {
    write_stress(path);
    const ForeignRun run = open();
    EXPECT_NO_THROW((void)foreign_snapshot(run, 1));
    const auto size = std::filesystem::file_size(path);
    std::filesystem::resize_file(path, size + 8);
    EXPECT_EQ(message_of<InputError>([&] { (void)foreign_snapshot(run, 2); }),
              path.string() + ": had " + std::to_string(size) +
                  " bytes when it was opened and has " + std::to_string(size + 8) +
                  " now; let its run end, or copy the file and take the copy");
}

/// `depth` over six records of 3 × 4 cells, four of them in a chunk.
void write_chunks(const std::filesystem::path& file, int type) {
    const NetcdfMaker maker(file);
    const std::array over{maker.dimension("time", 6), maker.dimension("y", 3),
                          maker.dimension("x", 4)};
    const int bed = described(maker, "zb", {over[1], over[2]}, "m");
    const int depth = maker.variable("h", type, {over[0], over[1], over[2]});
    constexpr std::array<std::size_t, 3> chunk{4, 3, 4};
    must(nc_def_var_chunking(maker.id(), depth, NC_CHUNKED, chunk.data()));
    maker.values(bed, {3, 4}, std::vector<double>(12, 1.0));
    maker.values(depth, {6, 3, 4}, numbered(6, 3, 4));
}

/// The sums of a variable's records, in this order, and how many of them the library has read.
std::size_t records_read(const std::filesystem::path& file, const std::vector<std::size_t>& order,
                         std::size_t bytes) {
    const NetcdfLock lock;
    const NetcdfInput input(file);
    const int depth = *input.find_variable("h");
    const int records = input.dimensions(depth).front();
    RecordsAhead ahead(bytes);
    for (const std::size_t record : order) {
        std::vector<double> cells(12);
        ahead.read(input, depth, records, std::array<std::size_t, 3>{record, 0, 0},
                   std::array<std::size_t, 3>{1, 3, 4}, cells.data());
        EXPECT_DOUBLE_EQ(cells[0], 100.0 * static_cast<double>(record));
        EXPECT_DOUBLE_EQ(cells[11], 100.0 * static_cast<double>(record) + 23.0);
    }
    return ahead.records_read();
}

TEST_F(ForeignScalars, RecordsOfOneChunkAreReadTogetherWithinABound) {
    for (const int type : {NC_FLOAT, NC_DOUBLE}) {
        write_chunks(path, type);
        const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5};
        const std::size_t record = 12 * (type == NC_FLOAT ? sizeof(float) : sizeof(double));
        EXPECT_EQ(records_read(path, all, 10 * record), 6U);
        EXPECT_EQ(records_read(path, {0, 1, 0, 3, 2}, 10 * record), 4U);
        EXPECT_EQ(records_read(path, {0, 1, 0, 3, 2}, 2 * record), 5U);  // 0 1, then 3, then 2 3
        EXPECT_EQ(records_read(path, {0, 0}, record), 2U);               // none is kept
    }
    const ForeignRun run = open();
    EXPECT_DOUBLE_EQ((*field_of(foreign_snapshot(run, 5).fields, "water_depth"))(3, 2), 523.0);
}

}  // namespace
}  // namespace fumon::test
