#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/geo_reference.h"
#include "base/huge_pages.h"

namespace fumon {

/// A field f(x, y) on nx × ny cells, x fastest in memory. x grows east, y grows north: row 0 is the
/// southernmost. A plain value.
template <class Number>
class Field {
  public:
    Field() = default;
    Field(int nx, int ny, Number value = Number{})
        : nx_(nx),
          ny_(ny),
          values_(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), value) {}

    [[nodiscard]] int nx() const { return nx_; }
    [[nodiscard]] int ny() const { return ny_; }
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool empty() const { return values_.empty(); }

    Number& operator()(int x, int y) { return values_[index(x, y)]; }
    const Number& operator()(int x, int y) const { return values_[index(x, y)]; }

    /// The nx values of row y.
    std::span<Number> row(int y) {
        return {values_.data() + index(0, y), static_cast<std::size_t>(nx_)};
    }
    [[nodiscard]] std::span<const Number> row(int y) const {
        return {values_.data() + index(0, y), static_cast<std::size_t>(nx_)};
    }

    /// All nx·ny values, row 0 first. Not of a temporary, whose values would be gone.
    std::span<Number> values() & { return values_; }
    [[nodiscard]] std::span<const Number> values() const& { return values_; }
    std::span<const Number> values() && = delete;
    Number* data() { return values_.data(); }
    [[nodiscard]] const Number* data() const { return values_.data(); }

    friend bool operator==(const Field&, const Field&) = default;

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
               static_cast<std::size_t>(x);
    }

    int nx_ = 0;
    int ny_ = 0;
    std::vector<Number, HugePageAllocator<Number>> values_;
};

using Grid = Field<double>;

/// 1 where a cell lies outside the domain (no data), 0 inside; empty when every cell is inside.
using Mask = Field<std::uint8_t>;

/// How sites and model heights relate to metres. Without `in_metres` one site and one model height
/// are the units themselves, and axes read "sites".
struct WorldScale {
    double dx = 1.0;           ///< cell size eastward, metres (or sites)
    double dy = 1.0;           ///< cell size northward, metres (or sites)
    double height_unit = 1.0;  ///< metres per model height
    bool in_metres = false;
    std::optional<GeoReference> place{};  ///< where the grid lies; none of a grid that lies nowhere

    friend bool operator==(const WorldScale&, const WorldScale&) = default;
};

}  // namespace fumon
