// What finite volumes do at the edges of the grid.

#include <algorithm>

#include "models/water/finite_volume_scheme.h"

namespace fumon {

using finite_volume::Side;

void FiniteVolumeScheme::find_outlets() {
    outlets_.assign(static_cast<std::size_t>(ny_), {});
    const auto is_outside = [&](int x, int y) {
        const CellSource column = source_of(x, nx_, domain_.edges_x);
        const CellSource row = source_of(y, ny_, domain_.edges_y);
        return column.outside || row.outside ||
               (!domain_.nodata.empty() && domain_.nodata(column.index, row.index) != 0);
    };
    for (int y = 0; y < ny_; ++y) {
        auto& outlets = outlets_[static_cast<std::size_t>(y)];
        for (int x = 0; x < nx_; ++x) {
            if (is_outside(x, y)) continue;
            const auto look = [&](Side side, int cell, bool at_edge, int to_x, int to_y) {
                if (at_edge && edges_->flows(side, cell)) {
                    outlets.push_back({x, side, true});
                } else if (at_edge && edges_->has_segments(side)) {
                    if (edges_->kind(side, cell) == EdgeKind::open)
                        outlets.push_back({x, side, false});
                } else if (is_outside(to_x, to_y)) {
                    outlets.push_back({x, side});
                }
            };
            look(Side::west, y, x == 0, x - 1, y);
            look(Side::east, y, x == nx_ - 1, x + 1, y);
            look(Side::south, x, y == 0, x, y - 1);
            look(Side::north, x, y == ny_ - 1, x, y + 1);
        }
    }
}

void FiniteVolumeScheme::count_watched(const Stage& stage, const finite_volume::Strip& strip,
                                       int y) const {
    const int first = strip.first_x();
    for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
        if (face.x < first || face.x >= first + strip.count()) continue;
        const bool along_y = face.side == Side::west || face.side == Side::east;
        const double width = along_y ? domain_.dy : domain_.dx;
        face.volume += stage.weight * stage.dt * (strip.outward(face.x, y, face.side) * width);
    }
}

/// A row beyond an edge with stretches.
void FiniteVolumeScheme::load_ghost_row(const Stage& stage, finite_volume::Strip& strip,
                                        int y) const {
    const Side side = y < 0 ? Side::south : Side::north;
    const int beyond = y < 0 ? -y : y - ny_ + 1;
    const int edge = y < 0 ? 0 : ny_ - 1;
    const int inner = y < 0 ? std::min(1, ny_ - 1) : std::max(ny_ - 2, 0);
    for (int k = 0; k < strip.padded(); ++k) {
        const CellSource column =
            source_of(strip.first_x() + k - finite_volume::Strip::margin, nx_, domain_.edges_x);
        const int x = column.index;
        if (column.outside || !edges_->flows(side, x)) {
            const CellSource row = source_of(y, ny_, edges_->kind(side, x));
            const bool outside = column.outside || row.outside ||
                                 (!domain_.nodata.empty() && domain_.nodata(x, row.index) != 0);
            const double inside = outside ? 0.0 : 1.0;
            const double depth = inside * stage.from.depth(x, row.index);
            strip.depth(y)[k] = depth;
            strip.surface(y)[k] = outside ? 0.0 : depth + stage.bed(x, row.index);
            strip.velocity_x(y)[k] = outside ? 0.0 : stage.from.velocity_x(x, row.index);
            strip.velocity_y(y)[k] =
                outside ? 0.0 : (row.mirrored ? -1.0 : 1.0) * stage.from.velocity_y(x, row.index);
            strip.inside(y)[k] = inside;
            continue;
        }
        load_ghost_cells(stage, strip, k, y, {x, edge}, {x, inner}, beyond);
    }
}

/// A cell beyond the edge, on the line through the last two before it.
void FiniteVolumeScheme::load_ghost_cells(const Stage& stage, finite_volume::Strip& strip, int k,
                                          int y, CellIndex edge, CellIndex inner,
                                          int beyond) const {
    const auto has_data = [&](CellIndex at) {
        return domain_.nodata.empty() || domain_.nodata(at.x, at.y) == 0;
    };
    if (!has_data(edge)) {
        strip.depth(y)[k] = strip.surface(y)[k] = strip.velocity_x(y)[k] = 0.0;
        strip.velocity_y(y)[k] = strip.inside(y)[k] = 0.0;
        return;
    }
    if (!has_data(inner)) inner = edge;
    const auto value = [&](const Grid& grid) {
        const double here = grid(edge.x, edge.y);
        return here + beyond * (here - grid(inner.x, inner.y));
    };
    const double depth = std::max(value(stage.from.depth), 0.0);
    strip.depth(y)[k] = depth;
    strip.surface(y)[k] = depth + value(stage.bed);
    strip.velocity_x(y)[k] = value(stage.from.velocity_x);
    strip.velocity_y(y)[k] = value(stage.from.velocity_y);
    strip.inside(y)[k] = 1.0;
}

/// Puts what flows over the west and east edges through the faces there.
void FiniteVolumeScheme::compute_edge_x(finite_volume::Strip& strip, int y) const {
    const CellSource row = source_of(y, ny_, domain_.edges_y);
    const bool periodic = domain_.edges_y == EdgeKind::periodic;
    if (!periodic && (y < 0 || y >= ny_)) return;
    for (const Side side : {Side::west, Side::east}) {
        const int x = side == Side::west ? 0 : nx_ - 1;
        const int k = x - strip.first_x() + finite_volume::Strip::margin;
        if (k < 2 || k > strip.padded() - 3 || !edges_->flows(side, row.index)) continue;
        set_edge_flux(strip, k, y, side, row.index);
    }
}

/// The same for the south and north edges.
void FiniteVolumeScheme::compute_edge_y(finite_volume::Strip& strip, int y) const {
    for (const Side side : {Side::south, Side::north}) {
        const int row = side == Side::south ? 0 : ny_ - 1;
        if (y != (side == Side::south ? -1 : ny_ - 1) || !edges_->has_segments(side)) continue;
        for (int k = 2; k < strip.padded() - 2; ++k) {
            const int x = strip.first_x() + k - finite_volume::Strip::margin;
            const bool is_beyond = x < 0 || x >= nx_;
            if (is_beyond && domain_.edges_x != EdgeKind::periodic) continue;
            const int cell = source_of(x, nx_, EdgeKind::periodic).index;
            if (edges_->flows(side, cell)) set_edge_flux(strip, k, row, side, cell);
        }
    }
}

void FiniteVolumeScheme::set_edge_flux(finite_volume::Strip& strip, int k, int y, Side side,
                                       int cell) const {
    if (strip.inside(y)[k] == 0.0) return;
    const EdgeWater inside = strip.at_face(k, y, side);
    strip.set_flux(k, y, side, edges_->flux(side, cell, inside, gravity_), inside.depth, gravity_);
}

/// Cells beside edges over which water may come in.
void FiniteVolumeScheme::keep_inlets_wet() {
    for (const EdgeSegment& segment : domain_.segments) {
        if (segment.kind != EdgeFlow::discharge && segment.kind != EdgeFlow::level) continue;
        for (int k = segment.first; k <= segment.last; ++k) {
            const bool across_x = segment.side == Side::west || segment.side == Side::east;
            const int edge = segment.side == Side::west || segment.side == Side::south ? 0
                             : across_x                                                ? nx_ - 1
                                                                                       : ny_ - 1;
            tiles_->keep_wet(across_x ? edge : k, across_x ? k : edge);
        }
    }
}

}  // namespace fumon
