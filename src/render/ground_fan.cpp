#include "render/ground_fan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr int rings = 1000;
constexpr int most_places = 12;  // looked at around a ring
// Between two of these at least: of a texel, and of the distance between rays.
constexpr double least_texels = 0.5;
constexpr double least_spacing = 0.6;
constexpr double texels_a_ray = 0.2;  // a texel at most, of the distance between rays

/// The places around a ring, and the level of the bed's means that they are looked up in.
struct Ring {
    int level = 0;
    std::vector<double> radii;
};

double radius_of(const GroundFan& fan, double u) {
    const double reach = elementary::log(fan.farthest / fan.nearest);
    return fan.nearest * elementary::exp(reach * u * (0.6 + 0.4 * u));  // closer at first
}

std::vector<Ring> rings_of(const GroundFan& fan, int levels) {
    const double between_rays = 2.0 * fan.half_angle / (fan.rays - 1);
    std::vector<Ring> all(1, Ring{0, {1e-3 * fan.nearest}});
    constexpr double step = 1.0 / (rings - 2);
    for (int ring = 1; ring < rings; ++ring) {
        const double u = (ring - 1) * step;
        const double radius = radius_of(fan, u);
        const double from = ring == 1 ? radius : radius_of(fan, u - 0.5 * step);
        const double to = radius_of(fan, u + 0.5 * step);
        const double fineness = std::max(texels_a_ray * radius * between_rays / fan.cell, 1.0);
        const int level = std::min(std::ilogb(fineness), levels - 1);
        const double texel = std::ldexp(fan.cell, level);
        const double spacing =
            std::max(least_texels * texel, least_spacing * radius * between_rays);
        const int count =
            std::clamp(static_cast<int>(std::ceil((to - from) / spacing)), 1, most_places);
        Ring places{level, {}};
        for (int k = 0; k < count; ++k)
            places.radii.push_back(from + (to - from) * (k + 0.5) / count);
        all.push_back(std::move(places));
    }
    return all;
}

/// How high places look: the tangents of their elevations.
using Tangents = std::vector<float>;

void place_ray(const GroundFan& fan, const HeightPyramid& bed, const std::vector<Ring>& all,
               int ray, glm::vec3* places, float* tangents) {
    const double angle = fan.half_angle * (2.0 * ray / (fan.rays - 1) - 1.0);
    const double c = elementary::cos(angle);
    const double s = elementary::sin(angle);
    const glm::dvec2 along(fan.heading.x * c - fan.heading.y * s,
                           fan.heading.x * s + fan.heading.y * c);
    const glm::dvec2 per_length = along / fan.extent;
    const glm::dvec2 origin = glm::dvec2(fan.eye) / fan.extent + 0.5;
    double highest_before = -1e30;
    for (std::size_t ring = 0; ring < all.size(); ++ring) {
        const Ring& around = all[ring];
        const std::size_t count = around.radii.size();
        // Ground that cannot rise over what stands before it needs no care.
        const double last = around.radii[count - 1];
        const bool hidden = (bed.highest() - fan.eye.z) / last < highest_before;
        const std::size_t from = hidden ? count / 2 : 0;
        const std::size_t to = hidden ? from + 1 : count;
        double best = -1e30;
        double best_radius = 0.0;
        double best_z = 0.0;
        for (std::size_t k = from; k < to; ++k) {
            const double radius = around.radii[k];
            const glm::dvec2 at = origin + radius * per_length;
            const double z = static_cast<double>(bed.at(around.level, at.x, at.y)) -
                             radius * radius * fan.curvature - fan.eye.z;
            const double tangent = z / radius;
            if (tangent <= best) continue;
            best = tangent;
            best_radius = radius;
            best_z = z;
        }
        highest_before = std::max(highest_before, best);
        places[ring] = glm::vec3(glm::dvec3(best_radius * along, best_z));
        tangents[ring] = static_cast<float>(best);
    }
}

struct Triangles {
    std::vector<std::uint32_t> near_ones;
    std::vector<std::uint32_t> far_ones;
};

/// Between two neighbouring rays. At any azimuth between them the ground looks at least as high as
/// the lower of both at the same ring.
void add_visible(int ray, int first_far, const Tangents& tangents, Triangles& triangles) {
    const auto a = static_cast<std::size_t>(ray) * rings;
    const std::size_t b = a + rings;
    float hiding = -1e30F;
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
        const float here = std::max(tangents[a + ring], tangents[b + ring]);
        const float next = std::max(tangents[a + ring + 1], tangents[b + ring + 1]);
        hiding = std::max(hiding, std::min(tangents[a + ring], tangents[b + ring]));
        if (std::max(here, next) < hiding) continue;
        auto& list = static_cast<int>(ring) < first_far ? triangles.near_ones : triangles.far_ones;
        const auto a0 = static_cast<std::uint32_t>(a + ring);
        const auto b0 = static_cast<std::uint32_t>(b + ring);
        for (const std::uint32_t corner : {a0, b0, a0 + 1, b0, b0 + 1, a0 + 1})
            list.push_back(corner);
    }
}

}  // namespace

GroundMesh ground_mesh(const GroundFan& fan, const HeightPyramid& bed, WorkerPool& pool) {
    const std::vector<Ring> all = rings_of(fan, bed.levels());
    GroundMesh mesh;
    mesh.places.resize(static_cast<std::size_t>(fan.rays) * rings);
    Tangents tangents(mesh.places.size());
    pool.for_ranges(fan.rays, [&](int begin, int end) {
        for (int ray = begin; ray < end; ++ray) {
            const std::size_t first = static_cast<std::size_t>(ray) * rings;
            place_ray(fan, bed, all, ray, mesh.places.data() + first, tangents.data() + first);
        }
    });
    int first_far = 0;
    while (first_far < rings && all[static_cast<std::size_t>(first_far)].radii[0] < fan.near_to)
        ++first_far;
    Triangles triangles;
    for (int ray = 0; ray + 1 < fan.rays; ++ray) add_visible(ray, first_far, tangents, triangles);
    mesh.near_triangles = std::move(triangles.near_ones);
    mesh.far_triangles = std::move(triangles.far_ones);
    return mesh;
}

}  // namespace fumon
