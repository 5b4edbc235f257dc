// What a checker of the CF conventions 1.8 and VTK's reader look at, in files of every kind of
// scale; checksums; and files of earlier versions.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <fstream>
#include <string>

#include "base/error.h"
#include "files/netcdf/netcdf_definition.h"
#include "files/netcdf/netcdf_fields.h"
#include "files/netcdf/netcdf_record.h"
#include "support/command.h"
#include "support/netcdf_file.h"
#include "support/netcdf_records.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::fields_text;
using test::message_of;
using test::NetcdfContent;
using test::snapshot;
using test::TemporaryFolder;

void write(const std::filesystem::path& path, const Snapshot& first) {
    FieldsFile file(path, first, fields_text);
    file.add(first);
    file.commit();
}

Snapshot at_time(const std::string& unit, double time) {
    Snapshot first = snapshot(3);
    first.time_unit = unit;
    first.time = time;
    return first;
}

TEST(NetcdfConventions, ARecordHasADateAndTheModelsTime) {
    struct Expected {
        const char* unit;
        const char* date_unit;
        const char* time_unit;
        double date;
    };
    for (const auto& [unit, date_unit, time_unit, date] :
         {Expected{"s", "seconds since 2000-01-01 00:00:00", "s", 2.0},
          Expected{"steps", "seconds since 2000-01-01 00:00:00", "1", 2.0},
          Expected{"grains", "seconds since 2000-01-01 00:00:00", "1", 2.0},
          Expected{"h", "hours since 2000-01-01 00:00:00", "h", 2.0},
          Expected{"yr", "days since 2000-01-01 00:00:00", "yr", 730.484397562}}) {
        const TemporaryFolder folder;
        write(folder / "fields.nc", at_time(unit, 2.0));
        const NetcdfContent content(folder / "fields.nc");
        EXPECT_EQ(content.text("date", "units"), date_unit) << unit;
        EXPECT_EQ(content.text("date", "calendar"), "standard");
        EXPECT_EQ(content.text("date", "standard_name"), "time");
        EXPECT_EQ(content.text("date", "axis"), "T");
        EXPECT_DOUBLE_EQ(content.values("date").front(), date) << unit;
        EXPECT_EQ(content.text("time", "units"), time_unit);
        EXPECT_EQ(content.text("time", "axis"), "") << "no second time coordinate";
        EXPECT_EQ(content.values("time").front(), 2.0);
    }
}

TEST(NetcdfConventions, NoIntegerIsWiderThan32Bits) {
    const TemporaryFolder folder;
    Snapshot late = snapshot(0);
    late.step = (std::int64_t{1} << 52) + 1;
    FieldsText text = fields_text;
    text.seed = std::int64_t{1} << 40;
    FieldsFile file(folder / "fields.nc", late, text);
    file.add(late);
    file.commit();
    int id = 0;
    test::must(nc_open((folder / "fields.nc").c_str(), NC_NOWRITE, &id));
    int variables = 0;
    test::must(nc_inq_nvars(id, &variables));
    for (int variable = 0; variable < variables; ++variable) {
        int type = 0;
        test::must(nc_inq_vartype(id, variable, &type));
        EXPECT_TRUE(type == NC_DOUBLE || type == NC_INT) << variable;
    }
    nc_close(id);
    EXPECT_EQ(read_fields_moments(folder / "fields.nc").front().step, late.step);
    EXPECT_EQ(NetcdfContent(folder / "fields.nc").text("", "seed"), "1099511627776");
}

