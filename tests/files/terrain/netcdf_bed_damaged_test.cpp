#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/netcdf/netcdf_input.h"
#include "files/terrain/netcdf_bed.h"
#include "support/netcdf_beds.h"
#include "support/netcdf_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::bytes_of;
using test::make_bed;
using test::message_of;
using test::NetcdfBed;
using test::NetcdfMaker;

TEST_F(NetcdfBed, ATooLargeBedIsRefusedBeforeItIsRead) {
    {
        const NetcdfMaker maker(path);
        const int y = maker.dimension("y", 20'000);
        const int x = maker.dimension("x", 20'000);
        (void)maker.variable("z", NC_DOUBLE, {y, x});
    }
    EXPECT_EQ(refusal(),
              "z has 20000 × 20000 cells; at most 134217728 are read; cut out or "
              "coarsen the part you need");
}

TEST_F(NetcdfBed, AFileCutShortIsRefusedWhereverItEnds) {
    for (const int format : {NC_NETCDF4, 0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
        for (const bool with_records : {false, true}) {
            std::vector<double> heights(400);
            for (std::size_t i = 0; i < heights.size(); ++i)
                heights[i] = 1.0 + static_cast<double>(i);
            {
                const NetcdfMaker maker(path, format);
                const int time = maker.dimension("time", NC_UNLIMITED);
                const int y = maker.dimension("y", 10);
                const int x = maker.dimension("x", 10);
                maker.text(NC_GLOBAL, "history", "made for a test");
                const int z = with_records ? maker.variable("z", NC_DOUBLE, {time, y, x})
                                           : maker.variable("z", NC_DOUBLE, {y, x});
                const int when = maker.variable("time", NC_DOUBLE, {time});
                maker.values(when, {4}, {0, 1, 2, 3});
                if (with_records) {
                    maker.values(z, {4, 10, 10}, heights);
                } else {
                    maker.values(z, {10, 10}, heights);
                }
            }
            EXPECT_EQ(read().heights(9, 9), with_records ? 400.0 : 100.0);
            const std::string whole = bytes_of(path);
            for (std::size_t length = 4; length < whole.size(); length += 1 + whole.size() / 60) {
                folder.file("bed.nc", whole.substr(0, length));
                EXPECT_NE(refusal(), "") << format << ": " << length << " of " << whole.size();
            }
            folder.file("bed.nc", whole.substr(0, whole.size() - 1));
            EXPECT_NE(refusal(), "");
        }
    }
}

TEST_F(NetcdfBed, DamagedBytesNeverCrash) {
    make_bed(path, {});
    const std::string whole = bytes_of(path);
    for (std::size_t at = 0; at < whole.size(); at += 7) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(~damaged[at]);
        folder.file("bed.nc", damaged);
        try {
            (void)read();
        } catch (const InputError&) {
        }
    }
    make_bed(path, {.format = NC_64BIT_OFFSET});
    const std::string classic = bytes_of(path);
    for (std::size_t at = 0; at < classic.size(); ++at) {
        std::string damaged = classic;
        damaged[at] = static_cast<char>(~damaged[at]);
        folder.file("bed.nc", damaged);
        try {
            (void)read();
        } catch (const InputError&) {
        }
    }
}

TEST_F(NetcdfBed, WhatIsNoNetcdfFileIsRefused) {
    folder.file("bed.nc", "ncols 3\nnrows 2\n");
    EXPECT_EQ(refusal(),
              "is not a NetCDF file; such a file starts with \"CDF\" or \"HDF\", so it may be "
              "damaged or have a wrong name");
    folder.file("bed.nc", "");
    EXPECT_NE(refusal().find("is not a NetCDF file; "), std::string::npos);
    std::filesystem::remove(path);
    EXPECT_NE(refusal().find("cannot be read: No such file or directory; "), std::string::npos);
    EXPECT_FALSE(is_netcdf("CDF\3"));
    EXPECT_FALSE(is_netcdf("CDF"));
}

}  // namespace
}  // namespace fumon
