#include "models/creep.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "support/multiversion.h"

namespace fumon {

namespace {

/// Cells 1 … count of rows that start one cell to the west.
FUMON_MULTIVERSION void creep_inside(const double* south, const double* here, const double* north,
                                     double rate, int count, double* after) {
    for (int x = 1; x <= count; ++x) {
        const double nearest = (here[x - 1] + here[x + 1]) + (south[x] + north[x]);
        const double diagonal = (south[x - 1] + north[x - 1]) + (south[x + 1] + north[x + 1]);
        after[x] = here[x] + rate * ((1.0 / 6.0) * nearest + (1.0 / 12.0) * diagonal - here[x]);
    }
}

FUMON_MULTIVERSION void take_maxima(const double* south, const double* here, const double* north,
                                    int count, double* sides, double* column) {
    for (int x = 0; x < count; ++x) {
        sides[x] = south[x] > north[x] ? south[x] : north[x];
        column[x] = sides[x] > here[x] ? sides[x] : here[x];
    }
}

FUMON_MULTIVERSION void mark_peaks(const double* here, const double* sides, const double* column,
                                   int count, unsigned char* peaks) {
    for (int x = 1; x <= count; ++x) {
        const double beside = column[x - 1] > column[x + 1] ? column[x - 1] : column[x + 1];
        const double around = beside > sides[x] ? beside : sides[x];
        peaks[x] = here[x] > around ? 1 : 0;
    }
}

/// The eight neighbours of a cell of a periodic bed, in the order of Sudo's program.
struct Neighbours {
    double* south;
    double* here;
    double* north;
    int west;
    int x;
    int east;

    [[nodiscard]] bool below_cell() const {
        const double height = here[x];
        return height > here[west] && height > here[east] && height > south[x] &&
               height > north[x] && height > south[west] && height > north[west] &&
               height > south[east] && height > north[east];
    }

    void topple(double rate) const {
        const double given = rate * here[x] * 0.25;
        const double to_side = given * (2.0 / 3.0);
        const double to_corner = given * (1.0 / 3.0);
        here[west] += to_side;
        here[east] += to_side;
        south[x] += to_side;
        north[x] += to_side;
        south[west] += to_corner;
        north[west] += to_corner;
        south[east] += to_corner;
        north[east] += to_corner;
        here[x] -= rate * here[x];
    }
};

}  // namespace

void creep_row(std::span<const double> south, std::span<const double> here,
               std::span<const double> north, double rate, std::span<double> after) {
    const int nx = static_cast<int>(here.size());
    if (nx > 2) creep_inside(south.data(), here.data(), north.data(), rate, nx - 2, after.data());
    const auto edge = [&](int west, int x, int east) {
        const double s[3] = {south[static_cast<std::size_t>(west)],
                             south[static_cast<std::size_t>(x)],
                             south[static_cast<std::size_t>(east)]};
        const double h[3] = {here[static_cast<std::size_t>(west)],
                             here[static_cast<std::size_t>(x)],
                             here[static_cast<std::size_t>(east)]};
        const double n[3] = {north[static_cast<std::size_t>(west)],
                             north[static_cast<std::size_t>(x)],
                             north[static_cast<std::size_t>(east)]};
        double out[3] = {0.0, 0.0, 0.0};
        creep_inside(s, h, n, rate, 1, out);
        after[static_cast<std::size_t>(x)] = out[1];
    };
    edge(nx - 1, 0, 1 % nx);
    edge((nx - 2 + nx) % nx, nx - 1, 0);
}

void MaximaCreep::operator()(Grid& bed, double rate) {
    const int nx = bed.nx();
    const int ny = bed.ny();
    const auto width = static_cast<std::size_t>(nx);
    sides_.resize(width);
    column_.resize(width);
    peaks_.assign(width + sizeof(std::uint64_t), 0);
    for (int y = 0; y < ny; ++y) {
        double* south = bed.row(y == 0 ? ny - 1 : y - 1).data();
        double* here = bed.row(y).data();
        double* north = bed.row(y + 1 == ny ? 0 : y + 1).data();
        take_maxima(south, here, north, nx, sides_.data(), column_.data());
        if (nx > 2) mark_peaks(here, sides_.data(), column_.data(), nx - 2, peaks_.data());

        const auto visit = [&](int x) {
            const Neighbours around{
                south, here, north, x == 0 ? nx - 1 : x - 1, x, x + 1 == nx ? 0 : x + 1};
            if (!around.below_cell()) return false;
            around.topple(rate);
            return true;
        };
        // A topple changes the columns x − 1 … x + 1, so the marks of x + 1 and x + 2 may be out of
        // date, and those of the last two cells after one at x = 0 or 1: these are looked at again.
        int look_again_until = 0;
        int x = 0;
        while (x < nx) {
            const bool wraps = x == 0 || x >= nx - 2;
            if (!wraps && x > look_again_until) {
                std::uint64_t eight = 0;
                std::memcpy(&eight, peaks_.data() + x, sizeof eight);
                if (eight == 0 && x + 8 <= nx - 2) {
                    x += 8;
                    continue;
                }
                if (peaks_[static_cast<std::size_t>(x)] == 0) {
                    ++x;
                    continue;
                }
            }
            if (visit(x)) look_again_until = x + 2;
            ++x;
        }
    }
}

}  // namespace fumon
