#include "render/samples/pixel_classes.h"

#include <algorithm>
#include <cstddef>

#include "base/worker_pool.h"

namespace fumon {

namespace {

pixel_class_vectors::Rays rays_of_row(const SampleRays& rays, int row) {
    const glm::dvec3 first = rays.first + static_cast<double>(row) * rays.up;
    pixel_class_vectors::Rays of{};
    for (int axis = 0; axis < 3; ++axis) {
        of.first[axis] = static_cast<float>(first[axis]);
        of.right[axis] = static_cast<float>(rays.right[axis]);
    }
    return of;
}

}  // namespace

void PixelClasses::classify(const std::uint32_t* numbers, const SampleRectangle& samples,
                            const SampleRays& rays, const PixelGrid& pixels,
                            const pixel_class_vectors::ClassBounds& bounds, WorkerPool& pool) {
    columns_ = pixels.columns;
    const auto columns = static_cast<std::size_t>(pixels.columns);
    const auto factor = static_cast<std::size_t>(pixels.factor);
    const auto first = static_cast<std::size_t>(pixels.first.x);
    kinds_.resize(columns * static_cast<std::size_t>(pixels.all_rows));
    pool.for_ranges(pixels.all_rows, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            std::uint32_t* kinds = kinds_.data() + columns * static_cast<std::size_t>(y);
            if (y >= pixels.rows) {
                std::fill_n(kinds, columns, 0U);
                continue;
            }
            const int row = pixels.first.y + pixels.factor * y;
            const int last = row + pixels.factor - 1;
            const std::uint32_t* lower = numbers + samples.index(0, static_cast<std::size_t>(row));
            const std::uint32_t* upper = numbers + samples.index(0, static_cast<std::size_t>(last));
            pixel_class_vectors::classify_row(
                {lower, upper, static_cast<std::ptrdiff_t>(samples.numbers()), pixels.first.x,
                 rays_of_row(rays, samples.first.y + row),
                 rays_of_row(rays, samples.first.y + last),
                 static_cast<float>(samples.first.x + pixels.first.x), pixels.factor},
                bounds, columns, kinds);
            if (factor == 2) continue;
            // Samples between the corners.
            for (std::size_t x = 0; x < columns; ++x) {
                if (kinds[x] >= pixel_class_vectors::first_single_surface) continue;
                for (std::size_t j = 0; j < factor; ++j)
                    for (std::size_t i = 0; i < factor; ++i)
                        kinds[x] |= numbers[samples.index(first + factor * x + i,
                                                          static_cast<std::size_t>(row) + j)] &
                                    rasteriser_vectors::kind_bits;
            }
        }
    });
}

}  // namespace fumon