/// GDAL finds a crs_wkt by grid_mapping alone.
TEST(NetcdfConventions, AGridMappingHasItsNameAndParametersWhereCfKnowsThem) {
    const TemporaryFolder folder;
    const auto written = [&](const std::string& crs) {
        Snapshot first = snapshot(0);
        first.scale.place = {500000.0, 4400000.0, 2.0, 3.0, false, crs};
        write(folder / "fields.nc", first);
        return NetcdfContent(folder / "fields.nc");
    };
    const std::string utm =
        R"(PROJCS["UTM",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
        R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],)"
        R"(PROJECTION["Transverse_Mercator"],PARAMETER["central_meridian",-105],)"
        R"(PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],UNIT["metre",1]])";
    const NetcdfContent known = written(utm);
    EXPECT_EQ(known.text("bed_height", "grid_mapping"), "crs");
    EXPECT_EQ(known.text("crs", "grid_mapping_name"), "transverse_mercator");
    EXPECT_EQ(known.number("crs", "longitude_of_central_meridian"), -105.0);
    EXPECT_EQ(known.number("crs", "inverse_flattening"), 298.257223563);
    EXPECT_EQ(known.text("crs", "crs_wkt"), utm);
    const NetcdfContent unknown = written("PROJCRS[\"a\"]");
    EXPECT_EQ(unknown.text("bed_height", "grid_mapping"), "crs");
    EXPECT_EQ(unknown.text("water_depth", "grid_mapping"), "crs");
    EXPECT_EQ(unknown.text("crs", "crs_wkt"), "PROJCRS[\"a\"]");
    EXPECT_EQ(unknown.text("crs", "grid_mapping_name"), "");
}

TEST(NetcdfConventions, CoordinatesAreInTheUnitOfTheirSystem) {
    struct Expected {
        const char* in_wkt;
        const char* units;
        double first_x;
    };
    for (const auto& [in_wkt, units, first_x] :
         {Expected{"\"US survey foot\",0.304800609601219", "US_survey_foot", 6000005.0},
          Expected{"\"foot\",0.3048", "foot", 6000005.0},
          Expected{"\"kilometre\",1000", "km", 6000005.0}, Expected{"\"metre\",1", "m", 6000005.0},
          Expected{"\"link\",0.201168", "m", 1.0}}) {
        const TemporaryFolder folder;
        Snapshot first = snapshot(0);
        const std::string crs = std::string("PROJCS[\"a\",UNIT[") + in_wkt + "]]";
        first.scale.place = {6000000.0, 1800000.0, 10.0, 20.0, false, crs};
        write(folder / "fields.nc", first);
        const NetcdfContent content(folder / "fields.nc");
        EXPECT_EQ(content.text("x", "units"), units);
        EXPECT_EQ(content.text("y", "units"), units);
        EXPECT_EQ(content.text("x", "standard_name"), "projection_x_coordinate");
        EXPECT_EQ(content.values("x").front(), first_x) << in_wkt;
        const bool lies = first_x > 1.0;
        EXPECT_EQ(content.text("bed_height", "grid_mapping"), lies ? "crs" : "") << in_wkt;
    }
}

TEST(NetcdfConventions, FalseEastingsAreInTheUnitOfTheCoordinates) {
    const TemporaryFolder folder;
    Snapshot first = snapshot(0);
    first.scale.place = {6000000.0,
                         1800000.0,
                         10.0,
                         20.0,
                         false,
                         R"(PROJCS["a",GEOGCS["b",DATUM["c",SPHEROID["d",6378137,298.25]],)"
                         R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],)"
                         R"(PROJECTION["Transverse_Mercator"],PARAMETER["central_meridian",-105],)"
                         R"(PARAMETER["false_easting",500000],UNIT["foot",0.3048]])"};
    write(folder / "fields.nc", first);
    EXPECT_NEAR(NetcdfContent(folder / "fields.nc").number("crs", "false_easting"), 500000.0, 1e-6)
        << "feet";
}

