#include "render/view/mask_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace fumon {

namespace {

constexpr double farthest_move = 0.5;  // cells, along x and along y
constexpr double hold = 0.03;  // of a corner by its place, against the pull of both neighbours
constexpr double over_relaxation = 1.7;
constexpr int pulling_rounds = 120;
constexpr std::size_t smallest_loop = 24;  // corners: shorter ones would be pulled together

/// A heading along the edges of cells: to the next corner.
enum Heading : std::uint8_t { eastward, northward, westward, southward };
constexpr std::array<std::array<int, 2>, 4> heading_steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// A corner of cells that the outline passes.
struct Corner {
    int x;
    int y;
    bool fixed;
};

/// Follows the edges between cells with data, on the left, and others.
class Tracer {
  public:
    explicit Tracer(const Mask& nodata)
        : nodata_(nodata),
          headings_(nodata.nx() + 1, nodata.ny() + 1, 0),
          all_headings_(headings_) {
        for (int y = 0; y < nodata.ny(); ++y) {
            for (int x = 0; x < nodata.nx(); ++x) {
                if (!has_data(x, y)) continue;
                if (!has_data(x, y - 1)) headings_(x, y) |= 1U << eastward;
                if (!has_data(x + 1, y)) headings_(x + 1, y) |= 1U << northward;
                if (!has_data(x, y + 1)) headings_(x + 1, y + 1) |= 1U << westward;
                if (!has_data(x - 1, y)) headings_(x, y + 1) |= 1U << southward;
            }
        }
        all_headings_ = headings_;
    }

    std::vector<std::vector<Corner>> loops() {
        std::vector<std::vector<Corner>> found;
        for (int y = 0; y <= nodata_.ny(); ++y)
            for (int x = 0; x <= nodata_.nx(); ++x)
                while (headings_(x, y) != 0) found.push_back(loop_from(x, y));
        return found;
    }

  private:
    [[nodiscard]] bool has_data(int x, int y) const {
        return x >= 0 && y >= 0 && x < nodata_.nx() && y < nodata_.ny() && nodata_(x, y) == 0;
    }

    /// Where two parts touch in a corner, each keeps to its own side: it turns left.
    std::vector<Corner> loop_from(int x, int y) {
        std::vector<Corner> loop;
        unsigned heading = 0;
        while ((headings_(x, y) >> heading & 1U) == 0) ++heading;
        while (headings_(x, y) != 0) {
            const std::uint8_t open = headings_(x, y);
            const unsigned all = all_headings_(x, y);
            const bool touching = (all & (all - 1U)) != 0;
            if (!loop.empty()) {
                for (const unsigned turn : {1U, 0U, 3U, 2U}) {
                    const unsigned next = (heading + turn) % 4U;
                    if ((open >> next & 1U) == 0) continue;
                    heading = next;
                    break;
                }
            }
            const bool border = x == 0 || y == 0 || x == nodata_.nx() || y == nodata_.ny();
            loop.push_back({x, y, border || touching});
            headings_(x, y) = static_cast<std::uint8_t>(open & ~(1U << heading));
            x += heading_steps.at(heading)[0];
            y += heading_steps.at(heading)[1];
            if (x == loop.front().x && y == loop.front().y) break;
        }
        return loop;
    }

    const Mask& nodata_;
    Field<std::uint8_t> headings_;  // a bit for each that leads away from a corner, not yet gone
    Field<std::uint8_t> all_headings_;
};

OutlineLoop pulled_straight(const std::vector<Corner>& corners) {
    OutlineLoop line;
    line.reserve(corners.size());
    for (const Corner& corner : corners)
        line.push_back({static_cast<double>(corner.x), static_cast<double>(corner.y)});
    const std::size_t count = line.size();
    const bool small = count < smallest_loop;
    const double factor = small ? 0.5 : over_relaxation;
    for (int round = 0; round < (small ? 1 : pulling_rounds); ++round) {
        for (std::size_t i = 0; i < count; ++i) {
            const Corner& corner = corners[i];
            if (corner.fixed) continue;
            const OutlinePoint& before = line[i == 0 ? count - 1 : i - 1];
            const OutlinePoint& after = line[i + 1 == count ? 0 : i + 1];
            const auto moved = [&](double from, double one, double other, int home) {
                const double pulled =
                    (0.5 * (one + other) + 0.5 * hold * home) / (1.0 + 0.5 * hold);
                return std::clamp(from + factor * (pulled - from), home - farthest_move,
                                  home + farthest_move);
            };
            line[i] = {moved(line[i].x, before.x, after.x, corner.x),
                       moved(line[i].y, before.y, after.y, corner.y)};
        }
    }
    return line;
}

OutlinePoint nearest_on(OutlinePoint from, OutlinePoint to, OutlinePoint point) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double squared = x * x + y * y;
    if (squared == 0.0) return from;
    const double share =
        std::clamp(((point.x - from.x) * x + (point.y - from.y) * y) / squared, 0.0, 1.0);
    return {from.x + share * x, from.y + share * y};
}

}  // namespace

