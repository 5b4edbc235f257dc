#include "files/terrain/terraces/bounded_plate.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace fumon {

namespace {

constexpr int sweeps = 60;    // of each grid
constexpr double over = 1.4;  // relaxation
constexpr int coarsest = 8;   // cells along the shorter side

/// A grid of the problem, from the finest to the coarsest.
struct Plate {
    Grid low;
    Grid high;
    Mask hole;  ///< never empty
};

bool is_free(const Plate& plate, int x, int y) {
    return x >= 0 && y >= 0 && x < plate.hole.nx() && y < plate.hole.ny() && plate.hole(x, y) == 0;
}

/// Half as many cells along both sides, whose bounds are the means of those of their cells.
Plate coarser(const Plate& plate) {
    const int nx = (plate.low.nx() + 1) / 2;
    const int ny = (plate.low.ny() + 1) / 2;
    Plate half{Grid(nx, ny), Grid(nx, ny), Mask(nx, ny)};
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            int count = 0;
            for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
                if (!is_free(plate, 2 * x + i, 2 * y + j)) continue;
                half.low(x, y) += plate.low(2 * x + i, 2 * y + j);
                half.high(x, y) += plate.high(2 * x + i, 2 * y + j);
                ++count;
            }
            half.hole(x, y) = count == 0 ? 1 : 0;
            if (count == 0) continue;
            half.low(x, y) /= count;
            half.high(x, y) /= count;
        }
    }
    return half;
}

/// Heights of coarse cells on cells half as large, linear between the centres; from those of them
/// that are no holes.
Grid finer(const Grid& coarse, const Plate& of_coarse, const Plate& plate) {
    Grid fine(plate.low.nx(), plate.low.ny());
    for (int y = 0; y < fine.ny(); ++y) {
        for (int x = 0; x < fine.nx(); ++x) {
            if (plate.hole(x, y) != 0) continue;
            const int beside_x = x % 2 == 0 ? -1 : 1;
            const int beside_y = y % 2 == 0 ? -1 : 1;
            double sum = 0.0;
            double weights = 0.0;
            const auto add = [&](int u, int v, double weight) {
                if (!is_free(of_coarse, u, v)) return;
                sum += weight * coarse(u, v);
                weights += weight;
            };
            add(x / 2, y / 2, 9.0);
            add(x / 2 + beside_x, y / 2, 3.0);
            add(x / 2, y / 2 + beside_y, 3.0);
            add(x / 2 + beside_x, y / 2 + beside_y, 1.0);
            fine(x, y) = sum / weights;
        }
    }
    return fine;
}

/// Weights of the bending along both axes and of the twist, times dx² dy².
struct Bending {
    double x;
    double y;
    double twist;
};

/// The sums of the derivative of a cell's share of the bending: a h + b, which is to vanish.
struct Balance {
    double a = 0.0;
    double b = 0.0;

    /// Adds a square weight·(factor·h + rest)².
    void add(double weight, double factor, double rest) {
        a += weight * factor * factor;
        b += weight * factor * rest;
    }
};

/// By every second difference and twist that the cells with data around a cell make.
Balance balance_of(const Plate& plate, const Grid& z, const Bending& bending, int x, int y) {
    Balance balance;
    const auto along = [&](int i, int j, double weight) {
        const bool one_back = is_free(plate, x - i, y - j);
        const bool one_on = is_free(plate, x + i, y + j);
        if (one_back && is_free(plate, x - 2 * i, y - 2 * j))
            balance.add(weight, 1.0, z(x - 2 * i, y - 2 * j) - 2.0 * z(x - i, y - j));
        if (one_back && one_on) balance.add(weight, -2.0, z(x - i, y - j) + z(x + i, y + j));
        if (one_on && is_free(plate, x + 2 * i, y + 2 * j))
            balance.add(weight, 1.0, z(x + 2 * i, y + 2 * j) - 2.0 * z(x + i, y + j));
    };
    along(1, 0, bending.x);
    along(0, 1, bending.y);
    for (const int i : {-1, 1}) {
        for (const int j : {-1, 1}) {
            if (!is_free(plate, x + i, y) || !is_free(plate, x, y + j) ||
                !is_free(plate, x + i, y + j))
                continue;
            balance.add(bending.twist, 1.0, z(x + i, y + j) - z(x + i, y) - z(x, y + j));
        }
    }
    return balance;
}

