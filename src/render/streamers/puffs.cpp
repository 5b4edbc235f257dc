#include "render/streamers/puffs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/elementary.h"
#include "base/truncation.h"
#include "render/streamers/smoothstep.h"
#include "render/view/bilinear_height.h"
#include "render/view/tile_warp_waves.h"

namespace fumon {

namespace {

// Of plumes, in their lengths.
constexpr double puffs_per_width = 100.0;  // of a brink as wide as a plume is long
constexpr int fewest_puffs = 6;
constexpr int most_puffs = 400;
constexpr double sharp_pixels = 5.0;  // of a puff's spread: all are drawn
constexpr double least_pixels = 0.7;  // of a plume's thickness
constexpr double plume_depth = 0.05;  // optical, looking down where a plume begins
constexpr double least_share = 0.8;   // puffs of a brink cell, in the mean
constexpr double narrowest = 0.45;    // pixels
constexpr double least_blown = 0.03;  // of a puff's sand: less is left out

// Of wisps, in metres.
constexpr double wisp_area = 1.1;
constexpr double wisp_path = 6.0;
constexpr double wisp_reach = 110.0;
constexpr int wisp_pieces = 7;
constexpr double wisp_depth = 0.0125;

/// Whole numbers that look like chance.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h = a * 0x8da6b343U + b * 0xd8163841U + c * 0xcb1ab31fU;
    h ^= h >> 15U;
    h *= 0x2c1b3c6dU;
    h ^= h >> 12U;
    h *= 0x297a2d39U;
    return h ^ (h >> 15U);
}

/// 0 … 1, a number of several.
class Chance {
  public:
    Chance(std::uint32_t a, std::uint32_t b, std::int64_t c)
        : base_(mixed(a, b, static_cast<std::uint32_t>(c))) {}
    [[nodiscard]] double operator()(std::uint32_t number) const {
        return static_cast<double>(mixed(base_, number, 77U)) * 0x1p-32;
    }

  private:
    std::uint32_t base_;
};

/// 0 … 1, smooth, one feature to a unit of length.
double noise(double x, double y, std::uint32_t of) {
    const auto at = [&](double i, double j) {
        return static_cast<double>(mixed(static_cast<std::uint32_t>(truncated(i)),
                                         static_cast<std::uint32_t>(truncated(j)), of)) *
               0x1p-32;
    };
    const double i = std::floor(x);
    const double j = std::floor(y);
    const double s = smoothstep(0.0, 1.0, x - i);
    const double t = smoothstep(0.0, 1.0, y - j);
    return std::lerp(std::lerp(at(i, j), at(i + 1, j), s),
                     std::lerp(at(i, j + 1), at(i + 1, j + 1), s), t);
}

/// Whether a ball may show in the picture.
bool in_frustum(const Camera& camera, const glm::dvec3& offset, double radius) {
    const double depth = glm::dot(offset, camera.forward);
    if (depth < -radius) return false;
    const auto beside = [&](const glm::dvec3& axis, double half) {
        return std::abs(glm::dot(offset, axis)) <=
               half * depth + radius * std::sqrt(1.0 + half * half);
    };
    return beside(camera.right, camera.half.x) && beside(camera.up, camera.half.y);
}

class PuffEmitter {
  public:
    PuffEmitter(const BlownSand& sand, double strength, double gone, const PuffGround& ground,
                const Camera& camera, double pixel)
        : sand_(sand),
          strength_(strength),
          gone_(gone),
          ground_(ground),
          camera_(camera),
          pixel_(pixel),
          way_(sand.way.x, sand.way.y),
          aside_(-sand.way.y, sand.way.x) {}

    std::vector<Puff> take() { return std::move(puffs_); }

    void emit_plumes() {
        const double reach = 0.10 * sand_.length / (least_pixels * pixel_);
        for_repetitions(reach + 2.0 * sand_.length, [&](const glm::dvec2& origin) {
            for (const Brink& brink : sand_.brinks) emit_plume(brink, origin, reach);
        });
    }

    void emit_wisps() {
        const double reach = wisp_reach * sand_.metre;
        for_repetitions(reach, [&](const glm::dvec2& origin) { emit_wisps_of(origin, reach); });
    }

