#include "models/sand/creep.h"

#include <bit>
#include <cstdint>
#include <cstring>

#include "base/give_up.h"
#include "base/multiversion.h"
#include "base/worker_pool.h"

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

/// 64 bytes of 0 or 1 as 64 bits.
std::uint64_t packed(const unsigned char* bytes) {
    constexpr std::uint64_t gather = 0x0102040810204080;
    std::uint64_t bits = 0;
    for (int group = 0; group < 8; ++group) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, bytes + std::ptrdiff_t{8} * group, sizeof eight);
        bits |= ((eight * gather) >> 56U) << (8U * static_cast<unsigned>(group));
    }
    return bits;
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
        const double height = here[x];  // no short cuts: their jumps cannot be foreseen
        const auto below = [height](const double* row, int column) {
            return static_cast<unsigned>(height > row[column]);
        };
        return (below(here, west) & below(here, east) & below(south, x) & below(north, x) &
                below(south, west) & below(north, west) & below(south, east) &
                below(north, east)) != 0;
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

void MaximaCreep::operator()(Grid& bed, double rate, WorkerPool& pool) {
    mark(bed, pool);
    for (int y = 0; y < ny_; ++y) {
        give_up_if_asked();
        double* south = bed.row(y == 0 ? ny_ - 1 : y - 1).data();
        double* here = bed.row(y).data();
        double* north = bed.row(y + 1 == ny_ ? 0 : y + 1).data();
        const std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(y) * words_;
        for (std::size_t word = 0; word < words_; ++word) {
            std::uint64_t not_passed = ~std::uint64_t{0};
            while (const std::uint64_t waiting = marks[word] & not_passed) {
                const int bit = std::countr_zero(waiting);
                const int x = static_cast<int>(word) * 64 + bit;
                not_passed = ~std::uint64_t{1} << static_cast<unsigned>(bit);
                const Neighbours around{
                    south, here, north, x == 0 ? nx_ - 1 : x - 1, x, x + 1 == nx_ ? 0 : x + 1};
                if (!around.below_cell()) continue;
                const int reach = here[x] < 0.0 ? 2 : 1;
                around.topple(rate);
                mark_around(x, y, reach);
            }
        }
    }
}

/// Marks the strict maxima of the bed as it is, and the first and last cell of every row.
void MaximaCreep::mark(const Grid& bed, WorkerPool& pool) {
    nx_ = bed.nx();
    ny_ = bed.ny();
    const auto width = static_cast<std::size_t>(nx_);
    words_ = (width + 63) / 64;
    marks_.resize(words_ * static_cast<std::size_t>(ny_));
    pool.for_ranges(ny_, [&](int begin, int end) {
        std::vector<double> sides(width);   // the larger of the cells south and north
        std::vector<double> column(width);  // the largest of south, here and north
        std::vector<unsigned char> peaks(words_ * 64, 0);
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            const double* here = bed.row(y).data();
            take_maxima(bed.row(y == 0 ? ny_ - 1 : y - 1).data(), here,
                        bed.row(y + 1 == ny_ ? 0 : y + 1).data(), nx_, sides.data(), column.data());
            if (nx_ > 2) mark_peaks(here, sides.data(), column.data(), nx_ - 2, peaks.data());
            peaks[0] = peaks[width - 1] = 1;
            std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(y) * words_;
            for (std::size_t word = 0; word < words_; ++word)
                marks[word] = packed(peaks.data() + 64 * word);
        }
    });
}

/// Marks the cells that a cell may have made maxima by giving: its neighbours, which were raised
/// and stand beside a lower one. A cell below zero takes instead, and lowers its neighbours, so
/// that theirs may have become maxima. Marks behind the sweep do no harm.
void MaximaCreep::mark_around(int x, int y, int reach) {
    const auto bit = static_cast<unsigned>(x);
    const bool inside =
        reach == 1 && y > 0 && y + 1 < ny_ && x + 1 < nx_ && bit % 64 != 0 && bit % 64 != 63;
    if (inside) {
        std::uint64_t* here = marks_.data() + static_cast<std::size_t>(y) * words_ + bit / 64;
        const std::uint64_t three = std::uint64_t{7} << (bit % 64 - 1);
        here[0] |= three;
        here[words_] |= three;
        return;
    }
    for (int dy = -reach; dy <= reach; ++dy) {
        const int row = (y + dy + 2 * ny_) % ny_;
        std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(row) * words_;
        for (int dx = -reach; dx <= reach; ++dx) {
            const auto marked = static_cast<unsigned>((x + dx + 2 * nx_) % nx_);
            marks[marked / 64] |= std::uint64_t{1} << (marked % 64);
        }
    }
}

}  // namespace fumon
