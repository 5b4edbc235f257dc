#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"
#include "foreign/mesh/mesh.h"

namespace fumon {

/// A grid laid over a mesh: which face the centre of each cell lies in, and how a value there comes
/// from its nodes, found once for all records.
class MeshGrid {
  public:
    /// Cells of `cell` metres from the mesh's south-west on. A centre on an edge belongs to one of
    /// the two faces. Polygons may be concave.
    MeshGrid(FaceMesh mesh, double cell);

    [[nodiscard]] int nx() const { return faces_.nx(); }
    [[nodiscard]] int ny() const { return faces_.ny(); }
    [[nodiscard]] double cell() const { return cell_; }

    /// Values of faces, each over all of its cells; NaN outside the mesh and where they are.
    [[nodiscard]] Grid of_faces(std::span<const double> values) const;
    /// Values of nodes, linear in triangles, into which larger polygons are cut from their first
    /// corner; NaN outside the mesh and in triangles with a node that has none.
    [[nodiscard]] Grid of_nodes(std::span<const double> values) const;

    /// The integrals of the same over the mesh itself, whose NaN count as 0; cubic metres of
    /// metres.
    [[nodiscard]] double integral_of_faces(std::span<const double> values) const;
    [[nodiscard]] double integral_of_nodes(std::span<const double> values) const;

  private:
    /// The weights of three corners of a face: the first, `second` and the one after that.
    struct Weights {
        std::uint32_t second = 1;
        float share_second = 0.0F;
        float share_third = 0.0F;
    };

    void fill(std::size_t face);
    void find_weights() const;
    template <class Mean>
    [[nodiscard]] double integral(const Mean& mean_of) const;
    [[nodiscard]] Weights weights_at(std::size_t face, double x, double y) const;

    FaceMesh mesh_;
    double cell_ = 1.0;
    Field<std::int32_t> faces_;             ///< −1 outside
    mutable std::vector<Weights> weights_;  ///< of all cells, once nodes' values are asked for
    std::vector<double> crossings_;
};

}  // namespace fumon
