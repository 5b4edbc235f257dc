#include "render/life/footprints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/random.h"

namespace fumon {

namespace {

constexpr double usual_depth = 0.027;    // metres, in loose sand
constexpr double toes_out = 0.12;        // of a foot's way, to its own side
constexpr double off_the_line = 0.012;   // metres, at most, across; twice that along
constexpr double turned_off = 0.07;      // of a foot's way, at most
constexpr double uneven_depth = 0.22;    // of the depth, at most
constexpr double turn_of_walker = 0.45;  // metres before and behind, over which a walker turns

/// A line of points, by the distance along it.
class Line {
  public:
    explicit Line(const std::vector<double>& numbers) {
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
            const glm::dvec2 point(numbers[i], numbers[i + 1]);
            const double run = points_.empty() ? 0.0 : glm::distance(points_.back(), point);
            if (!points_.empty() && run == 0.0) continue;
            along_.push_back(points_.empty() ? 0.0 : along_.back() + run);
            points_.push_back(point);
        }
    }

    [[nodiscard]] double length() const { return along_.empty() ? 0.0 : along_.back(); }

    /// Beyond the ends it goes on straight.
    [[nodiscard]] glm::dvec2 at(double along) const {
        const auto next = std::upper_bound(along_.begin() + 1, along_.end() - 1, along);
        const auto i = static_cast<std::size_t>(next - along_.begin());
        const double share = (along - along_[i - 1]) / (along_[i] - along_[i - 1]);
        return points_[i - 1] + share * (points_[i] - points_[i - 1]);
    }

  private:
    std::vector<glm::dvec2> points_;
    std::vector<double> along_;
};

}  // namespace

double track_length(const TrackSettings& track) {
    return Line(track.along).length();
}

std::vector<Footprint> footprints(const TrackSettings& track, std::uint32_t number) {
    const Line line(track.along);
    std::vector<Footprint> prints;
    if (line.length() <= 0.0) return prints;
    const auto count = static_cast<std::int64_t>(line.length() / step_length + 1e-9) + 1;
    for (std::int64_t i = 0; i < count; ++i) {
        RandomStream random(static_cast<std::uint64_t>(track.seed), number, i, Purpose::footprints);
        const auto uneven = [&] { return 2.0 * random.uniform() - 1.0; };
        const double along = static_cast<double>(i) * step_length;
        const glm::dvec2 way =
            glm::normalize(line.at(along + turn_of_walker) - line.at(along - turn_of_walker));
        const glm::dvec2 rightward(way.y, -way.x);
        Footprint print;
        print.right = i % 2 == 1;
        const double side = print.right ? 1.0 : -1.0;
        const double forward = 2.0 * off_the_line * uneven();
        const double aside = side * half_step_width + off_the_line * uneven();
        print.at = line.at(along) + aside * rightward + forward * way;
        print.heading = glm::normalize(way + (side * toes_out + turned_off * uneven()) * rightward);
        print.depth = usual_depth * (1.0 + uneven_depth * uneven());
        print.unevenness = random.uniform();
        prints.push_back(print);
    }
    return prints;
}

}  // namespace fumon
