// Coordinate reference systems as CF's grid mappings, from both versions of well-known text.

#include "files/netcdf/grid_mapping.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fumon {
namespace {

const std::string wgs84_1 =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
const std::string wgs84_2 =
    R"(BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,)"
    R"(298.257223563,LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,)"
    R"(ANGLEUNIT["degree",0.0174532925199433]]])";

/// "name: attribute=1,2 …", the figure of the Earth left out; "" for none.
std::string told(const std::string& wkt) {
    const auto mapping = grid_mapping_of(wkt);
    if (!mapping) return "";
    std::string text = mapping->name + ":";
    for (const auto& [name, values] : mapping->attributes) {
        if (name == "semi_major_axis") break;
        text += " " + name + "=";
        for (const double value : values)
            text += (text.back() == '=' ? "" : ",") + std::to_string(value).substr(0, 8);
    }
    return text;
}

std::string version_1(const std::string& method, const std::string& parameters,
                      const std::string& unit = R"(UNIT["metre",1])") {
    return R"(PROJCS["a map",)" + wgs84_1 + R"(,PROJECTION[")" + method + R"("],)" + parameters +
           unit + "]";
}

std::string version_2(const std::string& method, const std::string& parameters) {
    return R"(PROJCRS["a map",)" + wgs84_2 + R"(,CONVERSION["c",METHOD[")" + method + R"--("],)--" +
           parameters + R"--(],CS[Cartesian,2],AXIS["(E)",east],LENGTHUNIT["metre",1]])--";
}

std::string angle(const std::string& name, const std::string& degrees) {
    return R"(PARAMETER[")" + name + R"(",)" + degrees +
           R"(,ANGLEUNIT["degree",0.0174532925199433]])";
}

TEST(GridMapping, IsTransverseMercatorOfUtm) {
    const std::string utm =
        "transverse_mercator: longitude_of_central_meridian=-105.000 "
        "latitude_of_projection_origin=0.000000 scale_factor_at_central_meridian=0.999600 "
        "false_easting=500000.0 false_northing=0.000000";
    EXPECT_EQ(
        told(version_1("Transverse_Mercator",
                       R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",)"
                       R"(-105],PARAMETER["scale_factor",0.9996],)"
                       R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],)")),
        utm);
    EXPECT_EQ(told(version_1("Transverse_Mercator",
                             R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",)"
                             R"(-105],PARAMETER["scale_factor",0.9996],)"
                             R"(PARAMETER["false_easting",500],)",
                             R"(UNIT["kilometre",1000])")),
              utm)
        << "in metres";
    EXPECT_EQ(told(version_2("Transverse Mercator",
                             angle("Longitude of natural origin", "-105") +
                                 R"(,PARAMETER["Scale factor at natural origin",0.9996,)"
                                 R"(SCALEUNIT["unity",1]],PARAMETER["False easting",500000,)"
                                 R"(LENGTHUNIT["metre",1]])")),
              utm);
}

TEST(GridMapping, KnowsTheUsualProjections) {
    EXPECT_EQ(told(version_2("Lambert Conic Conformal (2SP)",
                             angle("Latitude of false origin", "46.5") + "," +
                                 angle("Longitude of false origin", "3") + "," +
                                 angle("Latitude of 1st standard parallel", "49") + "," +
                                 angle("Latitude of 2nd standard parallel", "44"))),
              "lambert_conformal_conic: standard_parallel=49.00000,44.00000 "
              "longitude_of_central_meridian=3.000000 latitude_of_projection_origin=46.50000 "
              "false_easting=0.000000 false_northing=0.000000");
    const std::string polar =
        "polar_stereographic: straight_vertical_longitude_from_pole=-45.0000 "
        "latitude_of_projection_origin=90.00000 standard_parallel=70.00000 "
        "false_easting=0.000000 false_northing=0.000000";
    EXPECT_EQ(told(version_2("Polar Stereographic (variant B)",
                             angle("Latitude of standard parallel", "70") + "," +
                                 angle("Longitude of origin", "-45"))),
              polar);
    EXPECT_EQ(told(version_1("Polar_Stereographic",
                             R"(PARAMETER["latitude_of_origin",70],)"
                             R"(PARAMETER["central_meridian",-45],PARAMETER["scale_factor",1],)")),
              polar);
    EXPECT_EQ(told(version_2("Lambert Azimuthal Equal Area",
                             angle("Latitude of natural origin", "52") + "," +
                                 angle("Longitude of natural origin", "10"))),
              "lambert_azimuthal_equal_area: longitude_of_projection_origin=10.00000 "
              "latitude_of_projection_origin=52.00000 false_easting=0.000000 "
              "false_northing=0.000000");
    EXPECT_EQ(
        told(version_1("Albers_Conic_Equal_Area", R"(PARAMETER["latitude_of_center",23],)"
                                                  R"(PARAMETER["longitude_of_center",-96],)"
                                                  R"(PARAMETER["standard_parallel_1",29.5],)"
                                                  R"(PARAMETER["standard_parallel_2",45.5],)")),
        "albers_conical_equal_area: standard_parallel=29.50000,45.50000 "
        "longitude_of_central_meridian=-96.0000 latitude_of_projection_origin=23.00000 "
        "false_easting=0.000000 false_northing=0.000000");
    EXPECT_EQ(told(version_1("Mercator_2SP", R"(PARAMETER["standard_parallel_1",20],)")),
              "mercator: longitude_of_projection_origin=0.000000 standard_parallel=20.00000 "
              "false_easting=0.000000 false_northing=0.000000");
    EXPECT_EQ(told(wgs84_1), "latitude_longitude:");
    EXPECT_EQ(told(R"(COMPD_CS["both",)" + wgs84_1 + R"(,VERT_CS["height",UNIT["metre",1]]])"),
              "latitude_longitude:");
}

TEST(GridMapping, TellsTheFigureOfTheEarth) {
    const auto mapping = grid_mapping_of(wgs84_1);
    ASSERT_TRUE(mapping);
    using Attributes = std::vector<std::pair<std::string, std::vector<double>>>;
    EXPECT_EQ(mapping->attributes, (Attributes{{"semi_major_axis", {6378137.0}},
                                               {"inverse_flattening", {298.257223563}},
                                               {"longitude_of_prime_meridian", {0.0}}}));
    const auto web = grid_mapping_of(version_2("Popular Visualisation Pseudo Mercator",
                                               angle("Longitude of natural origin", "0")));
    ASSERT_TRUE(web);
    EXPECT_EQ(web->attributes[web->attributes.size() - 2],
              (std::pair<std::string, std::vector<double>>{"semi_minor_axis", {6378137.0}}))
        << "on a sphere";
}

TEST(GridMapping, IsNoneForWhatCfDoesNotKnow) {
    EXPECT_EQ(told(version_2("Krovak", angle("Longitude of origin", "24.8"))), "");
    EXPECT_EQ(
        told(version_1("Lambert_Conformal_Conic_1SP", R"(PARAMETER["scale_factor",0.9999],)")), "")
        << "a scale";
    EXPECT_EQ(told(version_1("Transverse_Mercator", R"(PARAMETER["rectified_grid_angle",3],)")),
              "");
    for (const char* broken : {"", "x", "PROJCS[", "PROJCS[\"a\"", "PROJCS[]", "PROJCS[\"a\"]]",
                               "PROJCS[PROJECTION[],PARAMETER[]]", "EPSG:4326"})
        EXPECT_EQ(told(broken), "") << broken;
    std::string deep = "A[1]";
    for (int i = 0; i < 2000; ++i) deep = "A[" + deep + "]";
    EXPECT_EQ(told(deep), "");
}

}  // namespace
}  // namespace fumon
