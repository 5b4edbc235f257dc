// NetCDF grids as other programs write them: a row a variant, with origin, cell and heights as they
// must be read, or the refusal.

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "files/terrain/geographic.h"
#include "support/netcdf_beds.h"

namespace fumon::test {
namespace {

/// Rows from the south, columns from the west.
const std::vector<double> one_to_six{1, 2, 3, 4, 5, 6};

struct Expected {
    double west = 5.0;
    double south = 2.5;
    double dx = 10.0;  ///< of the place
    double dy = 5.0;
    std::vector<double> heights = one_to_six;
    std::vector<int> nodata{};
    double cell = 0.0;  ///< metres eastward; 0: dx
    bool degrees = false;
    std::string note{};  ///< a part of it
};

struct Variant {
    std::string name;
    std::function<void(const NetcdfMaker&)> make;
    Expected expected{};
    std::string refusal{};  ///< a part of it; empty where it is read
    TerrainQuery query{};
};

void PrintTo(const Variant& variant, std::ostream* out) {
    *out << variant.name;
}

using Attributes = std::function<void(const NetcdfMaker&, int)>;

/// A usual grid: y 5, 10 and x 10, 20, 30, with attributes of the heights and of both axes.
std::function<void(const NetcdfMaker&)> usual(const Attributes& attributes,
                                              const std::string& unit = "m",
                                              std::vector<double> heights = one_to_six,
                                              int type = NC_DOUBLE,
                                              std::vector<double> x = {10, 20, 30},
                                              std::vector<double> y = {5, 10},
                                              int axis_type = NC_DOUBLE) {
    return [=](const NetcdfMaker& maker) {
        const int rows = maker.dimension("y", y.size());
        const int columns = maker.dimension("x", x.size());
        const int ys = maker.axis("y", rows, unit, axis_type);
        const int xs = maker.axis("x", columns, unit, axis_type);
        const int z = maker.variable("z", type, {rows, columns});
        attributes(maker, z);
        maker.values(ys, {y.size()}, y);
        maker.values(xs, {x.size()}, x);
        maker.values(z, {y.size(), x.size()}, heights);
    };
}

Attributes text(const char* name, const std::string& value) {
    return [=](const NetcdfMaker& maker, int z) { maker.text(z, name, value); };
}

Attributes number(const char* name, int type, const std::vector<double>& values) {
    return [=](const NetcdfMaker& maker, int z) { maker.number(z, name, type, values); };
}

const Attributes nothing = [](const NetcdfMaker&, int) {};

/// Heights over any dimensions, of which "x" and "y" have coordinates.
std::function<void(const NetcdfMaker&)> over(
    const std::vector<std::pair<const char*, std::size_t>>& dimensions,
    const std::vector<double>& heights) {
    return [=](const NetcdfMaker& maker) {
        std::vector<int> numbers;
        std::vector<std::size_t> count;
        for (const auto& [name, length] : dimensions) {
            numbers.push_back(maker.dimension(name, length));
            count.push_back(length);
        }
        std::vector<std::pair<int, std::vector<double>>> axes;
        for (std::size_t k = 0; k < dimensions.size(); ++k) {
            const std::string name = dimensions[k].first;
            if (name == "x") axes.push_back({maker.axis("x", numbers[k], "m"), {10, 20, 30}});
            if (name == "y") axes.push_back({maker.axis("y", numbers[k], "m"), {5, 10}});
        }
        const int z = maker.variable("z", NC_DOUBLE, numbers);
        for (const auto& [axis, values] : axes) maker.values(axis, {values.size()}, values);
        maker.values(z, count, heights);
    };
}

/// Heights over dimensions (j, i) with two-dimensional longitudes and latitudes, turned by a slope.
std::function<void(const NetcdfMaker&)> planes(double turn, bool by_name = false) {
    return [=](const NetcdfMaker& maker) {
        const int j = maker.dimension("j", 2);
        const int i = maker.dimension("i", 3);
        const int z = maker.variable("z", NC_DOUBLE, {j, i});
        const int lon = maker.variable(by_name ? "nav_lon" : "glam", NC_DOUBLE, {j, i});
        const int lat = maker.variable(by_name ? "nav_lat" : "gphi", NC_DOUBLE, {j, i});
        if (!by_name) {
            maker.text(z, "coordinates", "glam gphi");
            maker.text(lon, "standard_name", "longitude");
            maker.text(lat, "standard_name", "latitude");
        }
        maker.text(lon, "units", "degrees_east");
        maker.text(lat, "units", "degrees_north");
        maker.values(lon, {2, 3}, {7, 7.5, 8, 7 + turn, 7.5 + turn, 8 + turn});
        maker.values(lat, {2, 3}, {45, 45 - turn, 45 - 2 * turn, 46, 46 - turn, 46 - 2 * turn});
        maker.values(z, {2, 3}, one_to_six);
    };
}

std::function<void(const NetcdfMaker&)> with_mapping(const Attributes& attributes,
                                                     bool coordinates = true) {
    return [=](const NetcdfMaker& maker) {
        const int rows = maker.dimension("y", 2);
        const int columns = maker.dimension("x", 3);
        const int z = maker.variable("z", NC_DOUBLE, {rows, columns});
        const int mapping = maker.variable("mapping", NC_INT, {});
        maker.text(z, "grid_mapping", "mapping");
        attributes(maker, mapping);
        if (coordinates) {
            const int ys = maker.axis("y", rows, "m");
            const int xs = maker.axis("x", columns, "m");
            maker.values(ys, {2}, {5, 10});
            maker.values(xs, {3}, {10, 20, 30});
        }
        maker.values(z, {2, 3}, one_to_six);
    };
}

std::vector<double> seconds(double first, double per_degree, int count, bool single) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        const double value = first + k / per_degree;
        values.push_back(single ? static_cast<double>(static_cast<float>(value)) : value);
    }
    return values;
}

