#include "figure/panels/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/truncation.h"
#include "render/view/terrain_occlusion.h"

namespace fumon {

namespace {

constexpr Ink contour_ink{0.20, 0.12, 0.06, 0.80};
constexpr double thin_width_em = 0.045;  // font sizes, as are the lengths
constexpr double thick_width_em = 0.085;
constexpr double label_size_em = 0.65;
constexpr double label_room_em = 0.35;  // before and behind a label
constexpr double label_interval_em = 18.0;
constexpr double least_chord_ratio = 0.92;  // chord over length under a label, at least
constexpr double least_length_em = 1.0;     // of a line that is drawn: shorter ones are specks

double distance(const CanvasPoint& a, const CanvasPoint& b) {
    return elementary::hypot(b.x - a.x, b.y - a.y);
}

/// A line that knows how long it is up to each of its points.
class MeasuredLine {
  public:
    explicit MeasuredLine(const std::vector<CanvasPoint>& points) : points_(points) {
        lengths_.reserve(points.size());
        double length = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) length += distance(points[i - 1], points[i]);
            lengths_.push_back(length);
        }
    }

    [[nodiscard]] double length() const { return lengths_.empty() ? 0.0 : lengths_.back(); }

    [[nodiscard]] CanvasPoint at(double length) const {
        const std::size_t i = next_point(length);
        if (i == 0) return points_.front();
        const double step = lengths_[i] - lengths_[i - 1];
        const double t = step > 0.0 ? (length - lengths_[i - 1]) / step : 0.0;
        return {std::lerp(points_[i - 1].x, points_[i].x, t),
                std::lerp(points_[i - 1].y, points_[i].y, t)};
    }

    [[nodiscard]] std::vector<CanvasPoint> part(double from, double to) const {
        std::vector<CanvasPoint> found{at(from)};
        for (std::size_t i = next_point(from); i < points_.size() && lengths_[i] < to; ++i) {
            if (lengths_[i] > from) found.push_back(points_[i]);
        }
        found.push_back(at(to));
        return found;
    }

  private:
    [[nodiscard]] std::size_t next_point(double length) const {
        const auto found = std::ranges::lower_bound(lengths_, length);
        return found == lengths_.end() ? lengths_.size() - 1
                                       : static_cast<std::size_t>(found - lengths_.begin());
    }

    const std::vector<CanvasPoint>& points_;
    std::vector<double> lengths_;
};

/// Where a label stands on its line: in a gap between two lengths.
struct LabelGap {
    double from = 0.0;
    double to = 0.0;
    CanvasPoint middle;
    double angle = 0.0;
};

class Labels {
  public:
    Labels(const Canvas& canvas, const CanvasBox& frame, std::vector<CanvasBox> taken)
        : canvas_(canvas), frame_(frame), taken_(std::move(taken)) {}

    /// One about every label_every font sizes, each where the line is straightest.
    std::vector<LabelGap> on(const MeasuredLine& line, const std::string& text) {
        const auto [width, height] = canvas_.text_size(text, label_size_em);
        const double gap = width + 2.0 * label_room_em * canvas_.font_size();
        std::vector<LabelGap> found;
        const double length = line.length();
        if (length < 2.0 * gap) return found;
        const int count =
            truncated_within(length / (label_interval_em * canvas_.font_size()), 1, 1 << 20);
        for (int i = 0; i < count; ++i) {
            const double begin = length * i / count;
            const double end = length * (i + 1) / count - gap;
            std::optional<LabelGap> best;
            double best_chord = least_chord_ratio * gap;
            for (double from = begin; from <= end; from += 0.25 * gap) {
                const CanvasPoint a = line.at(from);
                const CanvasPoint b = line.at(from + gap);
                const double chord = distance(a, b);
                if (chord < best_chord) continue;
                const LabelGap place = place_between(a, b, from, from + gap);
                if (!free(box_of(place, width, height))) continue;
                best = place;
                best_chord = chord * (1.0 + 1e-9);
            }
            if (!best) continue;
            found.push_back(*best);
            taken_.push_back(box_of(*best, width, height));
        }
        return found;
    }

    [[nodiscard]] const std::vector<CanvasBox>& taken() const { return taken_; }

  private:
    static LabelGap place_between(const CanvasPoint& a, const CanvasPoint& b, double from,
                                  double to) {
        double angle = elementary::atan2(b.y - a.y, b.x - a.x);
        constexpr double half = 0.5 * std::numbers::pi;
        if (angle > half) angle -= std::numbers::pi;
        if (angle <= -half) angle += std::numbers::pi;
        return {from, to, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, angle};
    }

    static CanvasBox box_of(const LabelGap& place, double width, double height) {
        const double across = std::abs(elementary::cos(place.angle));
        const double down = std::abs(elementary::sin(place.angle));
        const double wide = across * width + down * height;
        const double tall = down * width + across * height;
        return {place.middle.x - 0.5 * wide, place.middle.y - 0.5 * tall, wide, tall};
    }

    [[nodiscard]] bool free(const CanvasBox& box) const {
        const double room = canvas_.font_size();
        if (!within(grown(box, 0.4 * room), frame_)) return false;
        return std::ranges::none_of(
            taken_, [&](const CanvasBox& other) { return overlap(grown(box, room), other); });
    }

    const Canvas& canvas_;
    CanvasBox frame_;
    std::vector<CanvasBox> taken_;
};

}  // namespace

std::vector<CanvasContour> visible_contours(const GroundContours& contours,
                                            const Snapshot& snapshot, const ViewProjection& view) {
    const TerrainOcclusion ground(snapshot, view.block, view.camera);
    std::vector<CanvasContour> lines;
    for (const ContourLine& line : contours.lines) {
        CanvasContour part{line.level, {}};
        for (const glm::dvec2& point : line.points) {
            if (ground.visible(point)) {
                part.points.push_back(view.at(ground.point(point)));
            } else if (!part.points.empty()) {
                lines.push_back(std::exchange(part, {line.level, {}}));
            }
        }
        if (!part.points.empty()) lines.push_back(std::move(part));
    }
    return lines;
}

std::vector<CanvasBox> draw_contours(Canvas& canvas, const CanvasBox& frame,
                                     const std::vector<CanvasContour>& lines, double interval,
                                     std::vector<CanvasBox> taken) {
    const double font = canvas.font_size();
    const CanvasClip clip(canvas, frame);
    Labels labels(canvas, frame, std::move(taken));
    std::vector<std::size_t> longest(lines.size());
    std::iota(longest.begin(), longest.end(), std::size_t{0});
    // Long lines take their labels first.
    std::vector<double> lengths;
    lengths.reserve(lines.size());
    for (const CanvasContour& line : lines) lengths.push_back(MeasuredLine(line.points).length());
    std::ranges::stable_sort(longest,
                             [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    for (const std::size_t number : longest) {
        const CanvasContour& line = lines[number];
        if (lengths[number] < least_length_em * font) continue;
        if (!is_index_contour(line.level, interval)) {
            canvas.stroke(line.points, thin_width_em * font, contour_ink);
            continue;
        }
        const MeasuredLine measured(line.points);
        const std::string text = contour_label(line.level, interval);
        double from = 0.0;
        for (const LabelGap& place : labels.on(measured, text)) {
            if (place.from > from)
                canvas.stroke(measured.part(from, place.from), thick_width_em * font, contour_ink);
            canvas.write_turned(text, place.middle, place.angle, contour_ink, label_size_em);
            from = place.to;
        }
        canvas.stroke(measured.part(from, measured.length()), thick_width_em * font, contour_ink);
    }
    return labels.taken();
}

}  // namespace fumon
