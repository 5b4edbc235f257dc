#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "base/grid.h"
#include "base/snapshot.h"
#include "files/netcdf/netcdf_fields.h"

namespace fumon::test {

inline const FieldsText fields_text{"a title", "seed = 7\n[model]\nname = \"sand\"\n", 7};

inline double height(std::int64_t step, int x, int y) {
    return std::sin(0.3 * x + 0.7 * y) + 0.01 * static_cast<double>(step);
}

inline Snapshot snapshot(std::int64_t step, int nx = 7, int ny = 5) {
    Snapshot made;
    made.step = step;
    made.time = 0.5 * static_cast<double>(step);
    made.time_unit = "s";
    made.scale = {2.0, 3.0, 0.25, true};
    made.bed = Grid(nx, ny);
    made.nodata = Mask(nx, ny);
    SnapshotField depth{"water_depth", "depth of the water", "m", Grid(nx, ny)};
    SnapshotField moved{"last_avalanche", "cells of the last avalanche", "grains", Grid(nx, ny)};
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            made.bed(x, y) = height(step, x, y);
            depth.values(x, y) = 100.0 * x + y;
            moved.values(x, y) = static_cast<double>(step) - x;
        }
    }
    made.nodata(1, 2) = 1;
    made.fields = {depth, moved};
    made.numbers = {{"lost_grains", "grains", 10.0 * static_cast<double>(step)}};
    return made;
}

inline std::size_t cell(int x, int y, std::size_t record = 0, std::size_t nx = 7,
                        std::size_t ny = 5) {
    return (record * ny + static_cast<std::size_t>(y)) * nx + static_cast<std::size_t>(x);
}

inline void write_records(const std::filesystem::path& path, int records) {
    FieldsFile file(path, snapshot(0), fields_text);
    for (int i = 0; i < records; ++i) file.add(snapshot(10 * i));
    file.commit();
}

}  // namespace fumon::test
