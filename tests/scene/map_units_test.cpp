// Units of [[map]] files: converted to the quantity's own, or refused.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/input_maps.h"
#include "scene/read.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

struct Row {
    const char* quantity;
    const char* unit;  ///< of the file's numbers, which are 0.25
    double value;      ///< that the model gets; negative: refused
    const char* friction = "manning";
};

class MapUnits : public ::testing::Test {
  protected:
    TemporaryFolder folder;

    InitialBed read(const Row& row) const {
        {
            const NetcdfMaker maker(folder / "map.nc");
            const int y = maker.dimension("y", 2);
            const int x = maker.dimension("x", 2);
            const int ys = maker.axis("y", y, "m");
            const int xs = maker.axis("x", x, "m");
            const int map = maker.variable("quantity", NC_DOUBLE, {y, x});
            if (*row.unit != '\0') maker.text(map, "units", row.unit);
            maker.values(ys, {2}, {0.5, 1.5});
            maker.values(xs, {2}, {0.5, 1.5});
            maker.values(map, {2, 2}, {0.25, 0.25, 0.25, 0.25});
        }
        std::ofstream(folder / "bed.asc")
            << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n";
        const Scene scene = parse_scene(
            fmt::format("[model]\nname = \"water\"\nfriction = \"{}\"\n[run]\nsteps = 1\n[bed]\n"
                        "file = \"bed.asc\"\n[[map]]\nquantity = \"{}\"\nfile = \"map.nc\"\n",
                        row.friction, row.quantity),
            "scene.toml", folder.path());
        InitialBed initial = make_initial_bed(scene);
        add_maps(scene, initial);
        return initial;
    }
};

TEST_F(MapUnits, AreConvertedForEveryQuantity) {
    for (const Row& row : std::vector<Row>{
             {"rain", "", 0.25},
             {"rain", "mm/h", 0.25},
             {"rain", "mm h-1", 0.25},
             {"rain", "kg m-2 s-1", 900.0},
             {"rain", "kg/m2/s", 900.0},
             {"rain", "m s-1", 9e5},
             {"rain", "mm/day", 0.25 / 24.0},
             {"rain", "mm", -1},
             {"rain", "1", -1},
             {"rain", "K", -1},
             {"roughness", "", 0.25},
             {"roughness", "1", 0.25},
             {"roughness", "s m-1/3", 0.25},
             {"roughness", "s/m^(1/3)", 0.25},
             {"roughness", "s m^(-1/3)", 0.25},
             {"roughness", "m-0.333 s", 0.25},
             {"roughness", "s.m-1/3", 0.25},
             {"roughness", "m^(1/2)/s", -1},
             {"roughness", "m1/3 s-1", -1},
             {"roughness", "s", -1},
             {"roughness", "m^0.5 s-1", 0.25, "chezy"},
             {"roughness", "s m-1/3", -1, "chezy"},
             {"roughness", "1", 0.25, "full"},
             {"roughness", "m", -1, "full"},
             {"infiltration_rate", "cm/h", 2.5},
             {"infiltration_start", "in/hr", 6.35},
             {"suction_head", "cm", 0.0025},
             {"suction_head", "s", -1},
             {"moisture_deficit", "%", 0.0025},
             {"moisture_deficit", "m3 m-3", 0.25},
             {"moisture_deficit", "mm", -1},
             {"depth", "cm", 0.0025},
             {"depth", "kg m-2", 0.00025},
             {"level", "ft", 0.0762},
             {"level", "m2", -1},
             {"velocity_x", "km/h", 0.25 / 3.6},
             {"velocity_y", "knot", 0.25 * 1852.0 / 3600.0},
             {"velocity_y", "m", -1},
         }) {
        const std::string name = fmt::format("{} in \"{}\"", row.quantity, row.unit);
        if (row.value < 0.0) {
            const std::string message = message_of<InputError>([&] { (void)read(row); });
            EXPECT_NE(
                message.find(fmt::format("quantity is in \"{}\"; this quantity is ", row.unit)),
                std::string::npos)
                << name << ": " << message;
            EXPECT_NE(message.find("name another variable by map.0.variable"), std::string::npos)
                << message;
            continue;
        }
        const InitialBed initial = read(row);
        ASSERT_EQ(initial.maps.size(), 1U) << name;
        EXPECT_NEAR(initial.maps[0].values(1, 1), row.value, 1e-12 * row.value) << name;
    }
    EXPECT_EQ(read({"rain", "kg m-2 s-1", 0.0}).note,
              "map.0.file: converted to mm/h from kg m-2 s-1");
    EXPECT_NE(message_of<InputError>([&] {
                  (void)read({"rain", "mm", 0.0});
              }).find("this quantity is in mm/h, or in a unit that converts to it"),
              std::string::npos);
}

}  // namespace
}  // namespace fumon::test