  private:
    /// South-western corners of those of the bed that may be seen within a distance.
    template <class Body>
    void for_repetitions(double reach, const Body& body) const {
        if (!sand_.repeats) {
            body(ground_.corner);
            return;
        }
        const bool varied = ground_.copies.varied();
        const double widest = varied ? tile_warp::largest_stretch : 1.0;
        const glm::dvec2 far =
            (varied ? tile_warp::largest_offset : 0.0) + widest * reach / ground_.extent;
        const glm::dvec2 at = (glm::dvec2(camera_.eye) - ground_.corner) / ground_.extent;
        const glm::dvec2 low = glm::floor(at - far);
        const glm::dvec2 high = glm::floor(at + far);
        const glm::ivec2 first(low);
        const glm::ivec2 last(high);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec2 corner = ground_.corner + glm::dvec2(x, y) * ground_.extent;
                const glm::dvec2 middle =
                    ground_.copies.ground_position_of(corner + 0.5 * ground_.extent);
                const double radius = widest * 0.5 * glm::length(ground_.extent) + sand_.length;
                const glm::dvec3 offset(middle - glm::dvec2(camera_.eye), -camera_.eye.z);
                if (glm::length(glm::dvec2(offset)) < reach + radius &&
                    in_frustum(camera_, offset, radius + 0.2))
                    body(corner);
            }
        }
    }

    /// A place on the bed, with its height, as the eye sees it.
    [[nodiscard]] glm::dvec3 offset_of(const glm::dvec2& shown, double z) const {
        const glm::dvec2 position = ground_.copies.ground_position_of(shown);
        glm::dvec3 offset(position - glm::dvec2(camera_.eye),
                          ground_.copies.raised(ground_.copies.at(position), z) - camera_.eye.z);
        offset.z -= glm::dot(glm::dvec2(offset), glm::dvec2(offset)) * ground_.curvature;
        return offset;
    }

    /// `depth`: optical, looking down on its middle, of what it holds on an area.
    void add(const glm::dvec3& middle, const glm::dvec3& along, glm::dvec3 spread, double mass,
             double sun, double sky) {
        const double range = glm::length(middle);
        const double least = narrowest * pixel_ * range;
        for (int axis = 0; axis < 3; ++axis)
            spread[axis] = std::sqrt(spread[axis] * spread[axis] + least * least);
        // None so near that the eye is within.
        const double near = smoothstep(2.0, 5.0, range / spread.x);
        if (near <= 0.0 || !in_frustum(camera_, middle, 3.2 * spread.x)) return;
        if (glm::dot(middle, camera_.forward) < spread.x) return;
        constexpr double volume = 15.7496;  // (2π)^1.5
        const double density = near * mass / (volume * spread.x * spread.y * spread.z);
        puffs_.push_back({glm::vec4(glm::dvec4(middle, density)),
                          glm::vec4(glm::dvec4(along, spread.x)),
                          glm::vec4(glm::dvec4(spread.y, spread.z, sun, sky))});
    }

    void emit_plume(const Brink& brink, const glm::dvec2& origin, double reach) {
        const double length = sand_.length;
        const glm::dvec3 root = offset_of(origin + brink.position, brink.z);
        const double range = glm::length(root);
        if (range > reach) return;
        if (!in_frustum(camera_, root + 0.5 * length * glm::dvec3(way_, 0.0), 0.8 * length)) return;
        const int all = truncated_within(std::round(puffs_per_width * sand_.width / length),
                                         fewest_puffs, most_puffs);
        const double pixels = 0.03 * length / (range * pixel_);
        const double share =
            std::clamp(std::max(pixels / sharp_pixels, least_share / all), 0.0, 1.0);
        const double wider = 1.0 / std::sqrt(share);
        const double fading = smoothstep(1.0, 0.6, range / reach);
        const double each =
            strength_ * fading * plume_depth * brink.flux * sand_.width * length / (all * share);
        // Gusts go over all copies of the bed as over one ground.
        const double along_brink = glm::dot(origin + brink.position, aside_) / length;
        for (int i = 0; i < all; ++i) {
            const Chance own(brink.id, static_cast<std::uint32_t>(i), 0);
            const double rank = own(1);
            if (rank >= share) continue;
            const double turns = gone_ / length + own(0);
            const double whole = std::floor(turns);
            const double gone = turns - whole;
            const Chance chance(brink.id, static_cast<std::uint32_t>(i), truncated(whole) + 1);
            const double left = whole - own(0);  // the brink, in plume lengths of wind
            const double across = along_brink + (chance(0) - 0.5) * sand_.width / length;
            const double gust = 0.62 * noise(0.35 * across, 0.5 * left, 1U) +
                                0.30 * noise(1.1 * across, 0.9 * left, 2U) +
                                0.08 * noise(4.0 * across, 2.5 * left, 4U);
            const double blown = 0.25 + 0.75 * smoothstep(0.25, 0.75, gust);
            const double fades =
                smoothstep(0.0, 0.05, gone) * smoothstep(1.0, 0.55, gone) *
                elementary::exp(-(2.0 + 2.5 * chance(3)) * gone) *
                std::min(1.0, (share - rank) / (0.25 * share) + (share < 1.0 ? 0.0 : 1.0));
            const double strong = fades * 1.9 * blown * blown;
            if (strong < least_blown) continue;
            const double high = chance(1) * chance(1) * chance(4);
            const double mass = each * (strong - least_blown) * (1.0 - 0.75 * high);
            const double sinks = 0.15 - 0.11 * std::sqrt(high);
            const double z = 0.012 + 0.10 * high + 0.07 * high * gone - sinks * gone * gone;
            const double falls = 0.05 * high - 2.0 * sinks * gone;
            const double aside = 1.6 * (chance(0) - 0.5) * sand_.width +
                                 0.05 * length * gone * (2.0 * chance(2) - 1.0);
            const glm::dvec3 middle =
                root +
                glm::dvec3((length * gone + 1.2 * (chance(5) - 0.5) * sand_.width) * way_,
                           length * z) +
                glm::dvec3(aside * aside_, 0.0);
            const glm::dvec3 spread = length * glm::dvec3(0.065 + 0.14 * gone, 0.048 + 0.055 * gone,
                                                          0.010 + 0.036 * gone);
            const double sun =
                gone < 0.4 ? std::lerp(brink.sun.x, brink.sun.y, 2.5 * gone)
                           : std::lerp(brink.sun.y, brink.sun.z, std::min(2.5 * gone - 1.0, 1.0));
            add(middle, glm::normalize(glm::dvec3(way_, falls)),
                spread * glm::dvec3(wider, wider, 1.0), mass, sun, 0.9);
        }
    }

    void emit_wisps_of(const glm::dvec2& origin, double reach) {
        const int nx = sand_.open.nx();
        const int ny = sand_.open.ny();
        const glm::dvec2 cell = ground_.extent / glm::dvec2(nx, ny);
        const double each = cell.x * cell.y / (wisp_area * sand_.metre * sand_.metre);
        const glm::dvec2 eye = ground_.copies.bed_position_at(glm::dvec2(camera_.eye)) - origin;
        const auto range = [&](double at, double size, int count) {
            return std::pair(
                truncated_within(std::floor((at - 1.3 * reach) / size), 0, count),
                truncated_within(std::floor((at + 1.3 * reach) / size), -1, count - 1));
        };
        const auto [west, east] = range(eye.x, cell.x, nx);
        const auto [south, north] = range(eye.y, cell.y, ny);
        for (int y = south; y <= north; ++y) {
            for (int x = west; x <= east; ++x) {
                if (sand_.open(x, y) < 0.4F) continue;
                const Chance chance(static_cast<std::uint32_t>(y * nx + x), 9001U, 0);
                double left = each;
                for (std::uint32_t i = 0; left > chance(3 * i) && left > 0.0; ++i, left -= 1.0)
                    emit_wisp(origin, glm::dvec2(x, y), cell,
                              static_cast<std::uint32_t>(y * nx + x), i, reach);
            }
        }
    }

    void emit_wisp(const glm::dvec2& origin, const glm::dvec2& number, const glm::dvec2& cell,
                   std::uint32_t id, std::uint32_t i, double reach) {
        const double metre = sand_.metre;
        const Chance own(id, i, -1);
        const double turns = gone_ / (wisp_path * metre) + own(0);
        const double whole = std::floor(turns);
        const double gone = turns - whole;
        const Chance chance(id, i, truncated(whole) + 7);
        const glm::dvec2 root = cell * (number + glm::dvec2(chance(0), chance(1)));
        // Families of them come and go, over all copies of the bed as over one ground.
        const glm::dvec2 there = origin + root;
        const double family = noise(glm::dot(there, aside_) / (7.0 * metre),
                                    (glm::dot(there, way_) - gone_) / (22.0 * metre), 3U);
        const double shown = 0.3 + 0.7 * smoothstep(0.35, 0.8, family);
        const double swings = 0.04 + 0.12 * chance(2);
        const double wave = 3.5 + 3.0 * chance(3);
        for (int piece = 0; piece < wisp_pieces; ++piece) {
            const double on = 0.70 * (piece - 3);
            const double s = wisp_path * (gone - 0.5) + on;
            const double phase = 2.0 * std::numbers::pi * (s / wave + chance(4));
            const double aside = swings * elementary::sin(phase) + 0.05 * s * (chance(5) - 0.5);
            const double turn =
                swings * 2.0 * std::numbers::pi / wave * elementary::cos(phase) * 0.8;
            const glm::dvec2 position = root + metre * (s * way_ + aside * aside_);
            const glm::dvec2 share = position / ground_.extent;
            const bool beside = share.x < 0.0 || share.y < 0.0 || share.x >= 1.0 || share.y >= 1.0;
            if (beside && !sand_.repeats) continue;
            const double flux =
                static_cast<double>(bilinear_height(sand_.open, share, sand_.repeats));
            if (flux < 0.3) continue;
            const auto height = [&](const glm::dvec2& at) {
                return static_cast<double>(
                    bilinear_height(sand_.z, at / ground_.extent, sand_.repeats));
            };
            const double z = height(position);
            const double rise =
                (height(position + 0.5 * metre * way_) - height(position - 0.5 * metre * way_)) /
                metre;
            // Over a brink they fly on, as plumes do, and do not creep down the slip face.
            const double on_ground = smoothstep(-0.30, -0.12, rise);
            if (on_ground <= 0.0) continue;
            const glm::dvec3 offset = offset_of(origin + position, z + 0.035 * metre);
            const double range = glm::length(offset);
            if (range > reach) continue;
            const double taper =
                elementary::sin(std::numbers::pi * (piece + 0.7) / (wisp_pieces + 0.4));
            const double fades = smoothstep(0.0, 0.25, gone) * smoothstep(1.0, 0.7, gone) *
                                 smoothstep(1.0, 0.5, range / reach) * shown * taper * on_ground;
            const glm::dvec3 spread(0.58, 0.06 + 0.09 * chance(6), 0.03);
            const double mass = strength_ * wisp_depth * std::min(flux, 3.0) * fades * 2.0 *
                                std::numbers::pi * spread.x * spread.y * metre * metre;
            add(offset, glm::normalize(glm::dvec3(way_ + turn * aside_, rise)), metre * spread,
                mass, static_cast<double>(bilinear_height(sand_.sun, share, sand_.repeats)), 0.8);
        }
    }

    const BlownSand& sand_;
    double strength_;
    double gone_;
    const PuffGround& ground_;
    const Camera& camera_;
    double pixel_;
    glm::dvec2 way_;
    glm::dvec2 aside_;
    std::vector<Puff> puffs_;
};

}  // namespace

std::vector<Puff> visible_puffs(const BlownSand& sand, double strength, double gone,
                                const PuffGround& ground, const Camera& camera, double pixel) {
    PuffEmitter emitter(sand, strength, gone, ground, camera, pixel);
    emitter.emit_plumes();
    emitter.emit_wisps();
    return emitter.take();
}

}  // namespace fumon
