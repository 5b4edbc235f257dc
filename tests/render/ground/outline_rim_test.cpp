#include "render/ground/outline_rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fumon {
namespace {

/// A bed whose data end along a line through its middle that rises by 30 degrees.
DisplayBed cut_bed(int side, int refinement) {
    const double rise = std::tan(std::numbers::pi / 6.0);
    Mask nodata(side, side, 0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            nodata(x, y) = y + 0.5 - 0.5 * side > rise * (x + 0.5 - 0.5 * side) ? 1 : 0;
    DisplayBed bed;
    bed.refinement = refinement;
    bed.z = Field<float>(side * refinement, side * refinement, 0.0F);
    bed.outline = mask_outline(nodata);
    bed.nodata = outside_of(bed.outline, side, side, refinement);
    return bed;
}

TEST(OutlineRim, AStraightEdgeIsAStraightWall) {
    constexpr int side = 60;
    const double rise = std::tan(std::numbers::pi / 6.0);
    for (const int refinement : {1, 4}) {
        const DisplayBed bed = cut_bed(side, refinement);
        for (const int stride : {1, 2}) {
            TerrainLattice lattice = terrain_lattice(bed.z.nx(), bed.z.ny(), bed.nodata, stride);
            EXPECT_FALSE(move_rim(lattice, bed).empty());
            const std::vector<SideFace> faces = rim_faces(lattice, 1.0F);
            double farthest = 0.0;  // cells of the data
            double most_turned = 1.0;
            int inner = 0;
            for (const SideFace& face : faces) {
                const MeshPosition& at = lattice.positions[face.from];
                if (std::abs(at.east - 0.5F) > 0.3F) continue;
                ++inner;
                const double above = side * ((at.north - 0.5) - rise * (at.east - 0.5));
                farthest = std::max(farthest, std::abs(above) * std::cos(std::numbers::pi / 6.0));
                const double along =
                    -0.5 * static_cast<double>(face.normal_from.east) +
                    std::cos(std::numbers::pi / 6.0) * static_cast<double>(face.normal_from.north);
                most_turned = std::min(most_turned, along);
            }
            EXPECT_GT(inner, 20);
            EXPECT_LE(farthest, 0.15) << refinement << ' ' << stride;
            EXPECT_GT(most_turned, 0.995) << refinement << ' ' << stride;
        }
    }
}

TEST(OutlineRim, ABedWithoutAMaskStaysAsItIs) {
    TerrainLattice lattice = terrain_lattice(9, 7, Mask(), 1);
    DisplayBed bed;
    bed.z = Field<float>(9, 7, 0.0F);
    EXPECT_TRUE(move_rim(lattice, bed).empty());
    EXPECT_TRUE(rim_faces(lattice, 1.0F).empty());
}

}  // namespace
}  // namespace fumon
