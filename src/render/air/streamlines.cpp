#include "render/air/streamlines.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/truncation.h"

namespace fumon {

namespace {

constexpr double nearest_share = 0.5;   // of the separation: where a line ends beside another
constexpr double closing_share = 0.25;  // … and beside an earlier place of its own
constexpr double step_share = 0.1;      // of the separation, at most longest_step
constexpr double longest_step = 2.0;    // pixels
constexpr double shortest_line = 1.0;   // in separations: shorter ones are left out
constexpr double still_air = 1e-6;      // of the fastest

/// A place of a line already drawn: its pixel, and how far along the line it lies.
struct LinePoint {
    glm::dvec2 at;
    int line;
    double along;
};

/// The places of all lines, sorted into square boxes one separation wide.
class LinePoints {
  public:
    LinePoints(double width, double height, double box)
        : box_(box),
          columns_(static_cast<int>(width / box) + 1),
          rows_(static_cast<int>(height / box) + 1),
          boxes_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    void add(const LinePoint& position) {
        boxes_[index(column_of(position.at), row_of(position.at))].push_back(position);
    }

    /// Whether refuses(place) for none of the places in the boxes around `at`.
    template <class Refuses>
    [[nodiscard]] bool free(glm::dvec2 at, Refuses refuses) const {
        const int column = column_of(at);
        const int row = row_of(at);
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r) {
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
                const std::vector<LinePoint>& box = boxes_[index(c, r)];
                if (std::any_of(box.begin(), box.end(), refuses)) return false;
            }
        }
        return true;
    }

  private:
    [[nodiscard]] int column_of(glm::dvec2 at) const {
        return truncated_within(at.x / box_, 0, columns_ - 1);
    }
    [[nodiscard]] int row_of(glm::dvec2 at) const {
        return truncated_within(at.y / box_, 0, rows_ - 1);
    }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    double box_;
    int columns_;
    int rows_;
    std::vector<std::vector<LinePoint>> boxes_;
};

/// Traces lines one after the other, in pixels counted from x = 0, z = 0.
class Tracer {
  public:
    Tracer(const SectionAir& air, const StreamlineSettings& settings, const SnapshotField& u,
           const SnapshotField& w)
        : air_(air),
          u_(u),
          w_(w),
          scale_(settings.pixels_per_metre_x, settings.pixels_per_metre_z),
          size_(air.length() * scale_.x, air.height() * scale_.y),
          separation_(settings.separation),
          step_(std::min(step_share * separation_, longest_step)),
          positions_(size_.x, size_.y, separation_) {
        double fastest = 0.0;
        for (std::size_t i = 0; i < u.values.values().size(); ++i)
            fastest =
                std::max(fastest, elementary::hypot(u.values.values()[i], w.values.values()[i]));
        slowest_ = still_air * fastest;
    }

    std::vector<Streamline> trace_all() {
        trace_lattice(
            [&](glm::dvec2 at) { return air_.value(u_, metres(at).x, metres(at).y) < 0; });
        trace_lattice([](glm::dvec2) { return true; });
        return std::move(lines_);
    }

