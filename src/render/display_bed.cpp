#include "render/display_bed.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fumon {

namespace {

constexpr int smooth_enough = 400;  // cells along the longer side
constexpr int rings_filled = 3;     // cells around the domain that the bicubic and slopes may touch

/// Weights of the four cells around each of the `refinement` places in a cell, and the offset of
/// the first of them.
struct Phase {
    int offset;
    std::array<float, 4> weights;
};

std::vector<Phase> phases_of(int refinement) {
    std::vector<Phase> phases;
    for (int i = 0; i < refinement; ++i) {
        const double place = (i + 0.5) / refinement - 0.5;
        const int whole = place < 0.0 ? -1 : 0;
        const double t = place - whole;
        const auto weight = [](double value) { return static_cast<float>(value); };
        phases.push_back(
            {whole - 1,
             {weight(0.5 * t * (-1.0 + t * (2.0 - t))),
              weight(0.5 * (2.0 + t * t * (-5.0 + 3.0 * t))),
              weight(0.5 * t * (1.0 + t * (4.0 - 3.0 * t))), weight(0.5 * t * t * (t - 1.0))}});
    }
    return phases;
}

}  // namespace

void continue_outward(Field<float>& z, const Mask& nodata, float farther) {
    Mask unknown = nodata;
    for (int ring = 0; ring < rings_filled; ++ring) {
        const Mask before = unknown;
        for (int y = 0; y < z.ny(); ++y) {
            for (int x = 0; x < z.nx(); ++x) {
                if (before(x, y) == 0) continue;
                float sum = 0.0F;
                int count = 0;
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, z.ny() - 1); ++v) {
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, z.nx() - 1); ++u) {
                        if (before(u, v) != 0) continue;
                        sum += z(u, v);
                        ++count;
                    }
                }
                if (count == 0) continue;
                z(x, y) = sum / static_cast<float>(count);
                unknown(x, y) = 0;
            }
        }
    }
    for (std::size_t i = 0; i < z.size(); ++i)
        if (unknown.values()[i] != 0) z.values()[i] = farther;
}

int refinement_of(int nx, int ny, int picture_side) {
    const int longer = std::max(nx, ny);
    const int wanted = std::min(smooth_enough, picture_side);
    return std::clamp((wanted + longer - 1) / longer, 1, 32);
}

Field<float> refined(const Field<float>& heights, int refinement) {
    if (refinement == 1) return heights;
    const std::vector<Phase> phases = phases_of(refinement);
    const int nx = heights.nx();
    const int ny = heights.ny();
    Field<float> wide(nx * refinement, ny);
    for (int y = 0; y < ny; ++y) {
        const auto row = heights.row(y);
        auto out = wide.row(y).begin();
        for (int x = 0; x < nx; ++x) {
            for (const Phase& phase : phases) {
                float sum = 0.0F;
                for (int i = 0; i < 4; ++i) {
                    const int from = std::clamp(x + phase.offset + i, 0, nx - 1);
                    sum += phase.weights[static_cast<std::size_t>(i)] *
                           row[static_cast<std::size_t>(from)];
                }
                *out++ = sum;
            }
        }
    }
    Field<float> result(nx * refinement, ny * refinement);
    for (int y = 0; y < ny; ++y) {
        for (int part = 0; part < refinement; ++part) {
            const Phase& phase = phases[static_cast<std::size_t>(part)];
            std::array<const float*, 4> from{};
            for (int i = 0; i < 4; ++i) {
                from[static_cast<std::size_t>(i)] =
                    wide.row(std::clamp(y + phase.offset + i, 0, ny - 1)).data();
            }
            float* out = result.row(y * refinement + part).data();
            for (int x = 0; x < result.nx(); ++x) {
                out[x] = phase.weights[0] * from[0][x] + phase.weights[1] * from[1][x] +
                         phase.weights[2] * from[2][x] + phase.weights[3] * from[3][x];
            }
        }
    }
    return result;
}

DisplayBed display_bed(const Snapshot& snapshot, const Block& block, int refinement) {
    const Grid& bed = snapshot.bed;
    Field<float> z(bed.nx(), bed.ny());
    std::transform(bed.values().begin(), bed.values().end(), z.values().begin(),
                   [&](double height) { return static_cast<float>(block.z(height)); });
    DisplayBed shown;
    if (!snapshot.nodata.empty()) {
        continue_outward(z, snapshot.nodata, static_cast<float>(block.base));
        shown.nodata = Mask(bed.nx() * refinement, bed.ny() * refinement);
        for (int y = 0; y < shown.nodata.ny(); ++y) {
            for (int x = 0; x < shown.nodata.nx(); ++x)
                shown.nodata(x, y) = snapshot.nodata(x / refinement, y / refinement);
        }
    }
    shown.z = refined(z, refinement);
    shown.dx = static_cast<float>(block.width_x / shown.z.nx());
    shown.dy = static_cast<float>(block.width_y / shown.z.ny());
    return shown;
}

}  // namespace fumon
