#include "render/ground/height_pyramid.h"

#include <algorithm>
#include <utility>

namespace fumon {

namespace {

/// Which cells a coarser one covers, along one side: at most three where an odd number is halved.
struct Cover {
    int first;
    float weight[3];
};

std::vector<Cover> covers(int fine, int coarse) {
    std::vector<Cover> all;
    all.reserve(static_cast<std::size_t>(coarse));
    const double size = static_cast<double>(fine) / coarse;
    for (int i = 0; i < coarse; ++i) {
        const double from = i * size;
        const double to = (i + 1) * size;
        Cover cover{static_cast<int>(from), {}};
        for (int k = 0; k < 3; ++k) {
            const double left = std::max<double>(from, cover.first + k);
            const double right = std::min<double>(to, cover.first + k + 1);
            cover.weight[k] = static_cast<float>(std::max(right - left, 0.0) / size);
        }
        all.push_back(cover);
    }
    return all;
}

Field<float> downsampled(const Field<float>& fine) {
    Field<float> coarse(std::max(fine.nx() / 2, 1), std::max(fine.ny() / 2, 1));
    const std::vector<Cover> along = covers(fine.nx(), coarse.nx());
    const std::vector<Cover> across = covers(fine.ny(), coarse.ny());
    for (int y = 0; y < coarse.ny(); ++y) {
        const Cover& rows = across[static_cast<std::size_t>(y)];
        for (int x = 0; x < coarse.nx(); ++x) {
            const Cover& columns = along[static_cast<std::size_t>(x)];
            float sum = 0.0F;
            for (int j = 0; j < 3; ++j) {
                if (rows.weight[j] == 0.0F) continue;
                for (int i = 0; i < 3; ++i) {
                    if (columns.weight[i] == 0.0F) continue;
                    sum += rows.weight[j] * columns.weight[i] *
                           fine(columns.first + i, rows.first + j);
                }
            }
            coarse(x, y) = sum;
        }
    }
    return coarse;
}

}  // namespace

HeightPyramid::HeightPyramid(Field<float> heights, const GroundTiles& tiles, bool walls)
    : tiles_(tiles), highest_(*std::ranges::max_element(heights.values())), walls_(walls) {
    levels_.push_back(std::move(heights));
    while (levels_.back().nx() > 1 || levels_.back().ny() > 1)
        levels_.push_back(downsampled(levels_.back()));
}

}  // namespace fumon
