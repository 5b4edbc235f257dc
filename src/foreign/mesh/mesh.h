#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fumon {

/// Triangles and polygons of any number of corners, on nodes that they share.
struct FaceMesh {
    std::vector<double> x;  ///< of the nodes, metres from its south-west
    std::vector<double> y;
    std::vector<std::int32_t> corners;  ///< the nodes of one face after the other, around each
    std::vector<std::size_t> ends{};    ///< of each face, in `corners`

    [[nodiscard]] std::size_t faces() const { return ends.size(); }
    /// The nodes of a face.
    [[nodiscard]] std::span<const std::int32_t> face(std::size_t number) const {
        const std::size_t begin = number == 0 ? 0 : ends[number - 1];
        return std::span(corners).subspan(begin, ends[number] - begin);
    }
};

/// Half the length of the edge that half of all edges are shorter than, to three digits: a cell
/// that shows what most of a mesh shows. Metres; 0 for a mesh without a face.
double cell_of_edges(const FaceMesh& mesh);

}  // namespace fumon
