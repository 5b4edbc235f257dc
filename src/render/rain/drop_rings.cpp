#include "render/rain/drop_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/random.h"
#include "base/rounding.h"
#include "base/truncation.h"

namespace fumon {

namespace {

// Drops fall in slots of time, of a length that is exact in binary.
constexpr double slot = 0.125;         // s
constexpr int slots_per_lifetime = 7;  // that reach into ring_lifetime_s

constexpr double visible_drops_per_mm = 3.3;  // per m² and s, for each mm/h
constexpr double heaviest_rain = 200.0;       // mm/h: beyond it there is no room between rings

// A group of waves of capillarity and gravity. The slowest of them, 17 mm long, go 0.23 m/s; those
// ahead and behind draw the group out.
constexpr double ring_wavelength_m = 0.022;     // m
constexpr double ring_speed_m_per_s = 0.23;     // m/s
constexpr double initial_width_m = 0.009;       // m, half of the group
constexpr double width_growth_m_per_s = 0.030;  // m/s
constexpr double steepness = 0.75;              // where it starts
constexpr double damping_time_s = 0.40;         // s
constexpr double spreading_radius_m = 0.020;    // m: beyond it a ring lowers as it widens
constexpr double widths_drawn = 2.2;            // to each side of the crest
constexpr double two_pi = 6.283185307179586;

constexpr int profile_points = 256;

/// The slope of a ring outward, from its middle to `reach`.
struct RingProfile {
    double reach = 0.0;  // m
    std::array<float, profile_points + 1> slope{};

    explicit RingProfile(const FallenDrop& drop) {
        const double radius = ring_speed_m_per_s * drop.age;
        const double width = initial_width_m + width_growth_m_per_s * drop.age;
        reach = radius + widths_drawn * width;
        const double left = 1.0 - drop.age / ring_lifetime_s;
        const double height = steepness * drop.size * left *
                              elementary::exp(-drop.age / damping_time_s) *
                              std::sqrt(spreading_radius_m / std::max(spreading_radius_m, radius));
        for (int i = 0; i < profile_points; ++i) {
            const double off = reach * i / profile_points - radius;
            const double group = elementary::exp(-(off / width) * (off / width));
            slope[static_cast<std::size_t>(i)] = static_cast<float>(
                height * group * elementary::cos(two_pi * off / ring_wavelength_m));
        }
    }

    [[nodiscard]] float at(float distance) const {
        const float position = distance * static_cast<float>(profile_points / reach);
        const int before = static_cast<int>(position);
        if (before >= profile_points) return 0.0F;
        const auto i = static_cast<std::size_t>(before);
        return slope[i] + (position - static_cast<float>(before)) * (slope[i + 1] - slope[i]);
    }
};

/// Slopes east and north.
struct Slopes {
    std::vector<float> x;
    std::vector<float> y;
};

void add_ring(const FallenDrop& drop, Slopes& slopes) {
    constexpr double texel = ring_tile_m / ring_texels;
    const RingProfile profile(drop);
    const int low_x = static_cast<int>(std::floor((drop.x - profile.reach) / texel));
    const int low_y = static_cast<int>(std::floor((drop.y - profile.reach) / texel));
    const int across = static_cast<int>(2.0 * profile.reach / texel) + 2;
    const auto wrapped = [](int at) {
        return static_cast<std::size_t>((at + ring_texels) % ring_texels);
    };
    for (int j = low_y; j <= low_y + across; ++j) {
        const std::size_t row = wrapped(j) * ring_texels;
        const auto north = static_cast<float>((j + 0.5) * texel - drop.y);
        for (int i = low_x; i <= low_x + across; ++i) {
            const auto east = static_cast<float>((i + 0.5) * texel - drop.x);
            const float distance = std::sqrt(east * east + north * north);
            const float slope = profile.at(distance) / std::max(distance, 1e-4F);
            slopes.x[row + wrapped(i)] += slope * east;
            slopes.y[row + wrapped(i)] += slope * north;
        }
    }
}

Slopes rings_on_tile(double time, double rate) {
    constexpr auto texels = static_cast<std::size_t>(ring_texels) * ring_texels;
    Slopes slopes{std::vector<float>(texels), std::vector<float>(texels)};
    for (const FallenDrop& drop : fallen_drops(time, rate)) add_ring(drop, slopes);
    return slopes;
}

std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(nearest(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

std::vector<std::uint8_t> finest_level(const Slopes& slopes) {
    constexpr auto to_half = static_cast<float>(0.5 / max_ring_slope);
    constexpr auto to_whole = static_cast<float>(1.0 / max_ring_mean_square_slope);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * slopes.x.size());
    for (std::size_t i = 0; i < slopes.x.size(); ++i) {
        const float x = slopes.x[i];
        const float y = slopes.y[i];
        bytes.insert(bytes.end(), {byte_of(0.5F + to_half * x), byte_of(0.5F + to_half * y),
                                   byte_of(to_whole * (x * x + y * y)), std::uint8_t{255}});
    }
    return bytes;
}

/// The means of four texels each, of a square.
std::vector<std::uint8_t> downsampled(const std::vector<std::uint8_t>& finer, std::size_t side) {
    std::vector<std::uint8_t> bytes(finer.size() / 4);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t row = i / (2 * side);
        const std::size_t column = i / 4 % (side / 2);
        const std::size_t at = 4 * (2 * row * side + 2 * column) + i % 4;
        const int sum = finer[at] + finer[at + 4] + finer[at + 4 * side] + finer[at + 4 * side + 4];
        bytes[i] = static_cast<std::uint8_t>((sum + 2) / 4);
    }
    return bytes;
}

}  // namespace

double ring_drop_rate(double rate) {
    return visible_drops_per_mm * std::min(rate, heaviest_rain);
}

std::vector<FallenDrop> fallen_drops(double time, double rate) {
    constexpr std::uint64_t any_seed = 1;
    const double a_slot = ring_drop_rate(rate) / ring_layers * ring_tile_m * ring_tile_m * slot;
    const auto last = std::int64_t{truncated(std::floor(time / slot))};
    std::vector<FallenDrop> drops;
    for (std::int64_t number = last - slots_per_lifetime; number <= last; ++number) {
        RandomStream stream(any_seed, 0, number, Purpose::raindrops);
        const int count = static_cast<int>(a_slot + stream.uniform());
        for (int i = 0; i < count; ++i) {
            FallenDrop drop{};
            drop.x = ring_tile_m * stream.uniform();
            drop.y = ring_tile_m * stream.uniform();
            drop.age = time - (static_cast<double>(number) + stream.uniform()) * slot;
            drop.size = 0.5 + stream.uniform();
            if (drop.age >= 0.0 && drop.age < ring_lifetime_s) drops.push_back(drop);
        }
    }
    return drops;
}

std::vector<std::vector<std::uint8_t>> ring_tile_levels(double time, double rate) {
    std::vector<std::vector<std::uint8_t>> levels{finest_level(rings_on_tile(time, rate))};
    for (int side = ring_texels; side > 1; side /= 2)
        levels.push_back(downsampled(levels.back(), static_cast<std::size_t>(side)));
    return levels;
}

}  // namespace fumon
