#include "models/dunes/setup/ground_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/units.h"
#include "models/dunes/setup/ravines.h"

namespace fumon {

namespace {

/// The way from one place to another along an axis, round a periodic one the shorter way.
double wrapped_distance(double from, double to, double size, bool periodic) {
    const double way = to - from;
    return periodic ? way - size * std::floor(way / size + 0.5) : way;
}

double shape_at(FeatureShape shape, double u, double v) {
    if (shape == FeatureShape::block) return std::max(std::abs(u), std::abs(v)) <= 1.0 ? 1.0 : 0.0;
    const double r = std::sqrt(u * u + v * v);
    if (r >= 1.0) return 0.0;
    if (shape == FeatureShape::cone) return 1.0 - r;
    const double cosine = elementary::cos(0.5 * std::numbers::pi * r);
    return cosine * cosine;
}

double width_of(const DuneFeature& feature) {
    return feature.width > 0.0 ? feature.width : feature.length;
}

/// Of each cell's middle, how many metres along and across the feature's axis it lies.
template <typename Do>
void for_each_place(const DuneFeature& feature, const DuneGround& ground, Do&& act) {
    const double east = elementary::sin(feature.axis * degree);
    const double north = elementary::cos(feature.axis * degree);
    for (int y = 0; y < ground.ny; ++y) {
        const double up = wrapped_distance(feature.y, (y + 0.5) * ground.dy, ground.ny * ground.dy,
                                           ground.periodic_y);
        for (int x = 0; x < ground.nx; ++x) {
            const double right = wrapped_distance(feature.x, (x + 0.5) * ground.dx,
                                                  ground.nx * ground.dx, ground.periodic_x);
            act(x, y, right * east + up * north, right * north - up * east);
        }
    }
}

}  // namespace

Grid feature_shape(const DuneFeature& feature, const DuneGround& ground) {
    Grid shape(ground.nx, ground.ny);
    const double half_length = 0.5 * feature.length;
    const double half_width = 0.5 * width_of(feature);
    for_each_place(feature, ground, [&](int x, int y, double along, double across) {
        shape(x, y) = shape_at(feature.shape, along / half_length, across / half_width);
    });
    return shape;
}

void cut_ravines(Grid& shape, const DuneFeature& feature, const DuneGround& ground,
                 std::uint64_t seed, std::uint32_t rock) {
    if (feature.ravines <= 0.0) return;
    constexpr double apart = 0.3;   // of the shorter side
    constexpr double finest = 3.0;  // cells
    const Ravines ravines(seed, rock, apart * std::min(feature.length, width_of(feature)),
                          finest * std::max(ground.dx, ground.dy));
    for_each_place(feature, ground, [&](int x, int y, double along, double across) {
        if (shape(x, y) > 0.0)
            shape(x, y) *= 1.0 - feature.ravines * ravines.depth_at(along, across);
    });
}

void set_features(const std::vector<DuneFeature>& features, const DuneGround& ground,
                  std::uint64_t seed, DuneBed& bed) {
    std::uint32_t number = 0;
    for (const DuneFeature& feature : features) {
        ++number;
        if (feature.kind != FeatureKind::rock && feature.kind != FeatureKind::sand &&
            feature.kind != FeatureKind::source)
            continue;
        Grid shape = feature_shape(feature, ground);
        cut_ravines(shape, feature, ground, seed, number);
        for (std::size_t cell = 0; cell < shape.size(); ++cell) {
            const std::int64_t height = to_units(feature.height * shape.values()[cell]);
            std::int64_t& surface = bed.surface.values()[cell];
            std::int64_t& rock = bed.rock.values()[cell];
            if (feature.kind == FeatureKind::rock) {
                rock += height;
                surface = std::max(surface, rock);
            } else {
                surface += height;
            }
        }
    }
}

FixedPointGrid sources_of(const std::vector<DuneFeature>& features, const DuneGround& ground) {
    FixedPointGrid sources;
    for (const DuneFeature& feature : features) {
        if (feature.kind != FeatureKind::source) continue;
        if (sources.empty()) sources = FixedPointGrid(ground.nx, ground.ny);
        const Grid shape = feature_shape(feature, ground);
        for (std::size_t cell = 0; cell < shape.size(); ++cell)
            sources.values()[cell] += to_units(feature.height * shape.values()[cell]);
    }
    return sources;
}

}  // namespace fumon
