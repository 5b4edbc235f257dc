#include "models/dunes/setup/ravines.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace fumon {

namespace {

constexpr double depth_ratio = 0.55;  // of each field to the one before
constexpr std::uint32_t most_octaves = 16;

double rounded_step(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double between(double from, double to, double t) {
    return from + t * (to - from);
}

double signed_unit(std::uint32_t word) {
    return static_cast<double>(word) * 0x1p-31 - 1.0;
}

}  // namespace

Ravines::Ravines(std::uint64_t seed, std::uint32_t rock, double length, double shortest)
    : seed_(seed), rock_(rock), length_(length) {
    while (octaves_ < most_octaves && length / static_cast<double>(1U << octaves_) >= shortest)
        ++octaves_;
}

double Ravines::noise_at(double x, double y, std::uint32_t octave) const {
    const double west = std::floor(x);
    const double south = std::floor(y);
    const auto corner = [&](int east, int north) {
        const auto column = static_cast<std::uint32_t>(static_cast<std::int64_t>(west) + east);
        const auto row = static_cast<std::uint32_t>(static_cast<std::int64_t>(south) + north);
        const auto words = philox4x32(
            {column, row, rock_ << 5U | octave, static_cast<std::uint32_t>(Purpose::ravines)},
            {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32U)});
        return signed_unit(words[0]) * (x - west - east) +
               signed_unit(words[1]) * (y - south - north);
    };
    const double along = rounded_step(x - west);
    return between(between(corner(0, 0), corner(1, 0), along),
                   between(corner(0, 1), corner(1, 1), along), rounded_step(y - south));
}

double Ravines::depth_at(double x, double y) const {
    constexpr double usual = 3.0;  // of what |noise| hardly exceeds a third
    double depth = 0.0;
    double whole = 0.0;
    double share = 1.0;
    double scale = 1.0 / length_;
    for (std::uint32_t octave = 0; octave < octaves_; ++octave) {
        depth += share * std::min(usual * std::abs(noise_at(x * scale, y * scale, octave)), 1.0);
        whole += share;
        share *= depth_ratio;
        scale *= 2.0;
    }
    return depth / whole;
}

}  // namespace fumon
