#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "render/air/air_layer.h"

namespace fumon {

namespace {

constexpr double ribbon_width = 0.0016;  // block lengths
constexpr double grain_radius = 0.0034;
constexpr double grain_spacing = 0.07;     // along a path
constexpr double shortest_path = 0.015;    // shorter hops would be mere specks
constexpr double golden_share = 0.618034;  // spreads the paths evenly over any number of them
constexpr double used_depth = 0.86;        // of the strip
constexpr int grain_corners = 12;
const glm::vec4 ribbon_colour(1.0F, 0.93F, 0.78F, 0.62F);
const glm::vec4 grain_light(0.98F, 0.80F, 0.50F, 1.0F);
const glm::vec4 grain_shade(0.62F, 0.38F, 0.18F, 1.0F);

double fraction(double value) {
    return value - std::floor(value);
}

/// The triangles of one path after the other.
class Ribbons {
  public:
    Ribbons(const Snapshot& strip, const Block& block, const Camera& camera)
        : strip_(strip), block_(block), camera_(camera) {
        const int columns = strip.bed.nx();
        cells_ = columns;
        length_ = strip.section->dx * columns;
    }

    void add(const GrainPath& path, double y, double first_grain) {
        const std::size_t count = std::min(path.x.size(), path.z.size());
        if (!large_enough(path)) return;
        double to_grain = first_grain * grain_spacing;
        for (std::size_t i = 1; i < count; ++i) {
            // Both ends counted from the period in which the middle lies.
            const double period =
                length_ * std::floor((0.5 * (path.x[i - 1] + path.x[i]) + half_cell()) / length_);
            const glm::dvec3 from = position(path.x[i - 1] - period, y, path.z[i - 1]);
            const glm::dvec3 to = position(path.x[i] - period, y, path.z[i]);
            add_segment(from, to);
            const double step = glm::distance(from, to);
            for (; to_grain < step; to_grain += grain_spacing)
                add_grain(glm::mix(from, to, to_grain / step));
            to_grain -= step;
        }
    }

    /// Ribbons first, so that grains lie upon them.
    [[nodiscard]] std::vector<AirVertex> triangles() const {
        std::vector<AirVertex> all = ribbons_;
        all.insert(all.end(), grains_.begin(), grains_.end());
        return all;
    }

  private:
    [[nodiscard]] double half_cell() const { return 0.5 * length_ / cells_; }

    [[nodiscard]] bool large_enough(const GrainPath& path) const {
        if (path.x.empty()) return false;
        const auto [west, east] = std::minmax_element(path.x.begin(), path.x.end());
        return (*east - *west) / length_ * block_.width_x > shortest_path;
    }

    [[nodiscard]] glm::dvec3 position(double x, double y, double z) const {
        return {((x + half_cell()) / length_ - 0.5) * block_.width_x, y,
                block_.z(z / strip_.scale.height_unit)};
    }

    [[nodiscard]] glm::dvec3 to_eye(const glm::dvec3& point) const {
        return camera_.perspective ? glm::normalize(camera_.eye - point) : -camera_.forward;
    }

    void add_segment(const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 across = glm::cross(to - from, to_eye(from));
        if (!(glm::length(across) > 0.0)) return;
        const glm::dvec3 aside = 0.5 * ribbon_width * glm::normalize(across);
        for (const glm::dvec3& corner :
             {from - aside, from + aside, to + aside, from - aside, to + aside, to - aside})
            ribbons_.push_back({glm::vec3(corner), ribbon_colour});
    }

    void add_grain(const glm::dvec3& centre) {
        const auto corner = [&](int i) {
            const double angle = 6.283185307179586 * i / grain_corners;
            const double up = elementary::sin(angle);
            const glm::dvec3 at =
                centre + grain_radius * (elementary::cos(angle) * camera_.right + up * camera_.up);
            return AirVertex{glm::vec3(at), glm::mix(grain_shade, grain_light,
                                                     static_cast<float>(0.5 + 0.5 * up))};
        };
        const AirVertex middle{glm::vec3(centre), glm::mix(grain_shade, grain_light, 0.75F)};
        for (int i = 0; i < grain_corners; ++i) {
            grains_.push_back(middle);
            grains_.push_back(corner(i));
            grains_.push_back(corner(i + 1));
        }
    }

    const Snapshot& strip_;
    const Block& block_;
    const Camera& camera_;
    int cells_ = 0;
    double length_ = 0.0;
    std::vector<AirVertex> ribbons_;
    std::vector<AirVertex> grains_;
};

}  // namespace

std::vector<AirVertex> grain_paths(const Snapshot& strip, const Block& block,
                                   const Camera& camera) {
    Ribbons ribbons(strip, block, camera);
    // Far ones first: nearer ones are blended over them.
    std::vector<std::pair<double, std::size_t>> positions;
    for (std::size_t i = 0; i < strip.section->paths.size(); ++i) {
        const double share = fraction(golden_share * static_cast<double>(i + 1));
        positions.emplace_back((share - 0.5) * used_depth * block.width_y, i);
    }
    std::sort(positions.begin(), positions.end());
    if (camera.forward.y >= 0.0) std::reverse(positions.begin(), positions.end());
    for (const auto& [y, i] : positions)
        ribbons.add(strip.section->paths[i], y,
                    fraction(golden_share * golden_share * static_cast<double>(i + 1)));
    return ribbons.triangles();
}

}  // namespace fumon
