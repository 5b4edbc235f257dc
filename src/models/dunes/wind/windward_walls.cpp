#include "models/dunes/wind/windward_walls.h"

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr double still_at = 0.4;                     // of the wall's height, before it
constexpr double free_at = 2.0;                      // likewise
constexpr double back_at_foot = 0.5;                 // of the wind
constexpr double aside_before = 1.0;                 // of the wall's height
constexpr double top_tangent = 0.57735026918962573;  // of 30 degrees

double wind_at(double s) {
    if (s >= free_at) return 1.0;
    if (s >= still_at) return (s - still_at) / (free_at - still_at);
    return back_at_foot * (s / still_at - 1.0);
}

double aside_at(double s) {
    return std::clamp((aside_before - s) / (aside_before - still_at), 0.0, 1.0);
}

}  // namespace

WindwardWalls::WindwardWalls(const DuneGround& ground, double tangent, double drift,
                             WorkerPool& pool)
    : ground_(ground),
      tangent_(tangent),
      drift_(drift),
      pool_(pool),
      feet_(static_cast<std::size_t>(ground.ny)),
      wind_(ground.nx, ground.ny, 1.0) {
    if (drift == 0.0) return;
    aside_ = Grid(ground.nx, ground.ny);
    outward_ = Grid(ground.nx, ground.ny);
    waiting_ = Field<char>(ground.nx, ground.ny);
}

bool WindwardWalls::place(const Line& line, int x, int y, int n, int& to_x, int& to_y) const {
    const auto find = [](double cell, int count, bool periodic, int& found) {
        double at = std::floor(cell + 0.5);
        if (periodic) at -= count * std::floor(at / count);
        found = static_cast<int>(at);
        return found >= 0 && found < count;
    };
    return find(x + n * line.x, ground_.nx, ground_.periodic_x, to_x) &&
           find(y + n * line.y, ground_.ny, ground_.periodic_y, to_y);
}

bool WindwardWalls::height_at(const FixedPointGrid& surface, const Line& line, int x, int y, int n,
                              std::int64_t& height) const {
    int to_x = 0;
    int to_y = 0;
    if (!place(line, x, y, n, to_x, to_y)) return false;
    height = surface(to_x, to_y);
    return true;
}

void WindwardWalls::find(const FixedPointGrid& surface, const BlowingWind& wind) {
    std::ranges::fill(wind_.values(), 1.0);
    const double cells_x = wind.x / ground_.dx;
    const double cells_y = wind.y / ground_.dy;
    const double most = std::max(std::abs(cells_x), std::abs(cells_y));
    const Line line{cells_x / most, cells_y / most, 1.0 / most};
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            find_feet(surface, line, y);
        }
    });
    if (drift_ > 0.0) {
        std::ranges::fill(aside_.values(), 0.0);
        find_outflow_directions(wind);
    }
    for (int y = 0; y < ground_.ny; ++y) {
        for (const int x : feet_[static_cast<std::size_t>(y)]) slacken_before(surface, line, x, y);
    }
}

void WindwardWalls::find_outflow_directions(const BlowingWind& wind) {
    for (int y = 0; y < ground_.ny; ++y) {
        for (const int x : feet_[static_cast<std::size_t>(y)]) waiting_(x, y) = 1;
    }
    for (int y = 0; y < ground_.ny; ++y) {
        for (const int x : feet_[static_cast<std::size_t>(y)]) {
            if (waiting_(x, y) != 0) follow_wall(x, y, wind);
        }
    }
}

