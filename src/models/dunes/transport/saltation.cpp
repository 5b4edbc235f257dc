#include "models/dunes/transport/saltation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <vector>

#include "base/cancellation.h"
#include "base/worker_pool.h"
#include "models/dunes/transport/hop_spread.h"

namespace fumon {

namespace {

/// Pieces of an amount over 3 × 3 cells, south-western one first. What rounding leaves goes to the
/// middle.
std::array<std::int64_t, 9> pieces_of(std::int64_t amount, const HopSpread& along,
                                      const HopSpread& across) {
    constexpr std::size_t middle = 4;
    const auto whole = static_cast<double>(amount);
    std::array<std::int64_t, 9> pieces{};
    std::int64_t given = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const double of_row = whole * across.shares[j];
        for (std::size_t i = 0; i < 3; ++i) {
            if (3 * j + i == middle) continue;
            const auto piece = static_cast<std::int64_t>(of_row * along.shares[i]);
            pieces[3 * j + i] = piece;
            given += piece;
        }
    }
    pieces[middle] = amount - given;
    return pieces;
}

}  // namespace

/// Of hops by so many cells along x and y.
struct Saltation::Spreads {
    Spreads(const SaturationHops& hops, double cells_x, double cells_y)
        : along(cells_x, hops.spread_x), across(cells_y, hops.spread_y) {}

    HopSpread along;
    HopSpread across;
};

double hop_factor(const DunesParameters& parameters, double above_mean) {
    const double factor =
        1.0 + above_mean * (parameters.hop_per_height +
                            parameters.hop_per_height_squared * std::abs(above_mean));
    return std::max(factor, 0.0);
}

Saltation::Saltation(const DunesParameters& parameters, const DuneGround& ground, WorkerPool& pool)
    : parameters_(parameters), ground_(ground), pool_(pool), arrived_(ground.nx, ground.ny) {}

void Saltation::hop(DuneBed& bed, const WindOverBed& wind, const SaturationHops& hops) {
    hops_ = hops;
    const double cells_x = hops_.length * wind.blowing.x / ground_.dx;
    const double cells_y = hops_.length * wind.blowing.y / ground_.dy;
    const Grid* walls = wind.before_walls;
    if (wind.along_walls != nullptr) {
        hop_along_walls(bed, wind);
        return;
    }
    if (wind.bent != nullptr) {
        hop_all(
            bed,
            [&](int x, int y) {
                const double reach =
                    walls != nullptr ? (*walls)(x, y) * hops_.length : hops_.length;
                return Spreads(hops_, reach * wind.bent->x(x, y) / ground_.dx,
                               reach * wind.bent->y(x, y) / ground_.dy);
            },
            hops_.length / ground_.dy);
        return;
    }
    if (parameters_.speed_up != DuneSpeedUp::height && walls != nullptr) {
        hop_all(
            bed,
            [&](int x, int y) {
                const double slowed = (*walls)(x, y);
                return Spreads(hops_, slowed * cells_x, slowed * cells_y);
            },
            std::abs(cells_y));
        return;
    }
    if (parameters_.speed_up != DuneSpeedUp::height) {
        hop_all(bed, Spreads(hops_, cells_x, cells_y), std::abs(cells_y));
        return;
    }
    const auto heights = bed.surface.values();
    const std::int64_t highest = *std::ranges::max_element(heights);
    const double mean = mean_height(bed.surface);
    const double most = hop_factor(parameters_, to_metres(highest) - mean);
    hop_all(
        bed,
        [&](int x, int y) {
            double factor = hop_factor(parameters_, to_metres(bed.surface(x, y)) - mean);
            if (walls != nullptr) factor *= (*walls)(x, y);
            return Spreads(hops_, factor * cells_x, factor * cells_y);
        },
        most * std::abs(cells_y));
}

