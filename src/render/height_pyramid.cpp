#include "render/height_pyramid.h"

#include <algorithm>
#include <cmath>
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

Field<float> halved(const Field<float>& fine) {
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

HeightPyramid::HeightPyramid(const Field<float>& heights)
    : levels_{heights}, highest_(*std::ranges::max_element(heights.values())) {
    while (levels_.back().nx() > 1 || levels_.back().ny() > 1)
        levels_.push_back(halved(levels_.back()));
}

float HeightPyramid::at(int level, double east, double north) const {
    const Field<float>& field = levels_[static_cast<std::size_t>(level)];
    const auto split = [](double share, int count) {
        const double place = (share - std::floor(share)) * count - 0.5;
        const double below = std::floor(place);
        const int first = static_cast<int>(below);
        return std::pair(first, static_cast<float>(place - below));
    };
    const auto [x, right] = split(east, field.nx());
    const auto [y, upper] = split(north, field.ny());
    const int x0 = x < 0 ? field.nx() - 1 : std::min(x, field.nx() - 1);
    const int y0 = y < 0 ? field.ny() - 1 : std::min(y, field.ny() - 1);
    const int x1 = x0 + 1 == field.nx() ? 0 : x0 + 1;
    const int y1 = y0 + 1 == field.ny() ? 0 : y0 + 1;
    const float south = field(x0, y0) + right * (field(x1, y0) - field(x0, y0));
    const float north_row = field(x0, y1) + right * (field(x1, y1) - field(x0, y1));
    return south + upper * (north_row - south);
}

}  // namespace fumon