  private:
    template <class Wanted>
    void trace_lattice(Wanted wanted) {
        const double spacing = 0.5 * separation_;
        const auto rows = static_cast<int>(std::lround(size_.y / spacing));
        const auto columns = static_cast<int>(std::lround(size_.x / spacing));
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const glm::dvec2 at = spacing * glm::dvec2(column + 0.5, row + 0.5);
                if (wanted(at)) trace_from(at);
            }
        }
    }

    /// The line through a seed, and then lines beside it and beside those.
    void trace_from(glm::dvec2 seed) {
        std::deque<std::vector<glm::dvec2>> beside;
        const auto try_seed = [&](glm::dvec2 at) {
            if (auto line = trace(at)) beside.push_back(std::move(*line));
        };
        try_seed(seed);
        while (!beside.empty()) {
            const std::vector<glm::dvec2> line = std::move(beside.front());
            beside.pop_front();
            for (const glm::dvec2 at : line) {
                const std::optional<glm::dvec2> along = direction(at);
                if (!along) continue;
                const glm::dvec2 across(-along->y, along->x);
                try_seed(at + separation_ * across);
                try_seed(at - separation_ * across);
            }
        }
    }

    /// The line through a seed in pixels; nothing where there is no room for one.
    std::optional<std::vector<glm::dvec2>> trace(glm::dvec2 seed) {
        if (!in_air(seed) || !far_enough(seed, (1.0 - 1e-9) * separation_)) return std::nullopt;
        own_ = LinePoints(size_.x, size_.y, separation_);
        own_->add({seed, 0, 0.0});
        std::vector<glm::dvec2> line = run(seed, -1.0);
        std::reverse(line.begin(), line.end());
        line.push_back(seed);
        const std::vector<glm::dvec2> down = run(seed, 1.0);
        line.insert(line.end(), down.begin(), down.end());
        if (step_ * static_cast<double>(line.size() - 1) < shortest_line * separation_)
            return std::nullopt;
        Streamline in_metres;
        in_metres.reserve(line.size());
        for (const glm::dvec2 at : line) {
            positions_.add({at, static_cast<int>(lines_.size()), 0.0});
            in_metres.push_back(metres(at));
        }
        lines_.push_back(std::move(in_metres));
        return line;
    }

    /// Goes with the air (sense 1) or against it (−1) by the midpoint rule in steps of equal
    /// length.
    std::vector<glm::dvec2> run(glm::dvec2 at, double sense) {
        std::vector<glm::dvec2> line;
        for (double along = step_;; along += step_) {
            const std::optional<glm::dvec2> here = direction(at);
            if (!here) return line;
            const std::optional<glm::dvec2> midway = direction(at + 0.5 * sense * step_ * *here);
            if (!midway) return line;
            at += sense * step_ * *midway;
            if (!in_air(at) || !far_enough(at, nearest_share * separation_)) return line;
            if (closes(at, sense * along)) return line;
            own_->add({at, 0, sense * along});
            line.push_back(at);
        }
    }

    [[nodiscard]] bool far_enough(glm::dvec2 at, double distance) const {
        return positions_.free(
            at, [&](const LinePoint& other) { return glm::distance(at, other.at) < distance; });
    }

    [[nodiscard]] bool closes(glm::dvec2 at, double along) const {
        return !own_->free(at, [&](const LinePoint& earlier) {
            return std::abs(along - earlier.along) > separation_ &&
                   glm::distance(at, earlier.at) < closing_share * separation_;
        });
    }

    [[nodiscard]] bool in_air(glm::dvec2 at) const {
        if (at.x < 0.0 || at.x > size_.x || at.y > size_.y) return false;
        return metres(at).y > air_.bed(metres(at).x);
    }

    [[nodiscard]] glm::dvec2 metres(glm::dvec2 at) const { return at / scale_; }

    /// Of the air as it is drawn; nothing where it stands still.
    [[nodiscard]] std::optional<glm::dvec2> direction(glm::dvec2 at) const {
        const glm::dvec2 position = metres(at);
        const glm::dvec2 velocity(air_.value(u_, position.x, position.y),
                                  air_.value(w_, position.x, position.y));
        if (!(glm::length(velocity) > slowest_)) return std::nullopt;
        return glm::normalize(velocity * scale_);
    }

    const SectionAir& air_;
    const SnapshotField& u_;
    const SnapshotField& w_;
    glm::dvec2 scale_;
    glm::dvec2 size_;
    double separation_;
    double step_;
    double slowest_ = 0.0;
    LinePoints positions_;
    std::optional<LinePoints> own_;  // of the line being traced
    std::vector<Streamline> lines_;
};

}  // namespace

std::vector<Streamline> streamlines(const SectionAir& air, const StreamlineSettings& settings) {
    if (!(settings.separation > 0.0) || !(settings.pixels_per_metre_x > 0.0) ||
        !(settings.pixels_per_metre_z > 0.0))
        throw Error("streamlines need a separation and scales above 0");
    const SnapshotField* u = air.find("velocity_x");
    const SnapshotField* w = air.find("velocity_z");
    if (u == nullptr || w == nullptr) return {};
    return Tracer(air, settings, *u, *w).trace_all();
}

}  // namespace fumon
