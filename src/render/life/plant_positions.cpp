#include "render/life/plant_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/random.h"
#include "base/snapshot_lookup.h"

namespace fumon {

namespace {

constexpr double tufts_per_square_metre = 5.0;
constexpr double shrubs_per_square_metre = 0.8;
constexpr double max_per_cell = 40.0;
constexpr float lowest_threshold = 0.04F;  // of the cover, at which the first plant comes up

/// Shares 0 … 1 that belong to a place of a cell, whatever grows there.
std::array<float, 8> shares_of(int x, int y, std::uint32_t position, PlantKind kind) {
    std::array<float, 8> shares{};
    for (std::uint32_t half = 0; half < 2; ++half) {
        const auto words = philox4x32({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                       position, 2 * static_cast<std::uint32_t>(kind) + half},
                                      {1, 0});
        for (std::size_t i = 0; i < 4; ++i)
            shares.at(4 * half + i) = static_cast<float>(words[i] >> 8U) * 0x1p-24F;
    }
    return shares;
}

/// How many could stand in each cell, and how high.
struct Stand {
    PlantKind kind;
    const Grid* cover;
    int positions;
    float used;    ///< share of the places at which there is a plant at all
    float height;  ///< block lengths
};

}  // namespace

std::vector<Plant> plant_positions(const Snapshot& snapshot, const Block& block, double share) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    std::vector<Plant> found;
    const double metre = (snapshot.scale.in_metres ? 1.0 : snapshot.scale.dx) / block.side;
    const double area = snapshot.scale.in_metres ? snapshot.scale.dx * snapshot.scale.dy : 1.0;
    std::vector<Stand> stands;
    const auto stand = [&](PlantKind kind, const char* field, double density, double height) {
        const Grid* cover = field_of(snapshot.fields, field);
        if (cover == nullptr) return;
        const double count = std::min(density * area, max_per_cell);
        const double slots = std::ceil(count);
        stands.push_back({kind, cover, static_cast<int>(slots),
                          static_cast<float>(share * count / slots),
                          static_cast<float>(height * metre)});
    };
    stand(PlantKind::grass, "grass", tufts_per_square_metre, snapshot.grass_height);
    stand(PlantKind::shrub, "shrubs", shrubs_per_square_metre, snapshot.shrub_height);
    if (stands.empty() || share <= 0.0) return found;

    const glm::vec2 cell(block.width_x / nx, block.width_y / ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            for (const Stand& one : stands) {
                const auto cover = static_cast<float>((*one.cover)(x, y));
                if (cover <= lowest_threshold) continue;
                for (int position = 0; position < one.positions; ++position) {
                    const auto shares =
                        shares_of(x, y, static_cast<std::uint32_t>(position), one.kind);
                    const float over = cover - (lowest_threshold + 0.9F * shares[0]);
                    if (over <= 0.0F || shares[1] >= one.used) continue;
                    Plant plant;
                    plant.kind = one.kind;
                    plant.position = cell * glm::vec2(static_cast<float>(x) + shares[2],
                                                      static_cast<float>(y) + shares[3]);
                    const float grown = std::min(over / 0.3F, 1.0F);
                    plant.height = one.height * (0.55F + 0.45F * shares[4]) *
                                   (0.35F + 0.65F * grown) * std::min(over / 0.05F, 1.0F);
                    plant.turn = 2.0F * std::numbers::pi_v<float> * shares[5];
                    plant.rank = shares[6];
                    found.push_back(plant);
                }
            }
        }
    }
    return found;
}

}  // namespace fumon