constexpr double us_survey_foot = 1200.0 / 3937.0;

std::vector<double> times(double factor) {
    std::vector<double> heights = one_to_six;
    for (double& height : heights) height *= factor;
    return heights;
}

std::vector<Variant> variants() {
    const DegreeLengths at_45 = degree_lengths(45.5);
    std::vector<Variant> rows{
        {"usual", usual(nothing)},
        {"descending", usual(nothing, "m", {6, 5, 4, 3, 2, 1}, NC_DOUBLE, {30, 20, 10}, {10, 5})},
        {"columns_before_rows", over({{"x", 3}, {"y", 2}}, {1, 4, 2, 5, 3, 6})},
        {"time_of_one", over({{"time", 1}, {"y", 2}, {"x", 3}}, one_to_six)},
        {"band_of_one_last", over({{"y", 2}, {"x", 3}, {"band", 1}}, one_to_six)},
        {"two_of_one", over({{"time", 1}, {"band", 1}, {"y", 2}, {"x", 3}}, one_to_six)},
        {"columns_first_and_time", over({{"x", 3}, {"time", 1}, {"y", 2}}, {1, 4, 2, 5, 3, 6})},
        {"last_of_several",
         over({{"band", 2}, {"y", 2}, {"x", 3}}, {9, 9, 9, 9, 9, 9, 1, 2, 3, 4, 5, 6}),
         {.note = "the last of 2 records of z is read"}},
        {"one_of_several",
         over({{"y", 2}, {"x", 3}, {"time", 2}}, {1, 9, 2, 9, 3, 9, 4, 9, 5, 9, 6, 9}),
         {},
         "",
         {.record = 1}},
        {"two_kinds_of_records",
         over({{"time", 2}, {"level", 2}, {"y", 2}, {"x", 3}}, std::vector<double>(24, 1.0)),
         {},
         "z has records along time (2) and level (2)",
         {.variable = "z"}},
        {"km_axes", usual(nothing, "km"), {.west = 5000, .south = 2500, .dx = 10000, .dy = 5000}},
        {"foot_axes",
         usual(nothing, "ft"),
         {.west = 1.524, .south = 0.762, .dx = 3.048, .dy = 1.524}},
        {"us_foot_axes",
         usual(nothing, "US survey foot"),
         {.west = 5 * us_survey_foot,
          .south = 2.5 * us_survey_foot,
          .dx = 10 * us_survey_foot,
          .dy = 5 * us_survey_foot}},
        {"scaled_axes",
         [](const NetcdfMaker& maker) {
             const int rows = maker.dimension("y", 2);
             const int columns = maker.dimension("x", 3);
             const int ys = maker.axis("y", rows, "m", NC_SHORT);
             const int xs = maker.axis("x", columns, "m", NC_SHORT);
             maker.number(xs, "scale_factor", NC_DOUBLE, {10});
             maker.number(ys, "scale_factor", NC_DOUBLE, {5});
             const int z = maker.variable("z", NC_DOUBLE, {rows, columns});
             maker.values(ys, {2}, {1, 2});
             maker.values(xs, {3}, {1, 2, 3});
             maker.values(z, {2, 3}, one_to_six);
         }},
        {"nearly_even", usual(nothing, "m", one_to_six, NC_DOUBLE, {10, 20.4, 30})},
        {"uneven",
         usual(nothing, "m", one_to_six, NC_DOUBLE, {10, 20.6, 30}),
         {},
         "x is not evenly spaced: x[1] is 20.6 where even spacing has 20; interpolate the heights "
         "to even spacing first"},
        {"unit_of_axis_is_none", usual(nothing, "K"), {}, "the unit of x is \"K\""},
        {"feet",
         usual(text("units", "ft")),
         {.heights = times(0.3048), .note = "heights converted to metres from ft"}},
        {"us_feet", usual(text("units", "US survey foot")), {.heights = times(us_survey_foot)}},
        {"decimetres_of_a_datum",
         usual(text("units", "dm above mean sea level")),
         {.heights = times(0.1)}},
        {"fathoms", usual(text("units", "fathoms")), {.heights = times(1.8288)}},
        {"no_height",
         usual(text("units", "K")),
         {},
         "z is in \"K\"; heights are in a unit of "
         "length (\"m\")"},
        {"unit_overridden",
         usual(text("units", "K")),
         {.heights = times(0.3048),
          .note = "heights converted to metres from ft (bed.height_unit)"},
         "",
         {.height_unit = "ft"}},
        {"factor", usual(text("units", "m")), {.heights = times(2.5)}, "", {.height_factor = 2.5}},
        {"positive_down",
         usual(text("positive", "down")),
         {.heights = times(-1), .note = "z grows downward: its numbers are taken as depths"}},
        {"depth_by_its_name",
         usual(text("standard_name", "sea_floor_depth_below_geoid")),
         {.heights = times(-1)}},
        {"depth_that_is_up", usual([](const NetcdfMaker& maker, int z) {
             maker.text(z, "standard_name", "sea_floor_depth_below_geoid");
             maker.text(z, "positive", "up");
         })},
        {"down_overridden",
         usual(text("positive", "down")),
         {},
         "",
         {.height_sign = HeightSign::up}},
        {"up_overridden",
         usual(text("positive", "up")),
         {.heights = times(-1)},
         "",
         {.height_sign = HeightSign::down}},
        {"height_above_geoid", usual(text("standard_name", "height_above_geopotential_datum"))},
        {"packed", usual(
                       [](const NetcdfMaker& maker, int z) {
                           maker.number(z, "scale_factor", NC_DOUBLE, {0.5});
                           maker.number(z, "add_offset", NC_DOUBLE, {1000});
                       },
                       "m", {-1998, -1996, -1994, -1992, -1990, -1988}, NC_SHORT)},
        {"fill_value",
         usual(number("_FillValue", NC_DOUBLE, {3})),
         {.heights = {1, 2, 0, 4, 5, 6}, .nodata = {0, 0, 1, 0, 0, 0}}},
        {"two_missing_values",
         usual(number("missing_value", NC_DOUBLE, {3, 5})),
         {.heights = {1, 2, 0, 4, 0, 6}, .nodata = {0, 0, 1, 0, 1, 0}}},
        {"missing_value_of_another_type",
         usual(number("missing_value", NC_DOUBLE, {-9999.9}), "m", {1, 2, -9999.9, 4, 5, 6},
               NC_FLOAT),
         {.heights = {1, 2, 0, 4, 5, 6}, .nodata = {0, 0, 1, 0, 0, 0}}},
        {"valid_range",
         usual(number("valid_range", NC_DOUBLE, {2, 5})),
         {.heights = {0, 2, 3, 4, 5, 0}, .nodata = {1, 0, 0, 0, 0, 1}}},
        {"valid_min",
         usual(number("valid_min", NC_DOUBLE, {2})),
         {.heights = {0, 2, 3, 4, 5, 6}, .nodata = {1, 0, 0, 0, 0, 0}}},
        {"valid_max",
         usual(number("valid_max", NC_DOUBLE, {5})),
         {.heights = {1, 2, 3, 4, 5, 0}, .nodata = {0, 0, 0, 0, 0, 1}}},
        {"unsigned_bytes",
         usual(
             [](const NetcdfMaker& maker, int z) {
                 maker.text(z, "_Unsigned", "true");
                 maker.number(z, "_FillValue", NC_BYTE, {-1});
             },
             "m", {1, 2, -1, -128, 5, -2}, NC_BYTE),
         {.heights = {1, 2, 0, 128, 5, 254}, .nodata = {0, 0, 1, 0, 0, 0}}},
        {"unsigned_shorts",
         usual(text("_Unsigned", "true"), "m", {1, 2, 3, 4, 5, -2}, NC_SHORT),
         {.heights = {1, 2, 3, 4, 5, 65534}}},
        {"planes_of_a_regular_grid",
         planes(0),
         {.west = 6.75,
          .south = 44.5,
          .dx = 0.5,
          .dy = 1,
          .cell = 0.5 * at_45.east,
          .degrees = true}},
        {"planes_by_name",
         planes(0, true),
         {.west = 6.75,
          .south = 44.5,
          .dx = 0.5,
          .dy = 1,
          .cell = 0.5 * at_45.east,
          .degrees = true}},
        {"curvilinear",
         planes(0.1),
         {},
         "z lies on a rotated or curvilinear grid: glam and gphi differ along both of its sides; "
         "interpolate it to a regular grid first"},
        {"curvilinear_by_name", planes(0.1, true), {}, "nav_lon and nav_lat differ"},
        {"rotated_pole",
         with_mapping(text("grid_mapping_name", "rotated_latitude_longitude")),
         {},
         "z lies on a grid with a rotated pole; interpolate it to a regular grid first"},
        {"crs_wkt", with_mapping(text("crs_wkt", "LOCAL_CS[\"here\"]"))},
        {"transform_of_gdal",
         with_mapping(text("GeoTransform", "5 10 0 12.5 0 -5 "), false),
         {.heights = {4, 5, 6, 1, 2, 3}}},
        {"skewed_transform",
         with_mapping(text("GeoTransform", "5 10 1 12.5 0 -5 "), false),
         {},
         "z has rotated or skewed cells"},
        {"axes_by_attributes",
         [](const NetcdfMaker& maker) {
             const int rows = maker.dimension("nj", 2);
             const int columns = maker.dimension("ni", 3);
             const int ys = maker.axis("northing_of_row", rows, "m");
             const int xs = maker.axis("easting_of_column", columns, "m");
             maker.text(ys, "axis", "Y");
             maker.text(xs, "axis", "X");
             const int z = maker.variable("z", NC_DOUBLE, {rows, columns});
             maker.values(ys, {2}, {5, 10});
             maker.values(xs, {3}, {10, 20, 30});
             maker.values(z, {2, 3}, one_to_six);
         }},
        {"bounds_without_a_word",
         [](const NetcdfMaker& maker) {
             usual([](const NetcdfMaker& same, int) {
                 const int bounds = same.dimension("bnds", 2);
                 (void)same.variable("x_bnds", NC_DOUBLE, {1, bounds});
                 (void)same.variable("time_bnds", NC_DOUBLE, {same.dimension("time", 1), bounds});
             })(maker);
         }},
    };
    for (const double per_degree : {3600.0, 1200.0, 240.0}) {
        for (const bool stored_single : {true, false}) {
            const auto lon = seconds(-105.5, per_degree, 200, true);
            const auto lat = seconds(40.0, per_degree, 2, true);
            const double cell = 1.0 / per_degree;
            const double dx = (lon.back() - lon.front()) / 199.0;
            const double dy = lat[1] - lat[0];
            Expected expected{.west = -105.5 - 0.5 * dx,
                              .south = 40.0 - 0.5 * dy,
                              .dx = dx,
                              .dy = dy,
                              .heights = std::vector<double>(400, 7.0),
                              .degrees = true};
            expected.cell = dx * degree_lengths(40.0 + 0.5 * dy).east;
            EXPECT_NEAR(dx / cell, 1.0, 2e-4);
            rows.push_back({"single_longitudes_" + std::to_string(static_cast<int>(per_degree)) +
                                (stored_single ? "_float" : "_double"),
                            usual(nothing, "degrees_east", std::vector<double>(400, 7.0), NC_DOUBLE,
                                  lon, lat, stored_single ? NC_FLOAT : NC_DOUBLE),
                            expected});
        }
    }
    return rows;
}

