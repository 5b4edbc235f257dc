#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon::test {

class NetcdfBed : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path path = folder / "bed.nc";

    [[nodiscard]] Terrain read(const std::string& variable = "") const {
        return read_terrain(path, {.variable = variable});
    }
    /// The refusal without the file's name before it.
    [[nodiscard]] std::string refusal(const std::string& variable = "") const {
        const std::string message = message_of<InputError>([&] { (void)read(variable); });
        const std::string begin = path.string() + ": ";
        EXPECT_EQ(message.find(begin), 0U) << message;
        return message.substr(std::min(message.size(), begin.size()));
    }
};

/// A 3 × 2 bed (columns × rows) with the given coordinates.
struct SimpleBed {
    std::vector<double> x{10, 20, 30};
    std::vector<double> y{5, 10};
    std::string unit = "m";
    std::vector<double> heights{1, 2, 3, 4, 5, 6};
    int type = NC_DOUBLE;
    int axis_type = NC_DOUBLE;
    int format = NC_NETCDF4;
    std::string x_name = "x";
    std::string y_name = "y";
    std::function<void(const NetcdfMaker&, int)> more{};  ///< with the bed's number
};

inline void make_bed(const std::filesystem::path& path, const SimpleBed& bed) {
    const NetcdfMaker maker(path, bed.format);
    const int y = maker.dimension(bed.y_name.c_str(), bed.y.size());
    const int x = maker.dimension(bed.x_name.c_str(), bed.x.size());
    const int ys = maker.axis(bed.y_name.c_str(), y, bed.unit, bed.axis_type);
    const int xs = maker.axis(bed.x_name.c_str(), x, bed.unit, bed.axis_type);
    const int z = maker.variable("z", bed.type, {y, x});
    if (bed.more) bed.more(maker, z);
    maker.values(ys, {bed.y.size()}, bed.y);
    maker.values(xs, {bed.x.size()}, bed.x);
    maker.values(z, {bed.y.size(), bed.x.size()}, bed.heights);
}

}  // namespace fumon::test
