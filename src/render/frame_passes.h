#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>

namespace fumon {

class PictureDrawing;
class TileDrawing;

/// What passes hand to each other: targets of OpenGL, and what vector code leaves in memory.
enum class Target : unsigned {
    // Of a picture.
    light,        ///< the sky's radiances from all directions, and how much of the sun is seen
    bed_maps,     ///< heights, light, values and marks over the bed
    bed_colours,  ///< the bed as it is shaded, a texture over it
    ground_mesh,  ///< triangles of the block, or of endless ground as the camera sees it
    instances,    ///< plants, persons, prints and puffs, and the air's sheet and paths
    // Of a tile.
    visibility_buffer,  ///< visibility of samples of endless ground, in memory
    visibility,         ///< visibility of samples, with depths and stencils: FrameTargets
    coverage,           ///< visibility of samples of a block, in memory: BlockRasteriser
    streamed_light,     ///< transmittance and light of blown sand, per pixel: StreamerLayer
    water_colours,      ///< of the surface of a block with water, by pixels: WaterBlockPass
    pixel_colours,      ///< of single-surface pixels of endless ground: FrameTargets
    edge_colours,       ///< of the samples of multi-surface pixels, packed: PackedSamples
    sample_colours,     ///< FrameTargets
    background,         ///< FrameTargets, and read from it
    side_colours,  ///< of a block's sides by pixels, in the background's target once it is read
    picture,       ///< its pixels
};

/// Some of them.
class Targets {
  public:
    constexpr Targets(std::initializer_list<Target> targets) {
        for (const Target target : targets) bits_ |= 1U << static_cast<unsigned>(target);
    }
    [[nodiscard]] constexpr bool has(Target target) const {
        return (bits_ >> static_cast<unsigned>(target) & 1U) != 0;
    }
    [[nodiscard]] constexpr bool has(const Targets& all) const {
        return (bits_ & all.bits_) == all.bits_;
    }
    [[nodiscard]] constexpr Targets operator|(const Targets& other) const {
        Targets both = *this;
        both.bits_ |= other.bits_;
        return both;
    }

  private:
    unsigned bits_ = 0;
};

/// A line of a list: a pass, whether a picture or a tile needs it, and what it reads and writes.
/// TileDrawing::use() throws for a target that the line of a pass does not name.
template <typename Drawing>
struct Pass {
    std::string_view name;
    bool (Drawing::*needed)() const;
    Targets writes;
    void (Drawing::*draw)();
    Targets reads;
};

/// Once a picture, before its tiles.
std::span<const Pass<PictureDrawing>> picture_passes();
/// Of a tile of a block of ground alone, of 8 bits and 2 × 2 samples a pixel: by vector code.
std::span<const Pass<TileDrawing>> block_passes();
/// Of a tile of all other pictures, once; through a lens once for each of its points.
std::span<const Pass<TileDrawing>> sample_passes();

/// Runs the passes of a list that are needed, in its order.
template <typename Drawing>
void run(std::span<const Pass<Drawing>> passes, Drawing& drawing) {
    for (const Pass<Drawing>& pass : passes) {
        if (!(drawing.*pass.needed)()) continue;
        drawing.begin(pass);
        (drawing.*pass.draw)();
    }
}

}  // namespace fumon
