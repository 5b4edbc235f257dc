#include "render/life/plant_meshes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/elementary.h"

namespace fumon {

namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;

/// Shares 0 … 1, one after another (a linear congruential generator, Knuth's MMIX).
class Shares {
  public:
    explicit Shares(std::uint64_t seed) : state_(seed) {}
    double operator()() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 40U) * 0x1p-24;
    }
    double between(double low, double high) { return low + (high - low) * (*this)(); }

  private:
    std::uint64_t state_;
};

glm::vec3 level(double angle, double length, double z) {
    return {static_cast<float>(length * elementary::cos(angle)),
            static_cast<float>(length * elementary::sin(angle)), static_cast<float>(z)};
}

/// A blade in `joints` + 1 pieces that bends outward as it rises.
void add_blade(std::vector<LeafVertex>& mesh, Shares& share, double width, int joints) {
    const double angle = whole_turn * share();
    const double root = 0.10 * share();
    const double tall = share.between(0.55, 1.0);
    const double reach = share.between(0.1, 0.55) * tall;
    const auto tint = static_cast<float>(share.between(-1.0, 1.0));
    const glm::vec3 side = level(angle + 0.25 * whole_turn, 0.5 * width, 0.0);
    const auto middle = [&](double up) {
        return level(angle, root + reach * up * up, tall * (up - 0.12 * up * up * reach));
    };
    const glm::vec3 normal = glm::normalize(level(angle, 0.8, 0.25 + 0.6 * reach));
    for (int piece = 0; piece <= joints; ++piece) {
        const double from = static_cast<double>(piece) / (joints + 1);
        const double to = static_cast<double>(piece + 1) / (joints + 1);
        const glm::vec3 low = middle(from);
        const glm::vec3 high = middle(to);
        const auto low_width = static_cast<float>(1.0 - 0.5 * from);
        const auto high_width = static_cast<float>(1.0 - 0.5 * to);
        const LeafVertex a{low - low_width * side, normal, tint};
        const LeafVertex b{low + low_width * side, normal, tint};
        if (piece == joints) {
            mesh.insert(mesh.end(), {a, b, {high, normal, tint}});
            return;
        }
        const LeafVertex c{high - high_width * side, normal, tint};
        const LeafVertex d{high + high_width * side, normal, tint};
        mesh.insert(mesh.end(), {a, b, c, b, d, c});
    }
}

/// A leaf or a spray of leaves: a triangle somewhere on a round, open crown.
void add_leaf(std::vector<LeafVertex>& mesh, Shares& share, double size) {
    const double angle = whole_turn * share();
    const double up = share.between(-0.8, 1.0);
    const double out = 0.62 * (0.45 + 0.55 * share());
    const double round = std::sqrt(std::max(0.0, 1.0 - up * up));
    const glm::vec3 middle = level(angle, out * round * 0.9, 0.44 + 0.52 * (out / 0.62) * up);
    const glm::vec3 outward = glm::normalize(level(angle, round + 0.15, up + 0.35));
    const double spin = whole_turn * share();
    const glm::vec3 any = level(spin, 1.0, share.between(-0.6, 0.6));
    const glm::vec3 along = glm::normalize(any - 0.6F * outward * glm::dot(any, outward));
    const glm::vec3 across = glm::cross(along, outward);
    const auto length = static_cast<float>(size * share.between(0.7, 1.3));
    const auto tint = static_cast<float>(share.between(-1.0, 1.0));
    mesh.push_back({middle - 0.35F * length * across, outward, tint});
    mesh.push_back({middle + 0.35F * length * across, outward, tint});
    mesh.push_back({middle + length * along, outward, tint});
}

void add_twig(std::vector<LeafVertex>& mesh, Shares& share) {
    const double angle = whole_turn * share();
    const double tall = share.between(0.5, 0.85);
    const double reach = share.between(0.2, 0.5);
    const glm::vec3 tip = level(angle, reach, tall);
    const glm::vec3 side = level(angle + 0.25 * whole_turn, 0.015, 0.0);
    const glm::vec3 normal = level(angle, 1.0, 0.0);
    mesh.push_back({-side, normal, -1.0F});
    mesh.push_back({side, normal, -1.0F});
    mesh.push_back({tip, normal, -1.0F});
}

}  // namespace

std::vector<LeafVertex> plant_mesh(PlantKind kind, PlantDetail detail) {
    std::vector<LeafVertex> mesh;
    Shares share(kind == PlantKind::grass ? 11 : 29);
    const auto d = static_cast<std::size_t>(detail);
    if (kind == PlantKind::grass) {
        constexpr std::array blades{46, 18, 6};
        constexpr std::array widths{0.035, 0.06, 0.16};
        constexpr std::array joints{2, 1, 0};
        for (int i = 0; i < blades.at(d); ++i) add_blade(mesh, share, widths.at(d), joints.at(d));
        return mesh;
    }
    constexpr std::array leaves{900, 240, 34};
    constexpr std::array sizes{0.062, 0.12, 0.34};
    constexpr std::array twigs{14, 5, 0};
    for (int i = 0; i < leaves.at(d); ++i) add_leaf(mesh, share, sizes.at(d));
    for (int i = 0; i < twigs.at(d); ++i) add_twig(mesh, share);
    return mesh;
}

}  // namespace fumon