void Saltation::hop_along_walls(DuneBed& bed, const WindOverBed& wind) {
    const bool by_height = parameters_.speed_up == DuneSpeedUp::height;
    const double mean = by_height ? mean_height(bed.surface) : 0.0;
    double most = 1.0;
    if (by_height) {
        const auto heights = bed.surface.values();
        most = std::max(
            most, hop_factor(parameters_, to_metres(*std::ranges::max_element(heights)) - mean));
    }
    hop_all(
        bed,
        [&](int x, int y) {
            double reach = hops_.length;
            if (by_height) reach *= hop_factor(parameters_, to_metres(bed.surface(x, y)) - mean);
            const double ahead = reach * (*wind.before_walls)(x, y);
            const double aside = reach * (*wind.along_walls)(x, y);
            const double to_x = wind.bent != nullptr ? wind.bent->x(x, y) : wind.blowing.x;
            const double to_y = wind.bent != nullptr ? wind.bent->y(x, y) : wind.blowing.y;
            return Spreads(hops_, (ahead * to_x - aside * wind.blowing.y) / ground_.dx,
                           (ahead * to_y + aside * wind.blowing.x) / ground_.dy);
        },
        2.0 * most * hops_.length / ground_.dy);
}

/// Rows are hopped from in blocks, first every other one, then those between, so that no two
/// threads meet.
template <class Spread>
void Saltation::hop_all(DuneBed& bed, const Spread& spread, double reach_y) {
    const auto rows_hop = [&](int begin, int end) {
        if constexpr (std::is_same_v<Spread, Spreads>) {
            return hop_rows_alike(bed, spread, begin, end);
        } else {
            return hop_rows(bed, spread, begin, end);
        }
    };
    constexpr double beside = 3.0;  // cells: the spread, and rounding
    const double least_height = 2.0 * (reach_y + beside);
    const auto pairs = static_cast<std::int64_t>(ground_.ny / (2.0 * least_height));
    if (pairs == 0) {
        bed.outflow += rows_hop(0, ground_.ny);
        return;
    }
    const auto border = [&](std::int64_t block) {
        return static_cast<int>(block * ground_.ny / (2 * pairs));
    };
    std::vector<std::int64_t> lost(2 * static_cast<std::size_t>(pairs));
    for (int odd = 0; odd < 2; ++odd) {
        pool_.for_ranges(static_cast<int>(pairs), [&](int begin, int end) {
            for (std::int64_t pair = begin; pair < end; ++pair) {
                const std::int64_t block = 2 * pair + odd;
                lost[static_cast<std::size_t>(block)] = rows_hop(border(block), border(block + 1));
            }
        });
    }
    bed.outflow += std::accumulate(lost.begin(), lost.end(), std::int64_t{0});
}

/// Adds to `cells` cells of row y from `x` on what `pieces` of row j bring there; returns what
/// leaves over open edges.
std::int64_t Saltation::add_pieces(const drift_vectors::Pieces& pieces, std::size_t j,
                                   std::size_t cells, std::int64_t x, int y) {
    std::int64_t lost = 0;
    std::size_t done = 0;
    while (done < cells) {
        const std::int64_t place = x + static_cast<std::int64_t>(done);
        const int to_x = y < 0 ? -1 : ground_.column(place);
        if (to_x < 0) {
            std::int64_t piece = 0;
            drift_vectors::add(pieces, j, done++, 1, &piece);
            lost += piece;
            continue;
        }
        const std::size_t some =
            std::min(cells - done, static_cast<std::size_t>(ground_.nx - to_x));
        drift_vectors::add(pieces, j, done, some, &arrived_(to_x, y));
        done += some;
    }
    return lost;
}

