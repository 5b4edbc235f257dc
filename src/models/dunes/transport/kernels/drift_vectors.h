#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Loops over whole numbers of sand, written for vectors: every target gives the same.
namespace fumon::drift_vectors {

/// How many cells are spread together: what becomes of them stays in the cache.
constexpr std::size_t most_cells = 256;
/// Zeros on either side of a row of pieces.
constexpr std::size_t margin = 2;

/// Pieces of amounts over 3 × 3 cells, a row a piece, the south-western one first; the first cell's
/// lies behind the margin. What lies in the margins stays zero, beyond what is asked for.
struct Pieces {
    std::array<std::array<std::int64_t, most_cells + 2 * margin>, 9> rows{};
};

/// Spreads `count` ≤ most_cells amounts by the shares along x and y; what rounding leaves goes to
/// the middle piece. The margin behind the last one is zero.
void spread(const std::int64_t* amounts, std::size_t count, const std::array<double, 3>& along,
            const std::array<double, 3>& across, Pieces& pieces);

/// Adds what the pieces of row j = 0, 1, 2 bring to the cells from the `first` on of the `count` +
/// 2 that they reach: to[0 … cells).
void add(const Pieces& pieces, std::size_t j, std::size_t first, std::size_t cells,
         std::int64_t* to);

/// A row's sand and rock, and those of the rows beside it.
struct Slopes {
    const std::int64_t* surface;
    const std::int64_t* rock;
    const std::int64_t* south_surface;
    const std::int64_t* south_rock;
    const std::int64_t* north_surface;
    const std::int64_t* north_rock;
};

/// after[x] for the cells begin ≤ x < end, which have neighbours on both sides: each cell gives
/// the shares of the difference to lower neighbours, a quarter of its sand at most.
void drift_down(const Slopes& row, std::size_t begin, std::size_t end, double share_x,
                double share_y, std::int64_t* after);

/// Lifts from a row's cells the layer times (1 − shade) and, where there is a shear stress, times
/// 1 + shear between 0 and `greatest`, as far as there is sand: from the surface to what moves.
void lift(std::size_t count, double layer, double greatest, const double* shade,
          const double* shear, const std::int64_t* rock, std::int64_t* surface,
          std::int64_t* moving);

/// How much of what arrives stays.
struct Staying {
    double on_rock;
    double more_on_sand;    ///< where the cover is full
    double per_full_cover;  ///< 1 / its thickness, in units of sand
    double landing;         ///< the share that ends its hop
};

/// Of what arrives in a row's cells the larger of the shade and of the cover's share stays, times
/// the share that lands; the rest moves on. `landed`, where it is not null, takes all of it.
/// Nothing is left in `arrived`.
void deposit(std::size_t count, const Staying& share, const double* shade, const std::int64_t* rock,
             std::int64_t* arrived, std::int64_t* surface, std::int64_t* moving,
             std::int64_t* landed);

}  // namespace fumon::drift_vectors
