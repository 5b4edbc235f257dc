#pragma once

#include <cstdint>

namespace fumon {

/// How deep ravines of weathered rock are at a place, 0 on a ridge … 1: the distance from their
/// nearest zero of fields of gradient noise (Perlin 1985), each of half the length and 0.55 of the
/// depth of the one before, so that ridges are sharp and what lies between them is rounded
/// (Musgrave 1994, ridged fractals).
class Ravines {
  public:
    /// The longest are `length` m apart, the shortest at least `shortest` m. Another `rock` of the
    /// same seed has others. Both lengths > 0.
    Ravines(std::uint64_t seed, std::uint32_t rock, double length, double shortest);

    [[nodiscard]] double depth_at(double x, double y) const;  ///< m, any origin

  private:
    [[nodiscard]] double noise_at(double x, double y, std::uint32_t octave) const;

    std::uint64_t seed_;
    std::uint32_t rock_;
    double length_;
    std::uint32_t octaves_ = 1;
};

}  // namespace fumon