/// What GDAL reads of files whose system CF has no name for, or that count feet.
TEST(NetcdfConventions, GdalPlacesEverySystem) {
    if (std::system("command -v gdalinfo gdalsrsinfo > /dev/null") != 0)
        GTEST_SKIP() << "no gdalinfo here";
    for (const char* code : {"EPSG:5514", "EPSG:2056", "EPSG:28992", "EPSG:2229", "EPSG:2264"}) {
        const TemporaryFolder folder;
        std::string crs =
            test::run_command(std::string("gdalsrsinfo --single-line -o wkt2_2019 ") + code).words;
        while (!crs.empty() && (crs.back() == '\n' || crs.back() == ' ')) crs.pop_back();
        Snapshot first = snapshot(0);
        first.scale.place = {600000.0, 200000.0, 10.0, 20.0, false, crs};
        write(folder / "fields.nc", first);
        const std::string said =
            test::run_command("gdalinfo NETCDF:" + (folder / "fields.nc").string() +
                              ":bed_height 2>&1 | grep -v '#'")
                .words;
        const std::string epsg = std::string(code).substr(5);
        EXPECT_NE(said.find("ID[\"EPSG\"," + epsg + "]]"), std::string::npos) << code << said;
        EXPECT_NE(said.find("Origin = (600000.0"), std::string::npos) << code << said;
        EXPECT_NE(said.find("Pixel Size = (10.0"), std::string::npos) << code << said;
    }
}

TEST(NetcdfConventions, UdunitsKnowsEveryUnitThatModelsGive) {
    if (std::system("command -v udunits2 > /dev/null") != 0) GTEST_SKIP() << "no udunits2 here";
    for (const char* unit :
         {"steps", "sites", "heights", "grains", "per mm", "deg", "degrees", "m", "m/s", "Pa",
          "s-1", "m3", "m2/yr", "m3/s", "yr", "1", "mm/h", "mm", "m2"}) {
        const std::string in_file = unit_in_file(unit);
        const auto spoken =
            test::run_command("udunits2 -H '" + in_file + "' -W '" + in_file + "' 2>&1");
        EXPECT_EQ(spoken.words.find("Don't recognize"), std::string::npos) << unit;
        EXPECT_NE(spoken.words.find("1 "), std::string::npos) << unit << spoken.words;
    }
}

/// Where a file's compressed pieces begin: zlib streams of its level.
std::vector<std::size_t> compressed_pieces(const std::string& bytes) {
    std::vector<std::size_t> places;
    for (std::size_t at = 0; (at = bytes.find("\x78\x01", at)) != std::string::npos; ++at)
        places.push_back(at);
    return places;
}

/// Its headers are left alone: HDF5 frees what a damaged one points at.
TEST(NetcdfConventions, ADamagedRecordIsReportedAndNotReadAsSound) {
    const TemporaryFolder folder;
    const Snapshot first = snapshot(0, 90, 70);
    constexpr int records = 4;
    std::vector<Snapshot> sound;
    {
        FieldsFile file(folder / "fields.nc", first, fields_text);
        for (int step = 0; step < records; ++step) file.add(snapshot(step, 90, 70));
        file.commit();
    }
    for (int step = 0; step < records; ++step)
        sound.push_back(read_fields_snapshot(folder / "fields.nc", step, first));
    const std::string bytes = bytes_of(folder / "fields.nc");
    const std::vector<std::size_t> pieces = compressed_pieces(bytes);
    ASSERT_GE(pieces.size(), std::size_t{3 * records}) << "a bed and two fields a record";
    int reported = 0;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        std::string damaged = bytes;
        char& byte = damaged.at(pieces[n] + 9 + n);
        byte = static_cast<char>(byte ^ '\x10');
        std::ofstream(folder / "damaged.nc", std::ios::binary) << damaged;
        for (int step = 0; step < records; ++step) {
            try {
                const Snapshot& good = sound[static_cast<std::size_t>(step)];
                const Snapshot read = read_fields_snapshot(folder / "damaged.nc", step, first);
                EXPECT_TRUE(good.bed == read.bed && good.time == read.time &&
                            good.fields[0].values == read.fields[0].values &&
                            good.fields[1].values == read.fields[1].values)
                    << "piece " << n << " is read as sound in record " << step;
            } catch (const InputError&) {
                ++reported;
            }
        }
    }
    EXPECT_GE(reported, 3 * records);
}

