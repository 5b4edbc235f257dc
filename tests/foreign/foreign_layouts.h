#pragma once

#include <netcdf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/netcdf_file.h"

namespace fumon::test {

/// A field over time of nx × ny cells, whose value at (record, y, x) is base + 100·record + 10·y +
/// x.
inline std::vector<double> numbered(std::size_t records, std::size_t ny, std::size_t nx,
                                    double base = 0.0) {
    std::vector<double> values;
    for (std::size_t record = 0; record < records; ++record) {
        for (std::size_t y = 0; y < ny; ++y) {
            for (std::size_t x = 0; x < nx; ++x)
                values.push_back(base + 100.0 * static_cast<double>(record) +
                                 10.0 * static_cast<double>(y) + static_cast<double>(x));
        }
    }
    return values;
}

/// A variable of another model, with unit and standard name where they are not empty.
inline int described(const NetcdfMaker& maker, const char* name, const std::vector<int>& over,
                     const std::string& unit, const std::string& standard_name = "") {
    const int variable = maker.variable(name, NC_FLOAT, over);
    if (!unit.empty()) maker.text(variable, "units", unit);
    if (!standard_name.empty()) maker.text(variable, "standard_name", standard_name);
    return variable;
}

/// As SFINCS writes its map (sfincs_ncoutput.F90, ncoutput_regular_map_init): 4 × 3 cells of 10 m,
/// turned by `turn` given as its cosine and sine, three records; the level is 2 m over the bed in
/// the last column, and missing elsewhere.
inline void write_sfincs(const std::filesystem::path& file, double cosine = 1.0,
                         double sine = 0.0) {
    const NetcdfMaker maker(file);
    const int n = maker.dimension("n", 3);
    const int m = maker.dimension("m", 4);
    const int time = maker.dimension("time", 3);
    const int timemax = maker.dimension("timemax", 1);
    const int x = described(maker, "x", {n, m}, "m", "projection_x_coordinate");
    const int y = described(maker, "y", {n, m}, "m", "projection_y_coordinate");
    const int zb = described(maker, "zb", {n, m}, "m", "altitude");
    const int zs =
        described(maker, "zs", {time, n, m}, "m", "sea_surface_height_above_mean_sea_level");
    maker.number(zs, "_FillValue", NC_FLOAT, {-99999.0});
    const int hmax = described(maker, "hmax", {timemax, n, m}, "m");
    const int t = described(maker, "time", {time}, "seconds since 2019-08-31 14:00:00", "time");
    const int u = described(maker, "u", {time, n, m}, "m s-1", "sea_water_x_velocity");
    std::vector<double> xs;
    std::vector<double> ys;
    std::vector<double> levels;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) {
            xs.push_back(500.0 + 10.0 * (i * cosine - j * sine));
            ys.push_back(900.0 + 10.0 * (i * sine + j * cosine));
        }
    }
    for (int record = 0; record < 3; ++record) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 4; ++i)
                levels.push_back(i == 3 ? 10.0 * j + i + 2.0 + record : -99999.0);
        }
    }
    maker.values(x, {3, 4}, xs);
    maker.values(y, {3, 4}, ys);
    maker.values(zb, {3, 4}, numbered(1, 3, 4));
    maker.values(zs, {3, 3, 4}, levels);
    maker.values(hmax, {1, 3, 4}, numbered(1, 3, 4));
    maker.values(u, {3, 3, 4}, std::vector<double>(36, 0.5));
    maker.values(t, {3}, {0, 1800, 3600});
}

/// As Landlab's write_netcdf writes a RasterModelGrid (landlab.io.netcdf.write): dimensions nt, nj,
/// ni, units "-" and "?", a reference time without a date; 4 × 3 nodes, two records.
inline void write_landlab(const std::filesystem::path& file) {
    const NetcdfMaker maker(file, NC_64BIT_OFFSET);
    const int nt = maker.dimension("nt", 2);
    const int nj = maker.dimension("nj", 3);
    const int ni = maker.dimension("ni", 4);
    const int x = described(maker, "x", {nj, ni}, "-");
    const int y = described(maker, "y", {nj, ni}, "-");
    const int t = described(maker, "t", {nt}, "days since 00:00:00 UTC");
    const int z = described(maker, "topographic__elevation", {nt, nj, ni}, "?");
    const int h = described(maker, "surface_water__depth", {nt, nj, ni}, "m");
    std::vector<double> xs;
    std::vector<double> ys;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) {
            xs.push_back(5.0 * i);
            ys.push_back(5.0 * j);
        }
    }
    maker.values(x, {3, 4}, xs);
    maker.values(y, {3, 4}, ys);
    maker.values(t, {2}, {0.25, 0.5});
    maker.values(z, {2, 3, 4}, numbered(2, 3, 4));
    maker.values(h, {2, 3, 4}, numbered(2, 3, 4, 0.5));
}

