#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "foreign/foreign_layouts.h"
#include "foreign/open_run.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

class ForeignNetcdf : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path path = folder / "run.nc";

    [[nodiscard]] ForeignRun open(const ForeignQuery& query = {}) const {
        return open_foreign_run(path.string(), query);
    }
    [[nodiscard]] std::string refusal(const ForeignQuery& query = {}) const {
        return message_of<InputError>([&] {
            const ForeignRun run = open(query);
            for (std::size_t i = 0; i < run.times.times.size(); ++i) (void)foreign_snapshot(run, i);
        });
    }
};

double depth(const Snapshot& snapshot, int x, int y) {
    return (*field_of(snapshot.fields, "water_depth"))(x, y);
}

TEST_F(ForeignNetcdf, SfincsIsKnownWithoutOptions) {
    write_sfincs(path);
    const ForeignRun run = open();
    EXPECT_EQ(run.model, "SFINCS");
    EXPECT_EQ(run.find(Quantity::bed)->name, "zb");
    EXPECT_EQ(run.find(Quantity::level)->name, "zs");
    EXPECT_EQ(run.find(Quantity::depth), nullptr);  // hmax is over another time
    ASSERT_EQ(run.times.times.size(), 3U);
    EXPECT_EQ(run.times.date(run.times.times[1]), "2019-08-31 14:30 UTC");
    EXPECT_DOUBLE_EQ(run.scale.dx, 10.0);
    ASSERT_TRUE(run.scale.place);
    EXPECT_DOUBLE_EQ(run.scale.place->west, 495.0);
    EXPECT_DOUBLE_EQ(run.scale.place->south, 895.0);
    const Snapshot last = foreign_snapshot(run, 2);
    EXPECT_DOUBLE_EQ(last.bed(1, 2), 21.0);
    EXPECT_DOUBLE_EQ(depth(last, 3, 0), 4.0);
    EXPECT_DOUBLE_EQ(depth(last, 3, 2), 4.0);
    EXPECT_DOUBLE_EQ(depth(last, 2, 1), 0.0);
    EXPECT_DOUBLE_EQ((*field_of(last.fields, "velocity_x"))(3, 1), 0.5);
    EXPECT_DOUBLE_EQ((*field_of(last.fields, "velocity_x"))(2, 1), 0.0);
}

TEST_F(ForeignNetcdf, ATurnedGridIsDrawnAlongItsSides) {
    write_sfincs(path, 0.8, 0.6);
    const ForeignRun run = open();
    EXPECT_DOUBLE_EQ(run.scale.dx, 10.0);
    EXPECT_FALSE(run.scale.place);
    ASSERT_FALSE(run.notes.empty());
    EXPECT_NE(run.notes.front().find("turned by 36.9 degrees"), std::string::npos);
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 0).bed(3, 1), 13.0);
}

TEST_F(ForeignNetcdf, VelocitiesByCompassAreTurnedWithTheGrid) {
    write_sfincs(path, 0.8, 0.6);
    {
        int file = 0;
        must(nc_open(path.c_str(), NC_WRITE, &file));
        int time = 0;
        int n = 0;
        int m = 0;
        must(nc_inq_dimid(file, "time", &time));
        must(nc_inq_dimid(file, "n", &n));
        must(nc_inq_dimid(file, "m", &m));
        must(nc_redef(file));
        const std::array over{time, n, m};
        const std::string name = "northward_sea_water_velocity";
        int v = 0;
        must(nc_def_var(file, "v", NC_FLOAT, 3, over.data(), &v));
        must(nc_put_att_text(file, v, "standard_name", name.size(), name.c_str()));
        int u = 0;
        must(nc_inq_varid(file, "u", &u));
        const std::string east = "eastward_sea_water_velocity";
        must(nc_put_att_text(file, u, "standard_name", east.size(), east.c_str()));
        must(nc_enddef(file));
        const std::vector<double> still(36, 1.0);
        must(nc_put_var_double(file, v, still.data()));
        must(nc_close(file));
    }
    const Snapshot last = foreign_snapshot(open(), 2);
    EXPECT_NEAR((*field_of(last.fields, "velocity_x"))(3, 1), 0.8 * 0.5 + 0.6 * 1.0, 1e-6);
    EXPECT_NEAR((*field_of(last.fields, "velocity_y"))(3, 1), 0.8 * 1.0 - 0.6 * 0.5, 1e-6);
}

