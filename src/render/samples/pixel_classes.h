#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/samples/ground_rasteriser.h"
#include "render/samples/pixel_class_vectors.h"

namespace fumon {

class WorkerPool;

/// Where pixels lie among samples.
struct PixelGrid {
    /// The lower left pixel's lower left sample, of a rectangle of samples; both even, if a pixel
    /// has two along its sides.
    glm::ivec2 first{0};
    int factor = 1;   ///< samples along each side of a pixel, 2 or more
    int columns = 0;  ///< of pixels
    int rows = 0;     ///< of pixels, from the lowest on, that may see ground
    int all_rows = 0;
};

/// How each pixel of a tile of endless ground is coloured (pixel_class_vectors). It does not depend
/// on the tile, on threads and on the processor.
class PixelClasses {
  public:
    /// `numbers`: as GroundRasteriser leaves them.
    void classify(const std::uint32_t* numbers, const SampleRectangle& samples,
                  const SampleRays& rays, const PixelGrid& pixels,
                  const pixel_class_vectors::ClassBounds& bounds, WorkerPool& pool);

    /// Rows upward, as many as there are in all.
    [[nodiscard]] const std::vector<std::uint32_t>& numbers() const { return kinds_; }
    [[nodiscard]] int columns() const { return columns_; }

  private:
    std::vector<std::uint32_t> kinds_;
    int columns_ = 0;
};

}  // namespace fumon