/// The same where all cells within two have data.
Balance balance_inside(const Grid& z, const Bending& bending, int x, int y) {
    const auto sum = [&](int i, int j) { return z(x - i, y - j) + z(x + i, y + j); };
    const double b_x = sum(2, 0) - 4.0 * sum(1, 0);
    const double b_y = sum(0, 2) - 4.0 * sum(0, 1);
    const double b_twist = sum(1, 1) + sum(1, -1) - 2.0 * (sum(1, 0) + sum(0, 1));
    return {6.0 * (bending.x + bending.y) + 4.0 * bending.twist,
            bending.x * b_x + bending.y * b_y + bending.twist * b_twist};
}

/// 1 where all cells within two steps along an axis, or one along both, have data.
Mask inner_cells(const Plate& plate) {
    Mask inner(plate.hole.nx(), plate.hole.ny());
    for (int y = 0; y < inner.ny(); ++y) {
        for (int x = 0; x < inner.nx(); ++x) {
            bool all = true;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) all = all && is_free(plate, x + i, y + j);
            for (const int two : {-2, 2})
                all = all && is_free(plate, x + two, y) && is_free(plate, x, y + two);
            inner(x, y) = all ? 1 : 0;
        }
    }
    return inner;
}

void relax(const Plate& plate, const Bending& bending, Grid& z) {
    const Mask inner = inner_cells(plate);
    const auto relax_cell = [&](int x, int y) {
        const double low = plate.low(x, y);
        const double high = plate.high(x, y);
        if (plate.hole(x, y) != 0 || low == high) return;
        const Balance balance = inner(x, y) != 0 ? balance_inside(z, bending, x, y)
                                                 : balance_of(plate, z, bending, x, y);
        if (balance.a == 0.0) return;
        const double aim = -balance.b / balance.a;
        z(x, y) = std::clamp(z(x, y) + over * (aim - z(x, y)), low, high);
    };
    for (int sweep = 0; sweep < sweeps; ++sweep) {  // there and back, so that neither side leads
        for (int y = 0; y < z.ny(); ++y)
            for (int x = 0; x < z.nx(); ++x) relax_cell(x, y);
        for (int y = z.ny() - 1; y >= 0; --y)
            for (int x = z.nx() - 1; x >= 0; --x) relax_cell(x, y);
    }
}

void hold(const Plate& plate, Grid& z) {
    for (std::size_t cell = 0; cell < z.size(); ++cell)
        z.values()[cell] =
            std::clamp(z.values()[cell], plate.low.values()[cell], plate.high.values()[cell]);
}

}  // namespace

Grid bounded_plate(const Grid& heights, const Grid& freedom, const Mask& nodata, double dx,
                   double dy) {
    const Bending bending{dy * dy / (dx * dx), dx * dx / (dy * dy), 2.0};
    Plate finest{heights, heights, nodata.empty() ? Mask(heights.nx(), heights.ny()) : nodata};
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        finest.low.values()[cell] -= freedom.values()[cell];
        finest.high.values()[cell] += freedom.values()[cell];
    }
    std::vector<Plate> plates{std::move(finest)};
    while (std::min(plates.back().low.nx(), plates.back().low.ny()) > coarsest)
        plates.push_back(coarser(plates.back()));
    Grid z(plates.back().low.nx(), plates.back().low.ny());
    for (std::size_t cell = 0; cell < z.size(); ++cell)
        z.values()[cell] =
            0.5 * (plates.back().low.values()[cell] + plates.back().high.values()[cell]);
    relax(plates.back(), bending, z);
    for (std::size_t level = plates.size() - 1; level > 0; --level) {
        z = finer(z, plates[level], plates[level - 1]);
        hold(plates[level - 1], z);
        relax(plates[level - 1], bending, z);
    }
    for (std::size_t cell = 0; cell < z.size(); ++cell) {
        if (plates.front().hole.values()[cell] != 0) z.values()[cell] = heights.values()[cell];
    }
    return z;
}

}  // namespace fumon