TEST_F(ForeignNetcdf, VelocitiesAlongTheFilesColumnsStaySoOnAGridTurnedFar) {
    write_sfincs(path, 0.5, std::sqrt(0.75));  // 60 degrees: its rows are drawn as columns
    const ForeignRun run = open();
    ASSERT_EQ(run.nx, 3);
    const Snapshot last = foreign_snapshot(run, 2);
    EXPECT_GT((*field_of(last.fields, "water_depth"))(1, 3), 0.0);
    EXPECT_NEAR((*field_of(last.fields, "velocity_y"))(1, 3), 0.5, 1e-6);
    EXPECT_NEAR((*field_of(last.fields, "velocity_x"))(1, 3), 0.0, 1e-6);
}

TEST_F(ForeignNetcdf, VelocitiesAgainstTheDrawnColumnsChangeTheirSign) {
    write_sfincs(path, -0.8, 0.6);  // 143 degrees
    const Snapshot last = foreign_snapshot(open(), 2);
    EXPECT_NEAR((*field_of(last.fields, "velocity_x"))(0, 1), -0.5, 1e-6);
}

TEST_F(ForeignNetcdf, HeightsOfMinus9999AreNone) {
    {
        const NetcdfMaker maker(path);
        const int time = maker.dimension("time", 1);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        const int bed = described(maker, "topographic__elevation", {time, y, x}, "m");
        std::vector<double> heights = numbered(1, 3, 4);
        heights.back() = -9999.0;
        maker.values(bed, {1, 3, 4}, heights);
    }
    const Snapshot first = foreign_snapshot(open(), 0);
    ASSERT_FALSE(first.nodata.empty());
    EXPECT_EQ(first.nodata(3, 2), 1);
    EXPECT_EQ(first.nodata(2, 2), 0);
}

TEST_F(ForeignNetcdf, TimesWithoutAUnitTakeOneThatIsSaid) {
    {
        const NetcdfMaker maker(path);
        const int nt = maker.dimension("nt", 2);
        const int nj = maker.dimension("nj", 3);
        const int ni = maker.dimension("ni", 4);
        const int t = maker.variable("t", NC_DOUBLE, {nt});  // as write_netcdf(append=True)
        const int z = described(maker, "topographic__elevation", {nt, nj, ni}, "");
        maker.values(t, {2}, {400, 800});
        maker.values(z, {2, 3, 4}, numbered(2, 3, 4));
    }
    EXPECT_EQ(open().times.unit, "steps");
    ForeignQuery query;
    query.time_unit = "yr";
    EXPECT_EQ(open(query).times.unit, "yr");
    EXPECT_DOUBLE_EQ(open(query).times.times[1], 800.0);
}

TEST_F(ForeignNetcdf, FilesThatBeginTogetherAreNotOneRun) {
    write_aeolis(folder / "out_1.nc");
    write_aeolis(folder / "out_2.nc");
    const std::string message =
        message_of<InputError>([&] { (void)open_foreign_run((folder / "out_*.nc").string()); });
    EXPECT_NE(message.find("out_2.nc: begins at the time at which"), std::string::npos) << message;
    EXPECT_NE(message_of<InputError>([&] {
                  (void)open_foreign_run((folder.path() / "*" / "out.nc").string());
              }).find("not of a folder's"),
              std::string::npos);
}

TEST_F(ForeignNetcdf, LandlabIsKnownWithoutOptions) {
    write_landlab(path);
    const ForeignRun run = open();
    EXPECT_EQ(run.model, "Landlab");
    EXPECT_EQ(run.find(Quantity::bed)->name, "topographic__elevation");
    EXPECT_EQ(run.times.unit, "h");
    EXPECT_DOUBLE_EQ(run.times.times[1], 12.0);
    EXPECT_FALSE(run.times.date);
    EXPECT_DOUBLE_EQ(run.scale.dx, 5.0);
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_DOUBLE_EQ(last.bed(3, 2), 123.0);
    EXPECT_DOUBLE_EQ(depth(last, 0, 0), 100.5);
    EXPECT_DOUBLE_EQ(depth(last, 3, 0), 103.5);
    EXPECT_DOUBLE_EQ(depth(last, 0, 2), 120.5);
}

TEST_F(ForeignNetcdf, RowsThatRunSouthAreTurnedUp) {
    write_xbeach(path);
    const ForeignRun run = open();
    EXPECT_EQ(run.model, "XBeach");
    EXPECT_EQ(run.times.unit, "min");
    EXPECT_DOUBLE_EQ(run.times.times[1], 60.0);
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_DOUBLE_EQ(last.bed(0, 0), 120.0);
    EXPECT_DOUBLE_EQ(last.bed(1, 2), 101.0);
    EXPECT_DOUBLE_EQ(depth(last, 2, 1), 1.5);
    EXPECT_DOUBLE_EQ((*field_of(last.fields, "velocity_x"))(0, 0), 0.25);
}

