#include "drape/layer_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/elementary_angle.h"
#include "base/error.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"

namespace fumon {

namespace {

using Line = std::vector<BedPlace>;

constexpr double beside_everything = HUGE_VAL;  // as GDAL marks what it cannot bring

/// Brings every place of a layer to another reference system; those for which there is none
/// become infinite.
void bring(VectorLayer& layer, const std::string& to) {
    std::vector<double> x;
    std::vector<double> y;
    for (const VectorFeature& feature : layer.features) {
        for (const auto& part : feature.parts) {
            for (const VectorPoint& point : part) {
                x.push_back(point[0]);
                y.push_back(point[1]);
            }
        }
    }
    if (x.empty()) return;
    const GdalSession session;
    const SpatialReference own(layer.crs);
    const SpatialReference bed(to);
    constexpr double whole_turn = 360.0;
    const auto is_no_degree = [](double value) { return std::abs(value) > whole_turn; };
    const auto far = std::ranges::find_if(x, is_no_degree);
    if (own.understood() && own.is_geographic() && far != x.end()) {
        throw InputError(
            fmt::format("has no reference system, or a wrong one: longitudes and latitudes are "
                        "expected, and its coordinates reach {:.0f}; name the system that they are "
                        "in (ogr2ogr -a_srs, set_crs of a GeoDataFrame)",
                        *far));
    }
    OGRCoordinateTransformationH way =
        own.understood() && bed.understood()
            ? gdal().OCTNewCoordinateTransformation(own.get(), bed.get())
            : nullptr;
    if (way != nullptr) {
        std::vector<double> heights(x.size());
        gdal().OCTTransform(way, static_cast<int>(x.size()), x.data(), y.data(), heights.data());
        gdal().OCTDestroyCoordinateTransformation(way);
    }
    const auto finite = [](double value) { return std::isfinite(value); };
    if (way == nullptr || std::ranges::none_of(x, finite)) {
        throw InputError(fmt::format(
            "cannot be brought to the bed's reference system{}{}; bring it there first (ogr2ogr "
            "-t_srs)",
            session.fault().empty() ? "" : ": ", session.fault()));
    }
    std::size_t next = 0;
    for (VectorFeature& feature : layer.features) {
        for (auto& part : feature.parts) {
            for (VectorPoint& point : part) {
                point = finite(x[next]) && finite(y[next])
                            ? VectorPoint{x[next], y[next]}
                            : VectorPoint{beside_everything, beside_everything};
                ++next;
            }
        }
    }
}

bool is_somewhere(const BedPlace& place) {
    return std::isfinite(place[0]);
}

bool is_over_bed(const BedPlace& place) {
    return place[0] >= 0.0 && place[0] <= 1.0 && place[1] >= 0.0 && place[1] <= 1.0;
}

BedPlace between(const BedPlace& a, const BedPlace& b, double share) {
    return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
}

/// The part of a step that lies over the bed, as shares of it (Liang & Barsky 1984).
std::optional<std::array<double, 2>> shares_over_bed(const BedPlace& a, const BedPlace& b) {
    double from = 0.0;
    double to = 1.0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0.0) {
            if (a[axis] < 0.0 || a[axis] > 1.0) return std::nullopt;
            continue;
        }
        const double low = (way > 0.0 ? 0.0 - a[axis] : 1.0 - a[axis]) / way;
        const double high = (way > 0.0 ? 1.0 - a[axis] : 0.0 - a[axis]) / way;
        from = std::max(from, low);
        to = std::min(to, high);
    }
    if (!(from < to)) return std::nullopt;
    return std::array{from, to};
}

/// Clips lines and puts points between theirs.
class LineMaker {
  public:
    explicit LineMaker(const BedCells& bed) : bed_(bed) {}

    void add(const Line& line, std::vector<Line>& lines) const {
        Line part;
        const auto end_part = [&] {
            if (part.size() > 1) lines.push_back(std::move(part));
            part.clear();
        };
        for (std::size_t i = 1; i < line.size(); ++i) {
            const BedPlace& a = line[i - 1];
            const BedPlace& b = line[i];
            const auto shares =
                is_somewhere(a) && is_somewhere(b) ? shares_over_bed(a, b) : std::nullopt;
            if (!shares) {
                end_part();
                continue;
            }
            if (part.empty() || (*shares)[0] > 0.0) {
                end_part();
                part.push_back(between(a, b, (*shares)[0]));
            }
            add_steps(between(a, b, (*shares)[1]), part);
            if ((*shares)[1] < 1.0) end_part();
        }
        end_part();
    }

  private:
    /// From the last point of a part on, at most a cell at a time.
    void add_steps(const BedPlace& to, Line& part) const {
        const BedPlace from = part.back();
        const double cells =
            std::max(std::abs(to[0] - from[0]) * bed_.nx, std::abs(to[1] - from[1]) * bed_.ny);
        const int steps = std::max(1, static_cast<int>(std::ceil(cells - 1e-9)));
        for (int step = 1; step <= steps; ++step)
            part.push_back(between(from, to, static_cast<double>(step) / steps));
    }

    const BedCells& bed_;
};

