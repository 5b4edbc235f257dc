#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/grid.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/field_choice.h"
#include "foreign/mesh/mesh_file.h"
#include "foreign/mesh/mesh_grid.h"
#include "foreign/run_times.h"

namespace fumon {

/// The dimension of the records of a mesh's values; −1 where none has records.
int records_of_mesh(const NetcdfInput& input, const MeshLayout& mesh);

/// The maps of a file's mesh: values of its nodes and of its faces. Those of edges are none.
std::vector<ForeignMap> maps_of_mesh(const NetcdfInput& input, const MeshLayout& mesh, int records);

/// The times of ANUGA's records, which are in seconds from its attribute `starttime` without
/// saying so; of others as netcdf_times().
RawTimes times_of_mesh(const NetcdfInput& input, const MeshLayout& mesh, int records,
                       const std::string& unit);

/// A file's mesh laid on a grid.
struct LaidMesh {
    MeshGrid grid;
    std::size_t nodes = 0;
    std::size_t faces = 0;
    WorldScale scale;
    std::vector<std::string> notes{};

    /// One record of a map in the file's own numbers; NaN where it has none. Throws InputError for
    /// another mesh than this.
    [[nodiscard]] std::vector<double> values(const NetcdfInput& input, const ForeignMap& map,
                                             std::size_t record) const;
    [[nodiscard]] Grid laid(const ForeignMap& map, std::span<const double> values) const;
};

/// Lays it on cells of `cell` metres; 0: of half the mesh's median edge, or larger, so that there
/// are four million at most. Throws InputError for more cells than a grid may have.
std::shared_ptr<const LaidMesh> lay_mesh(const NetcdfInput& input, const MeshLayout& mesh,
                                         double cell);

}  // namespace fumon