std::vector<OutlineLoop> mask_outline(const Mask& nodata) {
    std::vector<OutlineLoop> outline;
    for (const std::vector<Corner>& loop : Tracer(nodata).loops())
        outline.push_back(pulled_straight(loop));
    return outline;
}

Mask outside_of(const std::vector<OutlineLoop>& outline, int nx, int ny, int refinement) {
    Mask outside(nx * refinement, ny * refinement, 1);
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(outside.ny()));
    const auto rows = static_cast<double>(refinement);
    for (const OutlineLoop& loop : outline) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            OutlinePoint from = loop[i];
            OutlinePoint to = loop[i + 1 == loop.size() ? 0 : i + 1];
            if (from.y > to.y) std::swap(from, to);
            // Rows whose middles lie within from.y … to.y, the upper end not counted.
            const int begin = std::max(static_cast<int>(std::ceil(from.y * rows - 0.5)), 0);
            const int end = std::min(static_cast<int>(std::ceil(to.y * rows - 0.5)), outside.ny());
            for (int row = begin; row < end; ++row) {
                const double share = ((row + 0.5) / rows - from.y) / (to.y - from.y);
                crossings[static_cast<std::size_t>(row)].push_back(from.x +
                                                                   share * (to.x - from.x));
            }
        }
    }
    for (int row = 0; row < outside.ny(); ++row) {
        std::vector<double>& at = crossings[static_cast<std::size_t>(row)];
        std::sort(at.begin(), at.end());
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
            const int begin = std::max(static_cast<int>(std::ceil(at[k] * rows - 0.5)), 0);
            const int end =
                std::min(static_cast<int>(std::ceil(at[k + 1] * rows - 0.5)), outside.nx());
            for (int column = begin; column < end; ++column) outside(column, row) = 0;
        }
    }
    return outside;
}

OutlineSearch::OutlineSearch(const std::vector<OutlineLoop>& outline, int nx, int ny)
    : nx_(nx), ny_(ny) {
    struct Placed {
        std::size_t cell;
        Piece piece;
    };
    std::vector<Placed> placed;
    for (const OutlineLoop& loop : outline) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Piece piece{loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]};
            const int x =
                std::clamp(static_cast<int>(0.5 * (piece.from.x + piece.to.x)), 0, nx - 1);
            const int y =
                std::clamp(static_cast<int>(0.5 * (piece.from.y + piece.to.y)), 0, ny - 1);
            placed.push_back({static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) +
                                  static_cast<std::size_t>(x),
                              piece});
        }
    }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const Placed& one, const Placed& other) { return one.cell < other.cell; });
    first_.assign(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) + 1, 0);
    for (const Placed& at : placed) ++first_[at.cell + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    pieces_.reserve(placed.size());
    for (const Placed& at : placed) pieces_.push_back(at.piece);
}

OutlinePoint OutlineSearch::nearest(OutlinePoint to, double reach) const {
    const int around = static_cast<int>(std::ceil(reach)) + 1;  // a piece is a cell long
    const int x = std::clamp(static_cast<int>(to.x), 0, nx_ - 1);
    const int y = std::clamp(static_cast<int>(to.y), 0, ny_ - 1);
    OutlinePoint best = to;
    double least = reach * reach;
    for (int v = std::max(y - around, 0); v <= std::min(y + around, ny_ - 1); ++v) {
        const std::size_t row = static_cast<std::size_t>(v) * static_cast<std::size_t>(nx_);
        const auto west = static_cast<std::size_t>(std::max(x - around, 0));
        const auto last = static_cast<std::size_t>(std::min(x + around, nx_ - 1));
        for (std::size_t i = first_[row + west]; i < first_[row + last + 1]; ++i) {
            const OutlinePoint at = nearest_on(pieces_[i].from, pieces_[i].to, to);
            const double squared = (at.x - to.x) * (at.x - to.x) + (at.y - to.y) * (at.y - to.y);
            if (squared >= least) continue;
            least = squared;
            best = at;
        }
    }
    return best;
}

}  // namespace fumon