/// As hop_rows(), where all hops are alike.
std::int64_t Saltation::hop_rows_alike(const DuneBed& bed, const Spreads& spread, int begin,
                                       int end) {
    const auto& [along, across] = spread;
    std::int64_t lost = 0;
    drift_vectors::Pieces pieces;
    for (int y = begin; y < end; ++y) {
        throw_if_cancelled();
        const auto moving = bed.moving.row(y);
        for (std::size_t x = 0; x < moving.size(); x += drift_vectors::most_cells) {
            const std::size_t count = std::min(drift_vectors::most_cells, moving.size() - x);
            drift_vectors::spread(moving.data() + x, count, along.shares, across.shares, pieces);
            for (std::size_t j = 0; j < 3; ++j) {
                const int to_y = ground_.row(y + across.first + static_cast<std::int64_t>(j));
                lost += add_pieces(pieces, j, count + 2, static_cast<std::int64_t>(x) + along.first,
                                   to_y);
            }
        }
    }
    return lost;
}

template <class Spread>
std::int64_t Saltation::hop_rows(const DuneBed& bed, const Spread& spread, int begin, int end) {
    std::int64_t lost = 0;
    for (int y = begin; y < end; ++y) {
        throw_if_cancelled();
        for (int x = 0; x < ground_.nx; ++x) {
            const std::int64_t amount = bed.moving(x, y);
            if (amount == 0) continue;
            const auto& [along, across] = spread(x, y);
            const auto pieces = pieces_of(amount, along, across);
            const std::int64_t west = x + along.first;
            const bool inside = west >= 0 && west + 2 < ground_.nx;
            for (int j = 0; j < 3; ++j) {
                const int to_y = ground_.row(y + across.first + j);
                const std::int64_t* piece = pieces.data() + std::ptrdiff_t{3} * j;
                if (to_y < 0) {
                    lost += piece[0] + piece[1] + piece[2];
                } else if (inside) {
                    std::int64_t* to = &arrived_(static_cast<int>(west), to_y);
                    for (int i = 0; i < 3; ++i) to[i] += piece[i];
                } else {
                    for (int i = 0; i < 3; ++i) {
                        const int to_x = ground_.column(west + i);
                        if (to_x < 0) {
                            lost += piece[i];
                        } else {
                            arrived_(to_x, to_y) += piece[i];
                        }
                    }
                }
            }
        }
    }
    return lost;
}

/// Sand that hops in from beyond open edges.
void Saltation::add_influx(DuneBed& bed, const BlowingWind& wind, std::int64_t amount) {
    if (amount == 0 || (ground_.periodic_x && ground_.periodic_y)) return;
    const Spreads spreads(hops_, hops_.length * wind.x / ground_.dx,
                          hops_.length * wind.y / ground_.dy);
    const HopSpread& along = spreads.along;
    const HopSpread& across = spreads.across;
    const auto pieces = pieces_of(amount, along, across);
    const auto reach = [](const HopSpread& spread) {
        return std::max(std::abs(spread.first), std::abs(spread.first + 2));
    };
    const std::int64_t reach_x = ground_.periodic_x ? 0 : reach(along);
    const std::int64_t reach_y = ground_.periodic_y ? 0 : reach(across);
    const auto hop_in_from = [&](std::int64_t x, std::int64_t y) {
        for (std::size_t j = 0; j < 3; ++j) {
            const int to_y = ground_.row(y + across.first + static_cast<std::int64_t>(j));
            for (std::size_t i = 0; i < 3 && to_y >= 0; ++i) {
                const int to_x = ground_.column(x + along.first + static_cast<std::int64_t>(i));
                if (to_x < 0) continue;
                const std::int64_t piece = pieces[3 * j + i];
                arrived_(to_x, to_y) += piece;
                bed.inflow += piece;
            }
        }
    };
    for (std::int64_t y = -reach_y; y < ground_.ny + reach_y; ++y) {
        const bool beyond = y < 0 || y >= ground_.ny;
        for (std::int64_t x = -reach_x; x < ground_.nx + reach_x; ++x) {
            if (!beyond && x == 0) x = ground_.nx;
            if (x < ground_.nx + reach_x) hop_in_from(x, y);
        }
    }
}

}  // namespace fumon
