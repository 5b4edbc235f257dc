#include "models/dunes/ground_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/units.h"

namespace fumon {

namespace {

/// The way from one place to another along an axis, round a periodic one the shorter way.
double way_between(double from, double to, double size, bool periodic) {
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

}  // namespace

Grid feature_shape(const DuneFeature& feature, const DuneGround& ground) {
    Grid shape(ground.nx, ground.ny);
    const double east = elementary::sin(feature.axis * degree);
    const double north = elementary::cos(feature.axis * degree);
    const double half_length = 0.5 * feature.length;
    const double half_width = feature.width > 0.0 ? 0.5 * feature.width : half_length;
    for (int y = 0; y < ground.ny; ++y) {
        const double across =
            way_between(feature.y, (y + 0.5) * ground.dy, ground.ny * ground.dy, ground.periodic_y);
        for (int x = 0; x < ground.nx; ++x) {
            const double along = way_between(feature.x, (x + 0.5) * ground.dx,
                                             ground.nx * ground.dx, ground.periodic_x);
            shape(x, y) = shape_at(feature.shape, (along * east + across * north) / half_length,
                                   (along * north - across * east) / half_width);
        }
    }
    return shape;
}

void set_features(const std::vector<DuneFeature>& features, const DuneGround& ground,
                  DuneBed& bed) {
    for (const DuneFeature& feature : features) {
        if (feature.kind != FeatureKind::rock && feature.kind != FeatureKind::sand &&
            feature.kind != FeatureKind::source)
            continue;
        const Grid shape = feature_shape(feature, ground);
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

WholeGrid sources_of(const std::vector<DuneFeature>& features, const DuneGround& ground) {
    WholeGrid sources;
    for (const DuneFeature& feature : features) {
        if (feature.kind != FeatureKind::source) continue;
        if (sources.empty()) sources = WholeGrid(ground.nx, ground.ny);
        const Grid shape = feature_shape(feature, ground);
        for (std::size_t cell = 0; cell < shape.size(); ++cell)
            sources.values()[cell] += to_units(feature.height * shape.values()[cell]);
    }
    return sources;
}

}  // namespace fumon
