// The core of the rasteriser: which samples lie in a triangle, and which triangle is the nearest.
//
// 1. Vertices stand on whole numbers, 1/256 of a sample, and edge functions (Pineda 1988) are whole
//    numbers too: exact, hence the same on every processor and vector length.
// 2. A sample on an edge that two triangles share belongs to one of them, by the way the edge goes
//    (owns_edge()): no gaps, and no sample twice.
// 3. Triangles of up to 90 samples across take edge functions of 32 bits, a vector of samples at a
//    time, row by row over their bounding box. Larger ones need 64 bits: there each row is solved
//    for the first and the last sample inside, which costs a division an edge.
// 4. Depth is reversed z: near_depth / depth in perspective, linear in depth without it, and larger
//    is nearer. Over the picture it is linear in both, so that a plane gives it for each sample;
//    floats are finest far away. It is kept between the values of the vertices, which the rounded
//    plane of a triangle seen edge-on may leave.
// 5. Depth and kind share a word, whose maximum is the depth test: no branch for a sample.
//
//    sample word   │ 31 …  reversed z, above 0  … 3 │ 2 … kind … 0 │
//    slope word    │ 31 … to the right … 16 │ 15 … upward … 0 │      upper halves of two floats

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon::rasteriser_vectors {

// A sample of what stands nearest in one number: its reversed z, a float above 0, whose lowest bits
// are the kind of what is seen. The larger one is nearer, in whatever order they come.
constexpr std::uint32_t kind_bits = 7;

/// Corners in the picture: 1/256 of a sample from its lower left, and reversed_z; 0: has no place
/// in it.
struct ProjectedVertices {
    std::vector<std::int32_t> x;
    std::vector<std::int32_t> y;
    std::vector<float> reversed_z;

    void resize(std::size_t count);
};

/// Samples of some rows of a tile, columns and rows counted over the whole picture.
struct Band {
    std::uint32_t* samples;  ///< rows upward, each `stride` long: `beyond` more than columns
    std::size_t stride;
    int first_column;
    int end_column;
    int first_row;
    int end_row;
    /// Slope of the visible surface for each sample: growth of reversed_z to the next sample,
    /// rightward in the upper half of the bits and upward in the lower, each the upper half of
    /// a float's; nullptr: not wanted.
    std::uint32_t* slopes = nullptr;

    static constexpr std::size_t beyond = 64;
};

/// Triangles, three corners each; counter-clockwise ones face the eye.
struct Triangles {
    const std::uint32_t* indices;  ///< counted from `first_vertex` on
    std::size_t first_vertex;
    const std::uint32_t* listed;  ///< which of them, `count` numbers
    std::size_t count;
    std::uint32_t kind;
    bool double_sided;  ///< else backs are left out
};

/// Rasterises triangles into a band's samples. A sample lies in exactly one of two triangles that
/// share an edge: edge functions are integers.
void rasterise(const ProjectedVertices& vertices, const Triangles& triangles, const Band& band);

}  // namespace fumon::rasteriser_vectors