TEST_F(ForeignNetcdf, UnevenColumnsAreLaidOnEvenCells) {
    write_xbeach(path, {0, 4, 6, 7});
    const ForeignRun run = open();
    EXPECT_EQ(run.nx, 8);
    EXPECT_EQ(run.ny, 3);
    EXPECT_DOUBLE_EQ(run.scale.dx, 1.0);
    EXPECT_DOUBLE_EQ(run.scale.dy, 2.0);
    const Snapshot first = foreign_snapshot(run, 0);
    EXPECT_DOUBLE_EQ(first.bed(0, 2), 0.0);
    EXPECT_DOUBLE_EQ(first.bed(2, 2), 0.5);
    EXPECT_DOUBLE_EQ(first.bed(5, 0), 21.5);
    EXPECT_DOUBLE_EQ(first.bed(7, 1), 13.0);
    EXPECT_DOUBLE_EQ(depth(first, 3, 1), 1.5);
}

TEST_F(ForeignNetcdf, ABedIsTheLevelWithoutTheDepth) {
    write_geoclaw(path);
    const ForeignRun run = open();
    EXPECT_EQ(run.model, "GeoClaw");
    EXPECT_NEAR(run.scale.dy, 111.13, 0.2);
    EXPECT_NEAR(run.scale.dx, 78.8, 0.3);
    const Snapshot last = foreign_snapshot(run, 1);
    EXPECT_DOUBLE_EQ(last.bed(1, 2), 119.0);
    EXPECT_DOUBLE_EQ(depth(last, 1, 2), 2.0);
    EXPECT_DOUBLE_EQ((*field_of(last.fields, "velocity_x"))(1, 2), 1.5);
}

TEST_F(ForeignNetcdf, AeolisIsABedThatChanges) {
    write_aeolis(path);
    const ForeignRun run = open();
    EXPECT_FALSE(run.has_water());
    EXPECT_EQ(run.find(Quantity::velocity_x), nullptr);  // its u is of sand
    EXPECT_EQ(run.times.date(run.times.times[1]), "2015-01-02");
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 1).bed(3, 2), 123.0);
    const std::string text = foreign_description(run);
    EXPECT_NE(
        text.find("bed        zb (time, n, s): bed, by a name of AeoLiS; in \"m\"; 0 to 123 m; "
                  "changes"),
        std::string::npos)
        << text;
}

TEST_F(ForeignNetcdf, FilesOfOneRunFollowOneAnotherByTheirTimes) {
    write_aeolis(folder / "out_9.nc", {0, 86400});
    write_aeolis(folder / "out_10.nc", {172800, 259200});
    const ForeignRun run = open_foreign_run((folder / "out_*.nc").string());
    ASSERT_EQ(run.times.times.size(), 4U);
    EXPECT_EQ(run.times.date(run.times.times[3]), "2015-01-04");
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 0).bed(0, 0), 0.0);
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 3).bed(0, 0), 100.0);
}

TEST_F(ForeignNetcdf, AFieldMayBeNamedOrOfAnotherFile) {
    write_sfincs(path);
    EXPECT_EQ(open({.fields = {"depth=hmax"}}).find(Quantity::depth)->reason, "--field");
    folder.file("dem.asc",
                "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n7 7 7 7\n7 7 7 7\n5 6 7 "
                "8\n");
    const ForeignRun run = open({.fields = {"bed=" + (folder / "dem.asc").string()}});
    EXPECT_DOUBLE_EQ(foreign_snapshot(run, 0).bed(1, 0), 6.0);
    EXPECT_NE(refusal({.fields = {"depth=hmx"}})
                  .find("has no map \"hmx\" to be its water depth; "
                        "did you mean \"hmax\"?"),
              std::string::npos);
    EXPECT_NE(refusal({.fields = {"wetness=h"}}).find("QUANTITY is one of bed, depth"),
              std::string::npos);
}

TEST_F(ForeignNetcdf, AFieldOfAnotherFileIsInItsUnit) {
    write_sfincs(path);
    const std::filesystem::path other = folder / "depth.nc";
    const auto write = [&](const char* unit) {
        const NetcdfMaker maker(other);
        const int n = maker.dimension("y", 3);
        const int m = maker.dimension("x", 4);
        const int depth = described(maker, "h", {n, m}, unit);
        maker.values(depth, {3, 4}, std::vector<double>(12, 250.0));
    };
    write("cm");
    const ForeignRun run = open({.fields = {"depth=" + other.string() + ":h"}});
    EXPECT_NEAR(run.find(Quantity::depth)->read(0)(1, 1), 2.5, 1e-12);
    write("kg");
    EXPECT_NE(refusal({.fields = {"depth=" + other.string() + ":h"}}).find("\"kg\""),
              std::string::npos);
}

