#include "render/ground/ground_fan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/truncation.h"
#include "base/worker_pool.h"
#include "render/ground/ground_vectors.h"
#include "render/ground/wall_vertices.h"

namespace fumon {

namespace {

constexpr int ring_count = 1000;
constexpr int max_samples_per_ring = 12;  // looked at around a ring
// Between two of these at least: of a texel, and of the distance between rays.
constexpr double min_spacing_texels = 0.5;
constexpr double min_spacing_rays = 0.6;
constexpr double texels_per_ray_spacing = 0.2;  // a texel at most, of the distance between rays

/// The places around a ring, and the level of the bed's means that they are looked up in.
struct Ring {
    int level = 0;
    std::size_t count = 0;
    std::array<double, max_samples_per_ring> radii{};

    /// The place that stands for a ring of which no more needs to be known.
    [[nodiscard]] std::size_t middle() const { return count / 2; }
    [[nodiscard]] double last() const { return radii[count - 1]; }
};

Ring ring_of(int level, double from, double to, int count) {
    Ring ring{level, static_cast<std::size_t>(count)};
    for (std::size_t k = 0; k < ring.count; ++k)
        ring.radii[k] = from + (to - from) * (static_cast<int>(k) + 0.5) / count;
    return ring;
}

double radius_of(const GroundFan& fan, double u) {
    const double reach = elementary::log(fan.farthest / fan.nearest);
    return fan.nearest * elementary::exp(reach * u * (0.6 + 0.4 * u));  // closer at first
}

std::vector<Ring> rings_of(const GroundFan& fan, int levels) {
    const double between_rays = 2.0 * fan.half_angle / (fan.rays - 1);
    std::vector<Ring> all(1, ring_of(0, 1e-3 * fan.nearest, 1e-3 * fan.nearest, 1));
    constexpr double step = 1.0 / (ring_count - 2);
    for (int ring = 1; ring < ring_count; ++ring) {
        const double u = (ring - 1) * step;
        const double radius = radius_of(fan, u);
        const double from = ring == 1 ? radius : radius_of(fan, u - 0.5 * step);
        const double to = radius_of(fan, u + 0.5 * step);
        const double fineness =
            std::max(texels_per_ray_spacing * radius * between_rays / fan.cell, 1.0);
        const int level = std::clamp(std::ilogb(fineness), 0, levels - 1);
        const double texel = std::ldexp(fan.cell, level);
        const double spacing =
            std::max(min_spacing_texels * texel, min_spacing_rays * radius * between_rays);
        const int count =
            truncated_within(std::ceil((to - from) / spacing), 1, max_samples_per_ring);
        all.push_back(ring_of(level, from, to, count));
    }
    return all;
}

/// Numbers at the rings' inner edges and at the last one's outer one.
using RingEdges = std::array<double, (ring_count / ground_vectors::samples_per_batch + 1) *
                                         std::size_t{ground_vectors::samples_per_batch}>;
static_assert(std::tuple_size_v<RingEdges> > ring_count);

RingEdges ring_edges(const GroundFan& fan) {
    constexpr double step = 1.0 / (ring_count - 2);
    RingEdges edges{};
    for (std::size_t ring = 1; ring < edges.size(); ++ring) {
        const int whole = std::min(static_cast<int>(ring), ring_count) - 1;
        edges[ring] = radius_of(fan, std::max((whole - 0.5) * step, 0.0));
    }
    return edges;
}

/// A ray over the bed, or over a copy of it. Places count periods of it, or its tiles.
struct Ray {
    double east;  ///< under the eye
    double north;
    double east_per_length;
    double north_per_length;
    double raised = 1.0;  ///< how high ground stands, see ground_vectors::Places
    double raised_per_length = 0.0;
};

/// How the bed's copies stand along a ray: between the edges of a ring by straight lines.
class WarpAlongRay {
  public:
    WarpAlongRay(const GroundFan& fan, const RingEdges& edges, const glm::dvec2& per_length)
        : edges_(edges), varied_(fan.strength > 0.0) {
        if (!varied_) return;
        ground_vectors::warp_along_ray({fan.eye_from_middle.x, fan.eye_from_middle.y, per_length.x,
                                        per_length.y, fan.strength},
                                       edges.data(), static_cast<int>(edges.size()), east_.data(),
                                       north_.data(), height_.data());
    }

