#pragma once

#include <array>
#include <cstddef>

namespace fumon {

/// How fast the cover of a species grows against the balance of sand, the rate at which the ground
/// rises: linear between five points, at which it is −1, 0, `growth`, 0 and −1 a year (Baas 2002;
/// Nield & Baas 2008). The outer lines go on beyond the first and the last point, where the
/// published law, applied once a year to a cover of at most 1, ends in any case.
struct GrowthLaw {
    std::array<double, 5> balances{};  ///< m/yr, rising
    double growth = 0.0;               ///< 1/yr

    /// 1/yr, at a balance in m/yr.
    [[nodiscard]] double at(double balance) const {
        const std::array<double, 5> rates{-1.0, 0.0, growth, 0.0, -1.0};
        std::size_t leg = 0;
        while (leg + 2 < balances.size() && balance > balances[leg + 1]) ++leg;
        const double share = (balance - balances[leg]) / (balances[leg + 1] - balances[leg]);
        return rates[leg] + share * (rates[leg + 1] - rates[leg]);
    }
};

}  // namespace fumon