void WindwardWalls::follow_wall(int x, int y, const BlowingWind& wind) {
    constexpr int touching = 2;  // cells: feet of a wall askew to the grid stand apart
    struct Foot {
        int x;  ///< going on past the edges of a periodic bed
        int y;
    };
    const auto in_bed = [](int cell, int count) { return ((cell % count) + count) % count; };
    std::vector<Foot> feet{{x, y}};
    waiting_(x, y) = 0;
    for (std::size_t next = 0; next < feet.size(); ++next) {
        const Foot from = feet[next];
        for (int j = -touching; j <= touching; ++j) {
            for (int i = -touching; i <= touching; ++i) {
                const int to_x = from.x + i;
                const int to_y = from.y + j;
                if (!ground_.periodic_x && (to_x < 0 || to_x >= ground_.nx)) continue;
                if (!ground_.periodic_y && (to_y < 0 || to_y >= ground_.ny)) continue;
                char& waiting = waiting_(in_bed(to_x, ground_.nx), in_bed(to_y, ground_.ny));
                if (waiting == 0) continue;
                waiting = 0;
                feet.push_back({to_x, to_y});
            }
        }
    }
    const auto along = [&](const Foot& foot) {
        return foot.y * ground_.dy * wind.x - foot.x * ground_.dx * wind.y;
    };
    double least = along(feet.front());
    double most = least;
    for (const Foot& foot : feet) {
        least = std::min(least, along(foot));
        most = std::max(most, along(foot));
    }
    const double half = 0.5 * (most - least);
    const double round = std::abs(wind.x) > std::abs(wind.y)
                             ? (ground_.periodic_y ? ground_.ny * ground_.dy : 0.0)
                             : (ground_.periodic_x ? ground_.nx * ground_.dx : 0.0);
    const double apart = touching * std::max(ground_.dx, ground_.dy);
    const bool endless = round > 0.0 && 2.0 * half + apart >= round;
    for (const Foot& foot : feet) {
        const double place = half > 0.0 ? (along(foot) - least) / half - 1.0 : 0.0;
        outward_(in_bed(foot.x, ground_.nx), in_bed(foot.y, ground_.ny)) =
            endless ? 0.0 : std::clamp(4.0 * place, -1.0, 1.0);
    }
}

void WindwardWalls::find_feet(const FixedPointGrid& surface, const Line& line, int y) {
    std::vector<int>& feet = feet_[static_cast<std::size_t>(y)];
    feet.clear();
    const double steep = tangent_ * line.distance * units_per_metre;
    const int ahead_x = static_cast<int>(std::floor(line.x + 0.5));
    const int ahead_y = static_cast<int>(std::floor(line.y + 0.5));
    const bool inside_y = y + ahead_y >= 0 && y + ahead_y < ground_.ny;
    for (int x = 0; x < ground_.nx; ++x) {
        const std::int64_t here = surface(x, y);
        std::int64_t ahead = 0;
        if (inside_y && x + ahead_x >= 0 && x + ahead_x < ground_.nx) {
            ahead = surface(x + ahead_x, y + ahead_y);
        } else if (!height_at(surface, line, x, y, 1, ahead)) {
            continue;
        }
        if (static_cast<double>(ahead - here) <= steep) continue;
        std::int64_t behind = 0;
        const bool within_wall = height_at(surface, line, x, y, -1, behind) &&
                                 static_cast<double>(here - behind) > steep;
        if (!within_wall) feet.push_back(x);
    }
}

void WindwardWalls::slacken_before(const FixedPointGrid& surface, const Line& line, int x, int y) {
    const int longest = std::max(ground_.nx, ground_.ny);
    const double rises = top_tangent * line.distance * units_per_metre;
    std::int64_t top = surface(x, y);
    for (int n = 1; n < longest; ++n) {
        std::int64_t height = 0;
        if (!height_at(surface, line, x, y, n, height)) break;
        if (static_cast<double>(height - top) < rises) break;
        top = height;
    }
    const double height = to_metres(top - surface(x, y));
    for (int n = 0; n < longest && n * line.distance < free_at * height; ++n) {
        int to_x = 0;
        int to_y = 0;
        if (!place(line, x, y, -n, to_x, to_y)) break;
        const double above = to_metres(top - surface(to_x, to_y));
        if (above <= 0.0) break;
        const double s = n * line.distance / above;
        double& wind = wind_(to_x, to_y);
        if (drift_ > 0.0 && wind_at(s) < wind)
            aside_(to_x, to_y) = drift_ * outward_(x, y) * aside_at(s);
        wind = std::min(wind, wind_at(s));
    }
}

}  // namespace fumon