    /// A ray over the bed as it is over the copies that a ring crosses.
    [[nodiscard]] Ray at(std::size_t ring, Ray ray) const {
        if (!varied_) return ray;
        const double width = edges_[ring + 1] - edges_[ring];
        const auto add = [&](const RingEdges& numbers, double& at_eye, double& per_length) {
            const double change = (numbers[ring + 1] - numbers[ring]) / width;
            at_eye += numbers[ring] - change * edges_[ring];
            per_length += change;
        };
        add(east_, ray.east, ray.east_per_length);
        add(north_, ray.north, ray.north_per_length);
        ray.raised = 0.0;
        add(height_, ray.raised, ray.raised_per_length);
        return ray;
    }
    [[nodiscard]] bool varied() const { return varied_; }

  private:
    const RingEdges& edges_;
    bool varied_;
    RingEdges east_{};
    RingEdges north_{};
    RingEdges height_{};
};

constexpr std::size_t rings_per_batch = 32;  // of one level, whose places are looked at together

/// Places of some rings along a ray.
class RayBatch {
  public:
    void clear() { count_ = 0; }
    /// Those of a ring from the one of that number up to another; returns where they begin.
    std::size_t add(const Ring& ring, std::size_t from, std::size_t to, const Ray& ray) {
        const std::size_t first = count_;
        for (std::size_t k = from; k < to; ++k, ++count_) {
            const double radius = ring.radii[k];
            radii_[count_] = radius;
            east_[count_] = ray.east + radius * ray.east_per_length;
            north_[count_] = ray.north + radius * ray.north_per_length;
            raised_[count_] = ray.raised + radius * ray.raised_per_length;
        }
        return first;
    }
    void evaluate(const ground_vectors::Heights& bed, const ground_vectors::Eye& eye, bool varied) {
        ground_vectors::evaluate(
            bed, eye,
            {radii_.data(), east_.data(), north_.data(), varied ? raised_.data() : nullptr},
            static_cast<int>(count_), over_.data(), tangents_.data());
    }
    [[nodiscard]] double radius(std::size_t position) const { return radii_[position]; }
    [[nodiscard]] double over(std::size_t position) const { return over_[position]; }
    [[nodiscard]] double tangent(std::size_t position) const { return tangents_[position]; }
    [[nodiscard]] RaySample at(std::size_t position) const {
        return {radii_[position], over_[position], tangents_[position]};
    }