/// As XBeach writes its output (its manual, "NetCDF output"; netcdf.F90): globaltime, globaly,
/// globalx, with rows that run south.
inline void write_xbeach(const std::filesystem::path& file,
                         const std::vector<double>& columns = {0, 2, 4, 6}) {
    const NetcdfMaker maker(file);
    const int nx = maker.dimension("globalx", 4);
    const int ny = maker.dimension("globaly", 3);
    const int time = maker.dimension("globaltime", 2);
    const int x = described(maker, "globalx", {ny, nx}, "m");
    const int y = described(maker, "globaly", {ny, nx}, "m");
    const int t = described(maker, "globaltime", {time}, "s");
    maker.text(t, "axis", "T");
    const int zb = described(maker, "zb", {time, ny, nx}, "m");
    const int zs = described(maker, "zs", {time, ny, nx}, "m");
    const int ue = described(maker, "ue", {time, ny, nx}, "m/s");
    std::vector<double> xs;
    std::vector<double> ys;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) {
            xs.push_back(columns[static_cast<std::size_t>(i)]);
            ys.push_back(-2.0 * j);
        }
    }
    std::vector<double> levels = numbered(2, 3, 4);
    for (double& level : levels) level += 1.5;
    maker.values(x, {3, 4}, xs);
    maker.values(y, {3, 4}, ys);
    maker.values(t, {2}, {0, 3600});
    maker.values(zb, {2, 3, 4}, numbered(2, 3, 4));
    maker.values(zs, {2, 3, 4}, levels);
    maker.values(ue, {2, 3, 4}, std::vector<double>(24, 0.25));
}

/// As GeoClaw's fgout_tools writes fgout grids (write_netcdf): time, lat, lon, with h, hu, hv and
/// eta, and no bed of its own.
inline void write_geoclaw(const std::filesystem::path& file) {
    const NetcdfMaker maker(file);
    const int time = maker.dimension("time", 2);
    const int lat = maker.dimension("lat", 3);
    const int lon = maker.dimension("lon", 4);
    const int t = described(maker, "time", {time}, "s");
    const int y = maker.axis("lat", lat, "degrees_north");
    const int x = maker.axis("lon", lon, "degrees_east");
    const int h = described(maker, "h", {time, lat, lon}, "m");
    const int hu = described(maker, "hu", {time, lat, lon}, "m**2/s");
    const int eta = described(maker, "eta", {time, lat, lon}, "m");
    maker.values(t, {2}, {0, 60});
    maker.values(y, {3}, {45.0, 45.001, 45.002});
    maker.values(x, {4}, {-124.0, -123.999, -123.998, -123.997});
    maker.values(h, {2, 3, 4}, std::vector<double>(24, 2.0));
    maker.values(hu, {2, 3, 4}, std::vector<double>(24, 3.0));
    maker.values(eta, {2, 3, 4}, numbered(2, 3, 4));
}

/// As AeoLiS writes its output (aeolis/netcdf.py, initialize): time, n, s, two-dimensional x and y,
/// layers of the bed beside it.
inline void write_aeolis(const std::filesystem::path& file, std::vector<double> times = {0, 86400},
                         const std::string& unit = "m") {
    const NetcdfMaker maker(file);
    const int s = maker.dimension("s", 4);
    const int n = maker.dimension("n", 3);
    const int time = maker.dimension("time", times.size());
    const int layers = maker.dimension("layers", 2);
    const int x = described(maker, "x", {n, s}, "m", "projection_x_coordinate");
    const int y = described(maker, "y", {n, s}, "m", "projection_y_coordinate");
    maker.text(NC_GLOBAL, "source", "AeoLiS");
    const int t = described(maker, "time", {time}, "seconds since ['2015-01-01' '00:00']");
    maker.text(t, "calendar", "julian");
    const int zb = described(maker, "zb", {time, n, s}, unit);
    (void)described(maker, "u", {time, n, s}, "m/s");
    (void)described(maker, "mass", {time, n, s, layers}, "kg/m^2");
    std::vector<double> xs;
    std::vector<double> ys;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) {
            xs.push_back(1.0 * i);
            ys.push_back(1.0 * j);
        }
    }
    maker.values(x, {3, 4}, xs);
    maker.values(y, {3, 4}, ys);
    maker.values(t, {times.size()}, times);
    maker.values(zb, {times.size(), 3, 4}, numbered(times.size(), 3, 4));
}

}  // namespace fumon::test
