#include "render/land/wandering_coast.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "numerics/smooth_step.h"
#include "numerics/tension_surface.h"

namespace fumon {

namespace {

constexpr float coast_edge_within = 1.5F;  // cells
constexpr int not_alone = 3;               // cells of 5 × 5
constexpr double widening = 1.5;           // of the sea's distance: how much farther its shores lie
constexpr double mean_reach = 0.64;        // of the margin: land, on average
constexpr double most_wander = 0.3;        // of the margin: headlands and bays
constexpr double nearer = 0.3;             // of the distance from the edge, at most
constexpr double most_shift = 0.25;        // of the margin: of shores that run outwards
constexpr double shifted = 0.6;            // of the distance from the edge, at most
constexpr double wander_begins_within = 8.0;
constexpr double end_share = 0.15;     // of the margin: where no land is left
constexpr double longest_share = 1.6;  // of the margin: waves of the shore
constexpr double shortest_wave = 8.0;  // cells
constexpr int waves_per_octave = 7;
constexpr double shore_roughness = 0.7;  // exponent of amplitude over wave length
constexpr double by_chance = 0.5;        // of the noise: else bays that leave no side of it out
constexpr double bay_share = 0.35;       // of the longest wave
constexpr double bend = 2.5;             // of a bay's phase
constexpr std::uint64_t coast_seed = 17;

/// Waves in all directions that fit into a periodic lattice, from `longest` cells down, within −1 …
/// 1.
Grid noise_of_waves(int nx, int ny, double longest, std::uint32_t which) {
    Grid noise(nx, ny);
    RandomStream stream(coast_seed, which, 1, Purpose::plain);
    constexpr double turn = 2.0 * std::numbers::pi;
    std::vector<double> sines(static_cast<std::size_t>(nx));
    std::vector<double> cosines(static_cast<std::size_t>(nx));
    double power = 0.0;
    double amplitude = 1.0;
    const double smaller = elementary::exp(-shore_roughness * std::numbers::ln2);
    for (double length = longest; length >= shortest_wave; length *= 0.5) {
        for (int wave = 0; wave < waves_per_octave; ++wave) {
            const double direction = turn * (wave + stream.uniform()) / waves_per_octave;
            const double own = length * (0.7 + 0.6 * stream.uniform());
            const double begin = turn * stream.uniform();
            const double east = turn * std::round(elementary::cos(direction) * nx / own) / nx;
            const double north = turn * std::round(elementary::sin(direction) * ny / own) / ny;
            for (int x = 0; x < nx; ++x) {
                sines[static_cast<std::size_t>(x)] = elementary::sin(begin + east * x);
                cosines[static_cast<std::size_t>(x)] = elementary::cos(begin + east * x);
            }
            for (int y = 0; y < ny; ++y) {
                const double in_phase = amplitude * elementary::cos(north * y);
                const double aside = amplitude * elementary::sin(north * y);
                const auto row = noise.row(y);
                for (std::size_t x = 0; x < row.size(); ++x)
                    row[x] += sines[x] * in_phase + cosines[x] * aside;
            }
            power += 0.5 * amplitude * amplitude;
        }
        amplitude *= smaller;
    }
    const double scale = power > 0.0 ? 1.0 / std::sqrt(power) : 0.0;
    const double along_x = turn * std::max(std::round(nx / (bay_share * longest)), 1.0) / nx;
    const double along_y = turn * std::max(std::round(ny / (bay_share * longest)), 1.0) / ny;
    std::vector<double>& bends = sines;
    for (int x = 0; x < nx; ++x)
        bends[static_cast<std::size_t>(x)] = bend * elementary::sin(turn * 3.0 * x / nx);
    for (int y = 0; y < ny; ++y) {
        const double aside = bend * elementary::sin(turn * 3.0 * y / ny + 0.7);
        for (int x = 0; x < nx; ++x) {
            const double share = scale * noise(x, y);
            noise(x, y) = by_chance * share / std::sqrt(1.0 + share * share) +
                          0.5 * (1.0 - by_chance) *
                              (elementary::sin(along_x * x + aside) +
                               elementary::sin(along_y * y + bends[static_cast<std::size_t>(x)]));
        }
    }
    return noise;
}

/// Between the four nearest cells, those of the lattice's end beyond it.
double between_cells(const Field<float>& field, double x, double y) {
    const double u = std::clamp(x, 0.0, field.nx() - 1.001);
    const double v = std::clamp(y, 0.0, field.ny() - 1.001);
    const int west = static_cast<int>(u);
    const int south = static_cast<int>(v);
    const auto row = [&](int at) {
        return std::lerp(static_cast<double>(field(west, at)),
                         static_cast<double>(field(west + 1, at)), u - west);
    };
    return std::lerp(row(south), row(south + 1), v - south);
}

/// The lesser one, rounded where they differ by less than `over`.
double rounded_min(double a, double b, double over) {
    const double h = std::max(over - std::abs(a - b), 0.0) / over;
    return std::min(a, b) - 0.25 * over * h * h;
}

}  // namespace

double eased_rise(double at, double slope, double most) {
    if (!(most > 0.0)) return 0.0;
    const double t = std::clamp(0.5 * slope * at / most, 0.0, 1.0);
    return most * t * (2.0 - t);
}

Grid inland_distances(const CoastEdge& edge) {
    const Field<float> to_sea = distances_to(edge.sea);
    const Field<float> to_land = distances_to(edge.land);
    const int nx = edge.sea.nx();
    const int ny = edge.sea.ny();
    const double margin = edge.margin;
    const auto distance = [&](const Field<float>& field, double x, double y) {
        return std::min(between_cells(field, x, y), 4.0 * margin);
    };
    const Grid noise = noise_of_waves(nx, ny, longest_share * margin, 0);
    const Grid east = noise_of_waves(nx, ny, longest_share * margin, 1);
    const Grid north = noise_of_waves(nx, ny, longest_share * margin, 2);
    Grid inland(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double away = std::min(distance(to_sea, x, y), distance(to_land, x, y));
            const double begun = smooth_step(0.0, wander_begins_within, away);
            // Where shores run outwards they are shifted, so that no inlet is closed.
            const double shift = begun * eased_rise(away, shifted, most_shift * margin);
            const double u = x + shift * east(x, y);
            const double v = y + shift * north(x, y);
            const double sea = distance(to_sea, u, v);
            const double land = distance(to_land, u, v);
            const double off_sea = (sea - land) / std::max(sea + land, 1.0);
            const double grows = nearer + (1.0 - nearer) * std::max(off_sea, 0.0);
            const double wanders = begun * eased_rise(away, grows, most_wander * margin);
            const double ends = 1.0 - smooth_step(0.0, end_share * margin,
                                                  static_cast<double>(edge.from_end(x, y)));
            inland(x, y) =
                rounded_min(sea - widening * land, mean_reach * margin - away, 0.3 * margin) +
                wanders * noise(x, y) - 0.6 * margin * ends;
        }
    }
    return inland;
}

Mask edge_in_sea(const Grid& heights, const Field<float>& depth, double level) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    const auto is_sea = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < nx && y < ny && depth(x, y) > 0.0F &&
               depth(x, y) <= coast_edge_within && heights(x, y) <= level;
    };
    Mask sea(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (!is_sea(x, y)) continue;
            int beside = 0;
            for (int v = y - 2; v <= y + 2; ++v)
                for (int u = x - 2; u <= x + 2; ++u) beside += is_sea(u, v) ? 1 : 0;
            sea(x, y) = beside >= not_alone ? 1 : 0;
        }
    }
    return sea;
}

}  // namespace fumon
