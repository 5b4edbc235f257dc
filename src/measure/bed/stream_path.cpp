#include "measure/bed/stream_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

struct Neighbour {
    int x;
    int y;
};
constexpr std::array<Neighbour, 8> neighbours{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
constexpr std::int8_t outlet = -1;

class Flood {
  public:
    Flood(const Grid& level, const Mask& nodata)
        : filled_(level), nodata_(nodata), toward_(level.nx(), level.ny(), outlet) {
        fill();
    }

    [[nodiscard]] double level(int x, int y) const { return filled_(x, y); }
    /// The neighbour by which the flood came; `outlet` at the rim.
    [[nodiscard]] std::int8_t toward(int x, int y) const { return toward_(x, y); }
    [[nodiscard]] bool inside(int x, int y) const {
        return x >= 0 && y >= 0 && x < filled_.nx() && y < filled_.ny() &&
               (nodata_.empty() || nodata_(x, y) == 0);
    }

  private:
    struct Cell {
        double level;
        std::int64_t number;  ///< of those that came in: equal levels leave in order
        int x;
        int y;
        bool operator<(const Cell& other) const {
            return level != other.level ? level > other.level : number > other.number;
        }
    };

    [[nodiscard]] bool at_rim(int x, int y) const {
        return std::ranges::any_of(
            neighbours, [&](const Neighbour& step) { return !inside(x + step.x, y + step.y); });
    }

    void fill() {
        Mask known(filled_.nx(), filled_.ny());
        std::priority_queue<Cell> rim;
        std::int64_t number = 0;
        for (int y = 0; y < filled_.ny(); ++y) {
            for (int x = 0; x < filled_.nx(); ++x) {
                if (!inside(x, y) || !at_rim(x, y)) continue;
                known(x, y) = 1;
                rim.push({filled_(x, y), number++, x, y});
            }
        }
        while (!rim.empty()) {
            const Cell cell = rim.top();
            rim.pop();
            for (std::size_t k = 0; k < neighbours.size(); ++k) {
                const int x = cell.x + neighbours[k].x;
                const int y = cell.y + neighbours[k].y;
                if (!inside(x, y) || known(x, y) != 0) continue;
                known(x, y) = 1;
                filled_(x, y) = std::max(filled_(x, y), cell.level);
                toward_(x, y) = static_cast<std::int8_t>(back(k));
                rim.push({filled_(x, y), number++, x, y});
            }
        }
    }

    /// The neighbour opposite to one.
    static std::size_t back(std::size_t k) { return k < 4 ? (k + 2) % 4 : 4 + (k - 2) % 4; }

    Grid filled_;
    const Mask& nodata_;
    Field<std::int8_t> toward_;
};

}  // namespace

StreamPath stream_path(const Grid& level, const Mask& nodata, double dx, double dy, int x, int y) {
    const bool in_grid = x >= 0 && y >= 0 && x < level.nx() && y < level.ny();
    if (!in_grid || (!nodata.empty() && nodata(x, y) != 0)) {
        throw InputError(fmt::format("cell ({}, {}) {}", x, y,
                                     in_grid ? "has no data" : "lies outside the grid"));
    }
    const Flood flood(level, nodata);
    const auto length = [&](const Neighbour& step) {
        return std::sqrt(step.x * step.x * dx * dx + step.y * step.y * dy * dy);
    };
    StreamPath path;
    for (double distance = 0.0;;) {
        path.x.push_back(x);
        path.y.push_back(y);
        path.distance.push_back(distance);
        int next = flood.toward(x, y);
        if (next == outlet) return path;
        double steepest = 0.0;
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const Neighbour& step = neighbours[k];
            if (!flood.inside(x + step.x, y + step.y)) continue;
            const double fall =
                (flood.level(x, y) - flood.level(x + step.x, y + step.y)) / length(step);
            if (fall <= steepest) continue;
            steepest = fall;
            next = static_cast<int>(k);
        }
        const Neighbour& step = neighbours[static_cast<std::size_t>(next)];
        distance += length(step);
        x += step.x;
        y += step.y;
    }
}

}  // namespace fumon