/// A record's numbers lie in the file as they are, so that only their checksum tells of damage.
TEST(NetcdfConventions, ADamagedNumberIsReported) {
    const TemporaryFolder folder;
    Snapshot record = snapshot(0);
    record.time = 1234.567890123;
    {
        FieldsFile file(folder / "fields.nc", record, fields_text);
        file.add(record);
        file.commit();
    }
    std::string bytes = bytes_of(folder / "fields.nc");
    std::string number(sizeof record.time, '\0');
    std::memcpy(number.data(), &record.time, sizeof record.time);
    std::size_t places = 0;
    for (std::size_t at = 0; (at = bytes.find(number, at)) != std::string::npos; at += 8) {
        bytes[at + 3] = static_cast<char>(bytes[at + 3] ^ '\x10');
        ++places;
    }
    ASSERT_GE(places, std::size_t{1});
    std::ofstream(folder / "damaged.nc", std::ios::binary) << bytes;
    const std::string message = message_of<InputError>(
        [&] { (void)read_fields_snapshot(folder / "damaged.nc", 0, record); });
    EXPECT_NE(message.find("checksum"), std::string::npos) << message;
}

/// Two records as fumon 0.2 wrote them: over a dimension `time`, with 64-bit steps and no date.
void write_as_before(const std::filesystem::path& path, const Snapshot& first,
                     const std::vector<Snapshot>& records) {
    const test::NetcdfMaker maker(path);
    const int time = maker.dimension("time", NC_UNLIMITED);
    const int y = maker.dimension("y", static_cast<std::size_t>(first.bed.ny()));
    const int x = maker.dimension("x", static_cast<std::size_t>(first.bed.nx()));
    maker.text(NC_GLOBAL, "source", "fumon 0.2.0");
    const int times = maker.variable("time", NC_DOUBLE, {time});
    const int steps = maker.variable("step", NC_INT64, {time});
    const int bed = maker.variable("bed_height", NC_DOUBLE, {time, y, x});
    const int passes = maker.variable("avalanche_passes", NC_DOUBLE, {time});
    std::vector<double> all_times;
    std::vector<double> all_steps;
    std::vector<double> heights;
    for (const Snapshot& record : records) {
        all_times.push_back(record.time);
        all_steps.push_back(static_cast<double>(record.step));
        for (const double height : record.bed.values())
            heights.push_back(height * record.scale.height_unit);
    }
    maker.values(bed,
                 {records.size(), static_cast<std::size_t>(first.bed.ny()),
                  static_cast<std::size_t>(first.bed.nx())},
                 heights);
    maker.values(times, {records.size()}, all_times);
    maker.values(steps, {records.size()}, all_steps);
    maker.values(passes, {records.size()}, all_steps);
}

Snapshot bare(std::int64_t step) {
    Snapshot made = snapshot(step);
    made.fields.clear();
    made.numbers = {{"avalanche_passes", "1", static_cast<double>(step)}};
    made.nodata = {};
    return made;
}

TEST(NetcdfConventions, AnOlderFileIsReadAndGoneOnWithInOneLayout) {
    const TemporaryFolder folder;
    FieldsBeginning previous;
    {
        FieldsFile file(folder / "new.nc", bare(0), fields_text);
        for (const std::int64_t step : {0, 10}) file.add(bare(step));
        previous = file.sync();
        file.add(bare(20));
        file.commit();
    }
    write_as_before(folder / "old.nc", bare(0), {bare(0), bare(10)});
    EXPECT_EQ(read_fields_moments(folder / "old.nc").back().step, 10);
    EXPECT_EQ(read_fields_snapshot(folder / "old.nc", 10, bare(0)).bed, bare(10).bed);
    EXPECT_EQ(read_fields_snapshot(folder / "old.nc", 10, bare(0)).numbers.at(0).value, 10.0);
    ASSERT_TRUE(read_fields_record(folder / "old.nc"));
    EXPECT_EQ(read_fields_record(folder / "old.nc")->numbers.size(), std::size_t{1});
    EXPECT_EQ(read_fields_record(folder / "new.nc")->numbers.size(), std::size_t{1})
        << "a date is none";
    FieldsFile file(folder / "old.nc", bare(0), fields_text, previous);
    file.add(bare(20));
    file.commit();
    EXPECT_TRUE(bytes_of(folder / "old.nc") == bytes_of(folder / "new.nc"));
}

}  // namespace
}  // namespace fumon