/// A ring's part over the bed; along the bed's edges where it leaves it (Sutherland & Hodgman
/// 1974).
Line clipped_ring(Line ring) {
    std::erase_if(ring, [](const BedPlace& place) { return !is_somewhere(place); });
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (const double edge : {0.0, 1.0}) {
            const auto inside = [&](const BedPlace& place) {
                return edge == 0.0 ? place[axis] >= 0.0 : place[axis] <= 1.0;
            };
            Line kept;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const BedPlace& a = ring[i];
                const BedPlace& b = ring[(i + 1) % ring.size()];
                if (inside(a)) kept.push_back(a);
                if (inside(a) != inside(b))
                    kept.push_back(between(a, b, (edge - a[axis]) / (b[axis] - a[axis])));
            }
            ring = std::move(kept);
        }
    }
    return ring;
}

/// Twice the area that a ring goes round.
double area_of(const Line& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const BedPlace& a = ring[i];
        const BedPlace& b = ring[(i + 1) % ring.size()];
        sum += a[0] * b[1] - b[0] * a[1];
    }
    return std::abs(sum);
}

/// In the widest part of the even-odd inside of rings along the level line through their middle.
std::optional<BedPlace> place_within(const std::vector<Line>& rings) {
    const auto largest = std::ranges::max_element(rings, {}, area_of);
    if (largest == rings.end() || largest->empty()) return std::nullopt;
    const auto [low, high] =
        std::ranges::minmax(*largest, {}, [](const BedPlace& place) { return place[1]; });
    const double level = 0.5 * (low[1] + high[1]);
    std::vector<double> crossings;
    for (const Line& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const BedPlace& a = ring[i];
            const BedPlace& b = ring[(i + 1) % ring.size()];
            if ((a[1] <= level) == (b[1] <= level)) continue;
            crossings.push_back(std::lerp(a[0], b[0], (level - a[1]) / (b[1] - a[1])));
        }
    }
    std::ranges::sort(crossings);
    std::optional<BedPlace> best;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double width = crossings[i + 1] - crossings[i];
        if (width <= widest) continue;
        widest = width;
        best = BedPlace{0.5 * (crossings[i] + crossings[i + 1]), level};
    }
    return best;
}

/// The middle of the longest line, in cells.
std::optional<BedPlace> middle_of(const std::vector<Line>& lines, const BedCells& bed) {
    const auto step = [&](const Line& line, std::size_t i) {
        return elementary::hypot((line[i][0] - line[i - 1][0]) * bed.nx,
                                 (line[i][1] - line[i - 1][1]) * bed.ny);
    };
    const auto length = [&](const Line& line) {
        double sum = 0.0;
        for (std::size_t i = 1; i < line.size(); ++i) sum += step(line, i);
        return sum;
    };
    const auto longest = std::ranges::max_element(lines, {}, length);
    if (longest == lines.end() || longest->empty()) return std::nullopt;
    double left = 0.5 * length(*longest);
    for (std::size_t i = 1; i < longest->size(); ++i) {
        const double here = step(*longest, i);
        if (here >= left && here > 0.0)
            return between((*longest)[i - 1], (*longest)[i], left / here);
        left -= here;
    }
    return longest->back();
}

LayerFeature placed_feature(const VectorFeature& feature, const std::vector<Line>& pieces,
                            const BedCells& bed) {
    LayerFeature placed;
    placed.label = feature.label;
    const LineMaker maker(bed);
    switch (feature.shape) {
        case VectorShape::points:
            placed.shape = LayerShape::points;
            for (const Line& part : pieces) {
                for (const BedPlace& place : part) {
                    if (is_somewhere(place) && is_over_bed(place)) placed.lines.push_back({place});
                }
            }
            if (!placed.lines.empty()) placed.anchor = placed.lines.front().front();
            break;
        case VectorShape::lines:
            placed.shape = LayerShape::lines;
            for (const Line& part : pieces) maker.add(part, placed.lines);
            placed.anchor = middle_of(placed.lines, bed);
            break;
        case VectorShape::areas:
            placed.shape = LayerShape::areas;
            for (Line ring : pieces) {
                if (!ring.empty() && ring.front() != ring.back()) ring.push_back(ring.front());
                maker.add(ring, placed.lines);
                if (!ring.empty()) ring.pop_back();
                Line clipped = clipped_ring(std::move(ring));
                if (clipped.size() > 2) placed.rings.push_back(std::move(clipped));
            }
            placed.anchor = place_within(placed.rings);
            break;
    }
    return placed;
}

}  // namespace

PlacedLayer placed_layer(const VectorLayer& layer, const BedCells& bed,
                         const std::array<double, 2>& cell) {
    VectorLayer brought = layer;
    const std::string to = bed.place ? system_of(*bed.place) : std::string();
    if (!to.empty() && !layer.crs.empty()) bring(brought, to);
    const GeoReference ground =
        bed.place.value_or(GeoReference{0.0, 0.0, cell[0], cell[1], false, {}});
    PlacedLayer placed;
    for (const VectorFeature& feature : brought.features) {
        std::vector<Line> pieces;
        for (const auto& part : feature.parts) {
            Line line;
            for (const VectorPoint& point : part)
                line.push_back({(point[0] - ground.west) / (ground.dx * bed.nx),
                                (point[1] - ground.south) / (ground.dy * bed.ny)});
            pieces.push_back(std::move(line));
        }
        LayerFeature one = placed_feature(feature, pieces, bed);
        if (!one.lines.empty() || !one.rings.empty()) placed.features.push_back(std::move(one));
    }
    return placed;
}

}  // namespace fumon