class NetcdfVariants : public ::testing::TestWithParam<Variant> {};

TEST_P(NetcdfVariants, AreReadOrRefused) {
    const Variant& variant = GetParam();
    const TemporaryFolder folder;
    const auto path = folder / "grid.nc";
    { variant.make(NetcdfMaker(path)); }
    if (!variant.refusal.empty()) {
        const std::string message =
            message_of<InputError>([&] { (void)read_terrain(path, variant.query); });
        EXPECT_NE(message.find(variant.refusal), std::string::npos) << message;
        return;
    }
    const Terrain terrain = read_terrain(path, variant.query);
    const Expected& expected = variant.expected;
    ASSERT_TRUE(terrain.place.has_value()) << terrain.note;
    const double tolerance = 1e-9 * std::max(1.0, std::abs(expected.west));
    EXPECT_NEAR(terrain.place->west, expected.west, tolerance);
    EXPECT_NEAR(terrain.place->south, expected.south, tolerance);
    EXPECT_NEAR(terrain.place->dx, expected.dx, 1e-9 * expected.dx);
    EXPECT_NEAR(terrain.place->dy, expected.dy, 1e-9 * expected.dy);
    EXPECT_EQ(terrain.place->degrees, expected.degrees);
    const double cell = expected.cell > 0.0 ? expected.cell : expected.dx;
    EXPECT_NEAR(terrain.dx, cell, 1e-9 * cell);
    ASSERT_EQ(terrain.heights.size(), expected.heights.size());
    for (std::size_t k = 0; k < expected.heights.size(); ++k)
        EXPECT_NEAR(terrain.heights.values()[k], expected.heights[k], 1e-12) << "cell " << k;
    const auto mask = terrain.nodata.values();
    EXPECT_EQ(std::vector<int>(mask.begin(), mask.end()), expected.nodata);
    EXPECT_NE(terrain.note.find(expected.note), std::string::npos) << terrain.note;
}

INSTANTIATE_TEST_SUITE_P(Table, NetcdfVariants, ::testing::ValuesIn(variants()),
                         [](const auto& row) { return row.param.name; });

TEST(NetcdfPlaces, AreInTheUnitOfTheSystem) {
    const TemporaryFolder folder;
    const auto path = folder / "feet.nc";
    const std::string crs = "PROJCS[\"state plane\",UNIT[\"US survey foot\",0.304800609601219]]";
    {
        const NetcdfMaker maker(path);
        usual(
            [&](const NetcdfMaker& same, int z) {
                const int mapping = same.variable("crs", NC_INT, {});
                same.text(z, "grid_mapping", "crs: x y");
                same.text(mapping, "crs_wkt", crs);
            },
            "US survey foot")(maker);
    }
    const Terrain terrain = read_terrain(path);
    EXPECT_NEAR(terrain.place->west, 5.0, 1e-12);
    EXPECT_NEAR(terrain.place->dx, 10.0, 1e-12);
    EXPECT_NEAR(terrain.dx, 10.0 * us_survey_foot, 1e-12);
    EXPECT_EQ(terrain.place->crs, crs);
}

}  // namespace
}  // namespace fumon::test