TEST_F(ForeignNetcdf, TimesMustRise) {
    write_aeolis(path, {0, 86400, 3600});
    EXPECT_EQ(refusal(), path.string() +
                             ": the time of record 3, 3600, does not come after that of record 2, "
                             "86400; put the records into the order of their times");
    write_aeolis(path, {0, NC_FILL_FLOAT, 3600});
    EXPECT_EQ(refusal(), path.string() + ": record 2 has no time; write one for every record");
}

TEST_F(ForeignNetcdf, StepsOfAnotherLengthAreNotThoseOfItsRecords) {
    {
        const NetcdfMaker maker(path);
        const int time = maker.dimension("time", 2);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        const int many = maker.dimension("many", 20'000);
        const int t = described(maker, "time", {time}, "s");
        const int bed = described(maker, "bed_height", {time, y, x}, "m");
        const int step = maker.variable("step", NC_INT, {many});
        maker.values(t, {2}, {0, 60});
        maker.values(bed, {2, 3, 4}, numbered(2, 3, 4));
        maker.values(step, {20'000}, std::vector<double>(20'000, 7.0));
    }
    EXPECT_EQ(open().times.steps, (std::vector<std::int64_t>{0, 1}));
}

TEST_F(ForeignNetcdf, UndeclaredFillValuesAreNamed) {
    {
        const NetcdfMaker maker(path);
        const int time = maker.dimension("time", 2);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        const int bed = described(maker, "zb", {time, y, x}, "m");
        std::vector<double> heights = numbered(2, 3, 4);
        heights.back() = 1e20;
        maker.values(bed, {2, 3, 4}, heights);
    }
    EXPECT_NE(refusal().find("record 2: the height of cell"), std::string::npos) << refusal();
}

TEST_F(ForeignNetcdf, UnitsMustFit) {
    write_aeolis(path, {0, 86400}, "kg");
    EXPECT_EQ(refusal(), path.string() +
                             ": zb is in \"kg\", and cannot be its bed; a bed becomes m; name "
                             "another by --field bed=NAME");
}

TEST_F(ForeignNetcdf, TwoMapsOfOneStandardNameAreNotGuessed) {
    {
        const NetcdfMaker maker(path);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        (void)described(maker, "old", {y, x}, "m", "surface_altitude");
        (void)described(maker, "new", {y, x}, "m", "surface_altitude");
    }
    EXPECT_EQ(refusal(), path.string() +
                             ": 2 maps have the standard name of its bed: old (y, x), new (y, x); "
                             "name one by --field bed=old");
}

TEST_F(ForeignNetcdf, WithoutABedItListsWhatThereIs) {
    {
        const NetcdfMaker maker(path);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        (void)described(maker, "alpha", {y, x}, "K");
        (void)described(maker, "beta", {y, x}, "K");
    }
    EXPECT_EQ(refusal(), path.string() +
                             ": no map is known as its bed; name it by --field bed=NAME, or "
                             "bed=FILE of another; it has alpha (y, x), beta (y, x)");
}

TEST_F(ForeignNetcdf, FieldsNeedTheSameGrid) {
    {
        const NetcdfMaker maker(path);
        const int y = maker.dimension("y", 3);
        const int x = maker.dimension("x", 4);
        const int wide = maker.dimension("wide", 5);
        const int zb = described(maker, "zb", {y, x}, "m");
        (void)described(maker, "h", {y, wide}, "m");
        maker.values(zb, {3, 4}, numbered(1, 3, 4));
    }
    EXPECT_NE(refusal().find("zb (y, x) and h (y, wide) lie on different grids"),
              std::string::npos);
}

TEST_F(ForeignNetcdf, ACutFileIsOneLine) {
    write_sfincs(path);
    std::ifstream whole(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(whole)), {});
    folder.file("run.nc", bytes.substr(0, bytes.size() / 2));
    const std::string message = refusal();
    EXPECT_NE(message.find("cannot be read as NetCDF"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST_F(ForeignNetcdf, OtherFormatsNameTheWayIn) {
    const std::string vtk = folder.file("run.vtu", "<VTKFile>").string();
    EXPECT_NE(message_of<InputError>([&] { (void)open_foreign_run(vtk); }).find("is VTK"),
              std::string::npos);
    EXPECT_NE(message_of<InputError>([&] {
                  (void)open_foreign_run("https://a.org/run.nc");
              }).find("addresses are not read"),
              std::string::npos);
}

}  // namespace
}  // namespace fumon::test
