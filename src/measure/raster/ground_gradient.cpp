#include "measure/raster/ground_gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/elementary.h"
#include "base/elementary_angle.h"

namespace fumon {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Rise {
    double x = 0.0;  ///< a cell, eastward
    double y = 0.0;  ///< a cell, northward
    bool known = false;
};

/// Horn's weighted differences of a cell with eight neighbours.
Rise rise_inside(const Grid& ground, int x, int y) {
    const double west = ground(x - 1, y + 1) + 2.0 * ground(x - 1, y) + ground(x - 1, y - 1);
    const double east = ground(x + 1, y + 1) + 2.0 * ground(x + 1, y) + ground(x + 1, y - 1);
    const double south = ground(x - 1, y - 1) + 2.0 * ground(x, y - 1) + ground(x + 1, y - 1);
    const double north = ground(x - 1, y + 1) + 2.0 * ground(x, y + 1) + ground(x + 1, y + 1);
    return {(east - west) / 8.0, (north - south) / 8.0, true};
}

/// The sums of a least-squares plane through a cell. Those of places are whole numbers, so that it
/// is exact whether they lie on a line.
class PlaneThroughCell {
  public:
    void add(int x, int y, double rise) {
        const double weight = x == 0 || y == 0 ? 2.0 : 1.0;
        xx_ += weight * x * x;
        xy_ += weight * x * y;
        yy_ += weight * y * y;
        x_rise_ += weight * x * rise;
        y_rise_ += weight * y * rise;
        x_ = x;
        y_ = y;
    }

    [[nodiscard]] Rise rise(double dx, double dy) const {
        const double determinant = xx_ * yy_ - xy_ * xy_;
        if (determinant > 0.0) {
            return {(x_rise_ * yy_ - y_rise_ * xy_) / determinant,
                    (y_rise_ * xx_ - x_rise_ * xy_) / determinant, true};
        }
        if (xx_ + yy_ == 0.0) return {};
        // All along (x_, y_): as steep along that way, and level across it on the ground.
        const double along = (x_ * x_rise_ + y_ * y_rise_) / (xx_ + yy_);
        const double east = x_ * dx;
        const double north = y_ * dy;
        const double square = east * east + north * north;
        return {along * east * dx / square, along * north * dy / square, true};
    }

  private:
    double xx_ = 0.0;
    double xy_ = 0.0;
    double yy_ = 0.0;
    double x_rise_ = 0.0;
    double y_rise_ = 0.0;
    double x_ = 0.0;
    double y_ = 0.0;
};

}  // namespace

GroundGradient ground_gradient(const Grid& ground, const Mask& nodata, double dx, double dy) {
    const int nx = ground.nx();
    const int ny = ground.ny();
    GroundGradient gradient{Grid(nx, ny), Grid(nx, ny), Mask(nx, ny)};
    const auto known = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < nx && y < ny && (nodata.empty() || nodata(x, y) == 0);
    };
    constexpr std::array<int, 3> steps{-1, 0, 1};
    const auto rise_of = [&](int x, int y) -> Rise {
        if (!known(x, y)) return {};
        PlaneThroughCell plane;
        int neighbours = 0;
        for (const int j : steps) {
            for (const int i : steps) {
                if ((i == 0 && j == 0) || !known(x + i, y + j)) continue;
                plane.add(i, j, ground(x + i, y + j) - ground(x, y));
                ++neighbours;
            }
        }
        return neighbours == 8 ? rise_inside(ground, x, y) : plane.rise(dx, dy);
    };
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const bool inside = nodata.empty() && x > 0 && y > 0 && x + 1 < nx && y + 1 < ny;
            const Rise rise = inside ? rise_inside(ground, x, y) : rise_of(x, y);
            gradient.x(x, y) = rise.x / dx;
            gradient.y(x, y) = rise.y / dy;
            gradient.unknown(x, y) = rise.known ? 0 : 1;
        }
    }
    return gradient;
}

namespace {

/// A grid of what `value` makes of the rises of each cell.
template <class Value>
Grid of_each(const GroundGradient& gradient, Value value) {
    Grid result(gradient.x.nx(), gradient.x.ny());
    for (std::size_t cell = 0; cell < result.size(); ++cell)
        result.values()[cell] = value(gradient.x.values()[cell], gradient.y.values()[cell]);
    return result;
}

}  // namespace

Grid slope_ratio(const GroundGradient& gradient) {
    return of_each(gradient, [](double x, double y) { return elementary::hypot(x, y); });
}

Grid slope_degrees(const GroundGradient& gradient) {
    return of_each(gradient, [](double x, double y) {
        return elementary::atan(elementary::hypot(x, y)) / degree;
    });
}

Grid aspect_degrees(const GroundGradient& gradient) {
    return of_each(gradient, [](double x, double y) {
        if (x == 0.0 && y == 0.0) return 0.0;
        const double angle = elementary::atan2(-x, -y) / degree;
        const double turned = angle < 0.0 ? angle + 360.0 : angle;
        return turned >= 360.0 ? 0.0 : turned + 0.0;  // without the sign of zero
    });
}

Mask without_aspect(const GroundGradient& gradient) {
    Mask mask = gradient.unknown;
    for (std::size_t cell = 0; cell < mask.size(); ++cell) {
        if (gradient.x.values()[cell] == 0.0 && gradient.y.values()[cell] == 0.0)
            mask.values()[cell] = 1;
    }
    return mask;
}

Grid hillshade(const GroundGradient& gradient, const HillLight& light) {
    const double level = elementary::cos(light.elevation * degree);
    const double up = elementary::sin(light.elevation * degree);
    const double east = level * elementary::sin(light.azimuth * degree);
    const double north = level * elementary::cos(light.azimuth * degree);
    return of_each(gradient, [&](double x, double y) {
        const double rise_x = light.exaggeration * x;
        const double rise_y = light.exaggeration * y;
        const double cosine = (up - east * rise_x - north * rise_y) /
                              std::sqrt(1.0 + rise_x * rise_x + rise_y * rise_y);
        return 1.0 + 254.0 * std::max(0.0, cosine);
    });
}

}  // namespace fumon
