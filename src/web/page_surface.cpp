#include "web/page_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace fumon {

namespace {

int parts_of(int count, int cells) {
    return (count + cells - 1) / cells;
}

/// Calls visit(x, y) for the cells of a point.
template <class Visit>
void for_cells(int px, int py, int cells, int nx, int ny, const Visit& visit) {
    for (int y = py * cells; y < std::min((py + 1) * cells, ny); ++y)
        for (int x = px * cells; x < std::min((px + 1) * cells, nx); ++x) visit(x, y);
}

}  // namespace

int cells_per_point(const Grid& bed, std::size_t most_triangles) {
    const double triangles = 2.0 * static_cast<double>(bed.size());
    return std::max(1, static_cast<int>(std::ceil(
                           std::sqrt(triangles / static_cast<double>(most_triangles)) - 1e-9)));
}

Field<float> coarse_field(const Grid& field, const Mask& nodata, int cells, double zero,
                          double unit) {
    Field<float> means(parts_of(field.nx(), cells), parts_of(field.ny(), cells));
    for (int py = 0; py < means.ny(); ++py) {
        for (int px = 0; px < means.nx(); ++px) {
            double sum = 0.0;
            int known = 0;
            for_cells(px, py, cells, field.nx(), field.ny(), [&](int x, int y) {
                if (!nodata.empty() && nodata(x, y) != 0) return;
                sum += field(x, y);
                ++known;
            });
            if (known > 0) {
                means(px, py) = static_cast<float>(sum / known * unit - zero);
            } else if (px > 0) {
                means(px, py) = means(px - 1, py);
            } else if (py > 0) {
                means(px, py) = means(px, py - 1);
            }
        }
    }
    return means;
}

Mask coarse_mask(const Mask& nodata, int nx, int ny, int cells) {
    Mask mask(parts_of(nx, cells), parts_of(ny, cells));
    if (nodata.empty()) return {};
    bool any = false;
    for (int py = 0; py < mask.ny(); ++py) {
        for (int px = 0; px < mask.nx(); ++px) {
            int missing = 0;
            int all = 0;
            for_cells(px, py, cells, nx, ny, [&](int x, int y) {
                ++all;
                if (nodata(x, y) != 0) ++missing;
            });
            mask(px, py) = 2 * missing >= all ? 1 : 0;
            any = any || mask(px, py) != 0;
        }
    }
    return any ? mask : Mask();
}

void fill_beside(Image& image) {
    if (!image.transparent()) return;
    constexpr std::uint8_t opaque = 255;
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        if (image.alpha[i] == opaque) front.push_back(i);
    const auto wide = static_cast<std::size_t>(image.width);
    while (!front.empty()) {
        std::vector<std::size_t> next;
        for (const std::size_t from : front) {
            const auto colour = [&](std::size_t to) {
                if (image.alpha[to] == opaque) return;
                for (std::size_t k = 0; k < 3; ++k) image.rgb[3 * to + k] = image.rgb[3 * from + k];
                image.alpha[to] = opaque;
                next.push_back(to);
            };
            if (from % wide > 0) colour(from - 1);
            if (from % wide + 1 < wide) colour(from + 1);
            if (from >= wide) colour(from - wide);
            if (from + wide < image.alpha.size()) colour(from + wide);
        }
        front = std::move(next);
    }
    image.alpha.clear();
}

std::vector<OuterSide> outer_sides(int nx, int ny, const Mask& nodata) {
    constexpr std::array<std::pair<int, int>, 4> beyond{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto has_data = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < nx && y < ny && (nodata.empty() || nodata(x, y) == 0);
    };
    std::vector<OuterSide> sides;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (!has_data(x, y)) continue;
            for (int face = 0; face < 4; ++face) {
                const auto [dx, dy] = beyond[static_cast<std::size_t>(face)];
                if (!has_data(x + dx, y + dy)) sides.push_back({x, y, face});
            }
        }
    }
    return sides;
}

}  // namespace fumon
