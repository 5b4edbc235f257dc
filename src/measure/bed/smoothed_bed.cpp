#include "measure/bed/smoothed_bed.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fumon {

namespace {

std::size_t site_or_end(int x, int count, bool periodic) {
    if (periodic) return static_cast<std::size_t>((x + count) % count);
    return static_cast<std::size_t>(std::clamp(x, 0, count - 1));
}

void mean_along_x(const Grid& from, Grid& to, bool periodic, int radius) {
    const int nx = from.nx();
    const double scale = 1.0 / (2 * radius + 1);
    const auto half = static_cast<std::size_t>(radius);
    const std::size_t width = 2 * half + 1;
    std::vector<double> padded(static_cast<std::size_t>(nx) + width);
    for (int y = 0; y < from.ny(); ++y) {
        const auto row = from.row(y);
        std::copy(row.begin(), row.end(), padded.begin() + radius);
        for (int beyond = 0; beyond <= radius; ++beyond) {
            const auto distance = static_cast<std::size_t>(beyond);
            if (beyond < radius) padded[distance] = row[site_or_end(beyond - radius, nx, periodic)];
            padded[row.size() + half + distance] = row[site_or_end(nx + beyond, nx, periodic)];
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < width; ++i) sum += padded[i];
        const double* in = padded.data() + width;
        const double* out = padded.data();
        for (double& mean : to.row(y)) {
            mean = sum * scale;
            sum += *in++ - *out++;
        }
    }
}

void mean_along_y(const Grid& from, Grid& to, bool periodic, int radius) {
    const auto nx = static_cast<std::size_t>(from.nx());
    const int ny = from.ny();
    const double scale = 1.0 / (2 * radius + 1);
    std::vector<double> sum(nx);
    const auto row = [&](int y) {
        return from.row(static_cast<int>(site_or_end(y, ny, periodic)));
    };
    for (int y = -radius; y <= radius; ++y) {
        const auto added = row(y);
        for (std::size_t x = 0; x < nx; ++x) sum[x] += added[x];
    }
    for (int y = 0; y < ny; ++y) {
        const auto mean = to.row(y);
        const auto in = row(y + radius + 1);
        const auto out = row(y - radius);
        for (std::size_t x = 0; x < nx; ++x) {
            mean[x] = sum[x] * scale;
            sum[x] += in[x] - out[x];
        }
    }
}

}  // namespace

Grid smoothed_bed(const Grid& bed, bool periodic, int radius) {
    const int along_x = std::clamp(radius, 0, (bed.nx() - 1) / 2);
    const int along_y = std::clamp(radius, 0, (bed.ny() - 1) / 2);
    Grid result = bed;
    Grid work(bed.nx(), bed.ny());
    for (int pass = 0; pass < 2 && along_x > 0; ++pass) {
        mean_along_x(result, work, periodic, along_x);
        std::swap(result, work);
    }
    for (int pass = 0; pass < 2 && along_y > 0; ++pass) {
        mean_along_y(result, work, periodic, along_y);
        std::swap(result, work);
    }
    return result;
}

}  // namespace fumon