  private:
    using Numbers = std::array<double, rings_per_batch * max_samples_per_ring +
                                           ground_vectors::samples_per_batch>;
    std::size_t count_ = 0;
    Numbers radii_{};
    Numbers east_{};
    Numbers north_{};
    Numbers raised_{};
    Numbers over_{};
    Numbers tangents_{};
};

/// How high places look: the tangents of their elevations.
using Tangents = std::vector<float>;

/// Returns the direction of the highest. `along_ray` is room for it.
glm::vec3 sample_ray(const GroundFan& fan, const HeightPyramid& bed, const std::vector<Ring>& all,
                     const RingEdges& edges, int ray, RayBatch& along_ray, WallVertices& walls,
                     glm::vec3* positions, float* tangents) {
    const double angle = fan.half_angle * (2.0 * ray / (fan.rays - 1) - 1.0);
    const double c = elementary::cos(angle);
    const double s = elementary::sin(angle);
    const glm::dvec2 along(fan.heading.x * c - fan.heading.y * s,
                           fan.heading.x * s + fan.heading.y * c);
    const glm::dvec2 per_length = along / fan.extent;
    const glm::dvec2 origin = glm::dvec2(fan.eye) / fan.extent + 0.5;
    const Ray over_bed{origin.x, origin.y, per_length.x, per_length.y};
    const WarpAlongRay copies(fan, edges, per_length);
    const double most_over = bed.highest() - fan.eye.z;
    double horizon_tangent = -1e30;
    // Ground that cannot rise over what stands before it needs no care.
    const auto is_occluded = [&](const Ring& ring) {
        return most_over / ring.last() < horizon_tangent;
    };
    struct BatchedRing {
        std::size_t first;
        bool in_middle;  ///< alone
    };
    std::array<BatchedRing, rings_per_batch> batched{};
    walls.begin_ray();
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        const int level = all[begin].level;
        along_ray.clear();
        for (; end < std::min(begin + rings_per_batch, all.size()) && all[end].level == level;
             ++end) {
            const Ring& ring = all[end];
            const bool hidden = is_occluded(ring);
            const std::size_t from = hidden ? ring.middle() : 0;
            const std::size_t to = hidden ? from + 1 : ring.count;
            batched[end - begin] = {along_ray.add(ring, from, to, copies.at(end, over_bed)),
                                    hidden};
        }
        const Field<float>& means = bed.level(level);
        along_ray.evaluate({means.data(), means.nx(), means.ny(), bed.tiles()},
                           {fan.eye.z, fan.curvature, fan.mean}, copies.varied());
        for (std::size_t ring = begin; ring < end; ++ring) {
            const BatchedRing& at = batched[ring - begin];
            std::size_t highest = at.first;
            if (!at.in_middle && is_occluded(all[ring])) {
                highest += all[ring].middle();
            } else if (!at.in_middle) {
                double best = along_ray.tangent(highest);
                for (std::size_t k = at.first + 1; k < at.first + all[ring].count; ++k) {
                    const double rise = along_ray.tangent(k);
                    const bool higher = rise > best;  // without a branch that none foresees
                    highest = higher ? k : highest;
                    best = higher ? rise : best;
                }
            }
            const double tangent = along_ray.tangent(highest);
            horizon_tangent = std::max(horizon_tangent, tangent);
            positions[ring] =
                glm::vec3(glm::dvec3(along_ray.radius(highest) * along, along_ray.over(highest)));
            tangents[ring] = static_cast<float>(tangent);
            if (fan.wall_slope == 0.0) continue;
            std::array<RaySample, max_samples_per_ring> in_ring{};
            const std::size_t count = at.in_middle ? 1 : all[ring].count;
            for (std::size_t k = 0; k < count; ++k) in_ring[k] = along_ray.at(at.first + k);
            walls.take(std::span(in_ring).first(count), highest - at.first);
        }
    }
    for (std::size_t ring = 0; ring < walls.chosen().size(); ++ring) {
        const RaySample& chosen = walls.chosen()[ring];
        positions[ring] = glm::vec3(glm::dvec3(chosen.radius * along, chosen.over));
        tangents[ring] = static_cast<float>(chosen.tangent);
    }
    return {glm::dvec3(along, horizon_tangent)};
}

/// Rings between two of them.
struct RingRange {
    int first;
    int last;
};

/// Two triangles between two neighbouring rays and rings. `over_walls`: they meet where their
/// corners differ the less in height, so that a wall's rim runs on from one ring to the next.
void add_quad(std::size_t ray, std::size_t ring, bool over_walls, GroundMesh& mesh) {
    const auto a0 = static_cast<std::uint32_t>(ray * ring_count + ring);
    const std::uint32_t a1 = a0 + 1;
    const std::uint32_t b0 = a0 + ring_count;
    const std::uint32_t b1 = b0 + 1;
    const auto apart = [&](std::uint32_t one, std::uint32_t other) {
        return std::abs(mesh.positions[one].z - mesh.positions[other].z);
    };
    if (over_walls && apart(a0, b1) < apart(b0, a1)) {
        mesh.triangles.insert(mesh.triangles.end(), {a0, b0, b1, a0, b1, a1});
    } else {
        mesh.triangles.insert(mesh.triangles.end(), {a0, b0, a1, b0, b1, a1});
    }
}

/// Between two neighbouring rays, those that begin in a range of rings. At any azimuth between them
/// the ground looks at least as high as the lower of both at the same ring. `hiding`: how high what
/// stands before looks, between these two rays.
void add_visible_quads(int ray, const RingRange& among, bool over_walls, const Tangents& tangents,
                       float& horizon, GroundMesh& mesh) {
    const auto a = static_cast<std::size_t>(ray) * ring_count;
    const std::size_t b = a + ring_count;
    for (auto ring = static_cast<std::size_t>(among.first);
         ring < static_cast<std::size_t>(among.last); ++ring) {
        const float here = std::max(tangents[a + ring], tangents[b + ring]);
        const float next = std::max(tangents[a + ring + 1], tangents[b + ring + 1]);
        horizon = std::max(horizon, std::min(tangents[a + ring], tangents[b + ring]));
        if (std::max(here, next) >= horizon)
            add_quad(static_cast<std::size_t>(ray), ring, over_walls, mesh);
    }
}

/// Which of the ground between two neighbouring rays and rings a lens may see, ray by ray. From
/// a point of it what stands at a distance r is seen lower by up to lens / r, and aside by as much.
std::vector<bool> visible_through_lens(const GroundFan& fan, const GroundMesh& mesh,
                                       const Tangents& tangents) {
    const auto pairs = static_cast<std::size_t>(fan.rays - 1);
    const double between_rays = 2.0 * fan.half_angle / (fan.rays - 1);
    std::vector<bool> visible(pairs * (ring_count - 1));
    const auto from_above = [&](std::size_t ray, std::size_t ring) {
        const std::size_t at = ray * ring_count + ring;
        const glm::vec3& position = mesh.positions[at];
        const double range = elementary::hypot(position.x, position.y);
        return tangents[at] - static_cast<float>(fan.lens / range);
    };
    std::vector<float> here(pairs + 1);
    std::vector<float> next(pairs + 1);
    std::vector<float> lower(pairs);
    std::vector<float> horizon(pairs, -1e30F);
    for (std::size_t ray = 0; ray <= pairs; ++ray) next[ray] = from_above(ray, 0);
    for (std::size_t ring = 0; ring + 1 < ring_count; ++ring) {
        std::swap(here, next);
        for (std::size_t ray = 0; ray <= pairs; ++ray) next[ray] = from_above(ray, ring + 1);
        for (std::size_t k = 0; k < pairs; ++k) lower[k] = std::min(here[k], here[k + 1]);
        const glm::vec3& position = mesh.positions[ring];
        const double range = elementary::hypot(position.x, position.y);
        const double aside = std::ceil(fan.lens / (range * between_rays));
        const auto reach = truncated_within(aside, std::size_t{0}, pairs);
        for (std::size_t k = 0; k < pairs; ++k) {
            const auto first = lower.begin() + static_cast<std::ptrdiff_t>(k - std::min(k, reach));
            const auto last =
                lower.begin() + static_cast<std::ptrdiff_t>(std::min(k + reach + 1, pairs));
            horizon[k] = std::max(horizon[k], *std::min_element(first, last));
            const float highest =
                std::max(std::max(here[k], here[k + 1]), std::max(next[k], next[k + 1]));
            visible[k * (ring_count - 1) + ring] = highest >= horizon[k];
        }
    }
    return visible;
}

/// That there are rings and rays, from an eye that stands somewhere.
void check(const GroundFan& fan, const HeightPyramid& bed) {
    const bool rings_rise = fan.nearest > 0.0 && fan.nearest < fan.farthest &&
                            std::isfinite(fan.farthest / fan.nearest);
    const bool somewhere = std::isfinite(fan.eye.x) && std::isfinite(fan.eye.y) &&
                           std::isfinite(fan.eye.z) && std::isfinite(bed.highest());
    if (rings_rise && somewhere && fan.cell > 0.0 && fan.rays > 1) return;
    throw Error(fmt::format(
        "endless ground cannot be drawn from {:g} to {:g} block lengths around ({:g}, {:g}, {:g})",
        fan.nearest, fan.farthest, fan.eye.x, fan.eye.y, fan.eye.z));
}

}  // namespace

