#include "numerics/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace fumon {

namespace {

/// The sides of a square of four cells, as numbers: south, east, north, west.
constexpr int no_side = -1;

/// From which side the line goes to which, higher ground on its left; two lines at most.
using Passages = std::array<std::array<int, 2>, 2>;

class Tracer {
  public:
    Tracer(const Grid& values, const Mask& nodata, double level)
        : values_(values), nodata_(nodata), level_(level), left_(values.nx(), values.ny(), 0) {}

    std::vector<ContourLine> lines() {
        for (int y = 0; y + 1 < values_.ny(); ++y) {
            for (int x = 0; x + 1 < values_.nx(); ++x) left_(x, y) = crossed(x, y);
        }
        std::vector<ContourLine> found;
        for (int y = 0; y + 1 < values_.ny(); ++y) {
            for (int x = 0; x + 1 < values_.nx(); ++x) {
                for (int passage = 0; passage < 2; ++passage) {
                    if ((left_(x, y) & (1 << passage)) != 0)
                        found.push_back(line_through(x, y, passage));
                }
            }
        }
        return found;
    }

  private:
    [[nodiscard]] bool known(int x, int y) const {
        return std::isfinite(values_(x, y)) && (nodata_.empty() || nodata_(x, y) == 0);
    }
    [[nodiscard]] bool higher(int x, int y) const { return values_(x, y) >= level_; }

    /// Of the square whose south-western cell this is.
    [[nodiscard]] Passages passages(int x, int y) const {
        constexpr int south = 0;
        constexpr int east = 1;
        constexpr int north = 2;
        constexpr int west = 3;
        constexpr std::array<int, 2> none{no_side, no_side};
        const int corners = (higher(x, y) ? 1 : 0) + (higher(x + 1, y) ? 2 : 0) +
                            (higher(x + 1, y + 1) ? 4 : 0) + (higher(x, y + 1) ? 8 : 0);
        const auto one = [&](int from, int to) { return Passages{{{from, to}, none}}; };
        switch (corners) {
            case 1:
                return one(south, west);
            case 2:
                return one(east, south);
            case 3:
                return one(east, west);
            case 4:
                return one(north, east);
            case 6:
                return one(north, south);
            case 7:
                return one(north, west);
            case 8:
                return one(west, north);
            case 9:
                return one(south, north);
            case 11:
                return one(east, north);
            case 12:
                return one(west, east);
            case 13:
                return one(south, east);
            case 14:
                return one(west, south);
            case 5:
            case 10:
                break;
            default:
                return {none, none};
        }
        const double middle =
            0.25 * (values_(x, y) + values_(x + 1, y) + values_(x, y + 1) + values_(x + 1, y + 1));
        const bool joined = middle >= level_;  // the two higher corners
        if (corners == 5)
            return joined ? Passages{{{south, east}, {north, west}}}
                          : Passages{{{south, west}, {north, east}}};
        return joined ? Passages{{{east, north}, {west, south}}}
                      : Passages{{{east, south}, {west, north}}};
    }

    /// Bits 1 and 2: the passages that are there.
    [[nodiscard]] std::uint8_t crossed(int x, int y) const {
        if (!known(x, y) || !known(x + 1, y) || !known(x, y + 1) || !known(x + 1, y + 1)) return 0;
        const Passages here = passages(x, y);
        return static_cast<std::uint8_t>((here[0][0] != no_side ? 1 : 0) +
                                         (here[1][0] != no_side ? 2 : 0));
    }

    [[nodiscard]] glm::dvec2 point_on(int x, int y, int side) const {
        const auto between = [&](int x0, int y0, int x1, int y1) {
            const double a = values_(x0, y0);
            const double b = values_(x1, y1);
            const double t = std::clamp((level_ - a) / (b - a), 0.0, 1.0);
            return glm::dvec2(x0 + t * (x1 - x0), y0 + t * (y1 - y0));
        };
        switch (side) {
            case 0:
                return between(x, y, x + 1, y);
            case 1:
                return between(x + 1, y, x + 1, y + 1);
            case 2:
                return between(x, y + 1, x + 1, y + 1);
            default:
                return between(x, y, x, y + 1);
        }
    }

    /// A square and one of its passages.
    struct PassageReference {
        int x = 0;
        int y = 0;
        int passage = 0;
        bool found = false;
    };

    /// What goes on beyond a side; `entering`: the end of a passage that lies on the shared side.
    [[nodiscard]] PassageReference beyond(int x, int y, int side, std::size_t end) const {
        constexpr std::array<int, 4> dx{0, 1, 0, -1};
        constexpr std::array<int, 4> dy{-1, 0, 1, 0};
        const auto s = static_cast<std::size_t>(side);
        PassageReference next{x + dx.at(s), y + dy.at(s), 0, false};
        if (next.x < 0 || next.y < 0 || next.x + 1 >= values_.nx() || next.y + 1 >= values_.ny())
            return next;
        const Passages there = passages(next.x, next.y);
        const int shared = (side + 2) % 4;
        for (next.passage = 0; next.passage < 2; ++next.passage) {
            const auto p = static_cast<std::size_t>(next.passage);
            next.found =
                there.at(p).at(end) == shared && (left_(next.x, next.y) & (1 << next.passage)) != 0;
            if (next.found) break;
        }
        return next;
    }

    ContourLine line_through(int x, int y, int passage) {
        // Back to where it begins: at an edge, or where it closes.
        PassageReference first{x, y, passage, true};
        for (;;) {
            const int from =
                passages(first.x, first.y).at(static_cast<std::size_t>(first.passage))[0];
            const PassageReference before = beyond(first.x, first.y, from, 1);
            if (!before.found || (before.x == x && before.y == y && before.passage == passage))
                break;
            first = before;
        }
        ContourLine line;
        line.level = level_;
        line.points.push_back(
            point_on(first.x, first.y,
                     passages(first.x, first.y).at(static_cast<std::size_t>(first.passage))[0]));
        for (PassageReference at = first; at.found;) {
            const int to = passages(at.x, at.y).at(static_cast<std::size_t>(at.passage))[1];
            line.points.push_back(point_on(at.x, at.y, to));
            left_(at.x, at.y) = static_cast<std::uint8_t>(left_(at.x, at.y) & ~(1 << at.passage));
            at = beyond(at.x, at.y, to, 0);
        }
        return line;
    }

    const Grid& values_;
    const Mask& nodata_;
    double level_;
    Field<std::uint8_t> left_;  ///< passages that no line has taken yet, of each square
};

}  // namespace

std::vector<ContourLine> contour_lines(const Grid& values, const Mask& nodata, double level) {
    return Tracer(values, nodata, level).lines();
}

double contour_interval(double low, double high, int most) {
    const double range = high - low;
    if (!std::isfinite(range) || range <= 0.0) return 0.0;
    double power = 1.0;
    while (power * most > range) power /= 10.0;
    while (10.0 * power * most <= range) power *= 10.0;
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power * most >= range) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace fumon
