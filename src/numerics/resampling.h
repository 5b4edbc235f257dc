#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// The cells whose mask is not 0 beside one whose mask is, among the eight around each, row by row:
/// their numbers.
inline std::vector<std::size_t> cells_beside_known(const Mask& unknown) {
    const int nx = unknown.nx();
    const int ny = unknown.ny();
    const auto width = static_cast<std::size_t>(nx);
    std::vector<std::size_t> cells;
    std::vector<std::uint8_t> known(width + 2);  // in three rows, with a cell before and after
    for (int y = 0; y < ny; ++y) {
        const auto south = unknown.row(std::max(y - 1, 0));
        const auto here = unknown.row(y);
        const auto north = unknown.row(std::min(y + 1, ny - 1));
        for (std::size_t x = 0; x < width; ++x)
            known[x + 1] = south[x] == 0 || here[x] == 0 || north[x] == 0 ? 1 : 0;
        for (std::size_t x = 0; x < width; ++x) {
            if (here[x] != 0 && (known[x] | known[x + 1] | known[x + 2]) != 0)
                cells.push_back(static_cast<std::size_t>(y) * width + x);
        }
    }
    return cells;
}

/// Continues values of a masked domain outward over a few cells by averages of known neighbours, so
/// that resampling near its rim meets no foreign values; cells farther out get `farther`.
template <class Number>
void extrapolate_outward(Field<Number>& z, const Mask& nodata, Number farther) {
    constexpr int rings_filled = 3;  // that the bicubic and slopes may touch
    constexpr std::uint8_t listed = 2;
    Mask unknown = nodata;
    for (std::uint8_t& cell : unknown.values()) cell = cell != 0 ? 1 : 0;
    const auto for_around = [&](std::size_t cell, const auto& visit) {
        const auto width = static_cast<std::size_t>(z.nx());
        const int at_x = static_cast<int>(cell % width);
        const int at_y = static_cast<int>(cell / width);
        for (int v = std::max(at_y - 1, 0); v <= std::min(at_y + 1, z.ny() - 1); ++v)
            for (int u = std::max(at_x - 1, 0); u <= std::min(at_x + 1, z.nx() - 1); ++u)
                visit(static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u));
    };
    std::vector<std::size_t> ring = cells_beside_known(unknown);
    for (int k = 0; k < rings_filled; ++k) {
        for (const std::size_t cell : ring) {
            Number sum{};
            int count = 0;
            for_around(cell, [&](std::size_t other) {
                if (unknown.values()[other] != 0) return;
                sum += z.values()[other];
                ++count;
            });
            z.values()[cell] = sum / static_cast<Number>(count);
        }
        for (const std::size_t cell : ring) unknown.values()[cell] = 0;
        if (k + 1 == rings_filled) break;
        std::vector<std::size_t> next;
        for (const std::size_t cell : ring) {
            for_around(cell, [&](std::size_t other) {
                std::uint8_t& state = unknown.values()[other];
                if (state == 0 || state == listed) return;
                state = listed;
                next.push_back(other);
            });
        }
        ring = std::move(next);
    }
    for (std::size_t i = 0; i < z.size(); ++i)
        if (unknown.values()[i] != 0) z.values()[i] = farther;
}

/// Resamples values to cells `refinement` times finer, whose centres divide the coarse cells
/// evenly, by an interpolating C¹ bicubic (Catmull & Rom 1974). Beyond the border the edge cells
/// are repeated.
template <class Number>
Field<Number> refined(const Field<Number>& values, int refinement) {
    if (refinement == 1) return values;
    struct Phase {  // weights of the four cells around a place in a cell, and the first one's
                    // offset
        int offset;
        std::array<Number, 4> weights;
    };
    std::vector<Phase> phases;
    for (int i = 0; i < refinement; ++i) {
        const double place = (i + 0.5) / refinement - 0.5;
        const int whole = place < 0.0 ? -1 : 0;
        const double t = place - whole;
        const auto weight = [](double value) { return static_cast<Number>(value); };
        phases.push_back(
            {whole - 1,
             {weight(0.5 * t * (-1.0 + t * (2.0 - t))),
              weight(0.5 * (2.0 + t * t * (-5.0 + 3.0 * t))),
              weight(0.5 * t * (1.0 + t * (4.0 - 3.0 * t))), weight(0.5 * t * t * (t - 1.0))}});
    }
    const int nx = values.nx();
    const int ny = values.ny();
    Field<Number> wide(nx * refinement, ny);
    for (int y = 0; y < ny; ++y) {
        const auto row = values.row(y);
        auto out = wide.row(y).begin();
        for (int x = 0; x < nx; ++x) {
            for (const Phase& phase : phases) {
                Number sum{};
                for (int i = 0; i < 4; ++i) {
                    const int from = std::clamp(x + phase.offset + i, 0, nx - 1);
                    sum += phase.weights[static_cast<std::size_t>(i)] *
                           row[static_cast<std::size_t>(from)];
                }
                *out++ = sum;
            }
        }
    }
    Field<Number> result(nx * refinement, ny * refinement);
    for (int y = 0; y < ny; ++y) {
        for (int part = 0; part < refinement; ++part) {
            const Phase& phase = phases[static_cast<std::size_t>(part)];
            std::array<const Number*, 4> from{};
            for (int i = 0; i < 4; ++i) {
                from[static_cast<std::size_t>(i)] =
                    wide.row(std::clamp(y + phase.offset + i, 0, ny - 1)).data();
            }
            Number* out = result.row(y * refinement + part).data();
            for (int x = 0; x < result.nx(); ++x) {
                out[x] = phase.weights[0] * from[0][x] + phase.weights[1] * from[1][x] +
                         phase.weights[2] * from[2][x] + phase.weights[3] * from[3][x];
            }
        }
    }
    return result;
}

/// A mask on cells `refinement` times finer: each cell divided.
inline Mask refined(const Mask& mask, int refinement) {
    if (mask.empty()) return {};
    Mask result(mask.nx() * refinement, mask.ny() * refinement);
    for (int y = 0; y < result.ny(); ++y) {
        for (int x = 0; x < result.nx(); ++x) result(x, y) = mask(x / refinement, y / refinement);
    }
    return result;
}

}  // namespace fumon