GroundMesh ground_mesh(const GroundFan& fan, const HeightPyramid& bed, WorkerPool& pool) {
    check(fan, bed);
    const std::vector<Ring> all = rings_of(fan, bed.levels());
    const RingEdges edges = ring_edges(fan);
    GroundMesh mesh;
    mesh.positions.resize(static_cast<std::size_t>(fan.rays) * ring_count);
    mesh.skyline.resize(static_cast<std::size_t>(fan.rays));
    Tangents tangents(mesh.positions.size());
    pool.for_ranges(fan.rays, [&](int begin, int end) {
        RayBatch along_ray;
        WallVertices walls(fan.wall_slope);
        for (int ray = begin; ray < end; ++ray) {
            const std::size_t first = static_cast<std::size_t>(ray) * ring_count;
            mesh.skyline[static_cast<std::size_t>(ray)] =
                sample_ray(fan, bed, all, edges, ray, along_ray, walls,
                           mesh.positions.data() + first, tangents.data() + first);
        }
    });
    int first_far = 0;
    while (first_far < ring_count &&
           all[static_cast<std::size_t>(first_far)].radii[0] < fan.near_limit)
        ++first_far;
    first_far = std::min(first_far, ring_count - 1);
    std::vector<float> horizon(static_cast<std::size_t>(fan.rays), -1e30F);
    std::vector<bool> visible;
    if (fan.lens > 0.0) visible = visible_through_lens(fan, mesh, tangents);
    const bool over_walls = fan.wall_slope > 0.0;
    const auto add_all = [&](const RingRange& among) {
        for (int ray = 0; ray + 1 < fan.rays; ++ray) {
            const auto number = static_cast<std::size_t>(ray);
            if (visible.empty()) {
                add_visible_quads(ray, among, over_walls, tangents, horizon[number], mesh);
                continue;
            }
            for (auto ring = static_cast<std::size_t>(among.first);
                 ring < static_cast<std::size_t>(among.last); ++ring) {
                if (visible[number * (ring_count - 1) + ring])
                    add_quad(number, ring, over_walls, mesh);
            }
        }
    };
    add_all({0, first_far});
    mesh.near_indices = mesh.triangles.size();
    add_all({first_far, ring_count - 1});
    return mesh;
}

}  // namespace fumon
