// What thin cells at a falling shore have still to deliver after a step.
//
// A cell that the shore leaves runs dry within the first of a step's stages, which cuts the fluxes
// to the water that is there; the mean of the stages would keep a part of it (Heun's half), and a
// part of that after the next step: a film that stays behind the shore, comes down the slope later
// and sends waves. What the fluxes ask for beyond the cell's water is its deficit, with the stage's
// weight in the mean. After the step that is delivered from what the cell has kept, through the
// same faces and with the cell's own velocity. Water and momentum are conserved.

#include <algorithm>
#include <tuple>
#include <utility>

#include "models/water/shore_planes.h"

namespace fumon {

namespace {

/// West and east, south and north: the same for mirror images.
double sum_of_pairs(const std::array<double, 4>& sides) {
    return (sides[0] + sides[1]) + (sides[2] + sides[3]);
}

/// To a cell, from its neighbour on that side.
struct Delivery {
    int y = 0;
    int x = 0;
    std::size_t side = 0;
    double depth = 0.0;
    double u = 0.0;
    double v = 0.0;
};

/// Adds water and momentum to the cells that are delivered.
void take(std::vector<Delivery> deliveries, Water& water, double dry_depth) {
    std::ranges::sort(deliveries, [](const Delivery& a, const Delivery& b) {
        return std::tie(a.y, a.x, a.side) < std::tie(b.y, b.x, b.side);
    });
    for (std::size_t k = 0; k < deliveries.size();) {
        const int x = deliveries[k].x;
        const int y = deliveries[k].y;
        std::array<double, 4> depths{};
        std::array<double, 4> along_x{};
        std::array<double, 4> along_y{};
        for (; k < deliveries.size() && deliveries[k].x == x && deliveries[k].y == y; ++k) {
            const Delivery& one = deliveries[k];
            depths[one.side] = one.depth;
            along_x[one.side] = one.depth * one.u;
            along_y[one.side] = one.depth * one.v;
        }
        const double before = water.depth(x, y);
        const double depth = before + sum_of_pairs(depths);
        const auto mix = [&](double& velocity, const std::array<double, 4>& delivered) {
            velocity =
                depth > dry_depth ? (before * velocity + sum_of_pairs(delivered)) / depth : 0.0;
        };
        mix(water.velocity_x(x, y), along_x);
        mix(water.velocity_y(x, y), along_y);
        water.depth(x, y) = depth;
    }
}

}  // namespace

/// From what passes the faces of row y in a stage.
void ShorePlanes::add_deficits(int y, const StageOfStep& stage) {
    Row& row = rows_[slot(y)];
    const double per_x = stage.dt / domain_.dx;
    const double per_y = stage.dt / domain_.dy;
    const int south_y = y == 0 && domain_.edges_y == EdgeKind::periodic ? ny_ - 1 : y - 1;
    const std::vector<Face>& south = rows_[slot(south_y)].north;
    const auto through = [](const std::vector<Face>& faces, int x) {
        const auto face = std::ranges::lower_bound(faces, x, {}, &Face::x);
        return face == faces.end() || face->x != x ? 0.0 : face->mass;
    };
    for (const Plane& plane : row.outer) {
        const int x = plane.x;
        const int west = x == 0 && domain_.edges_x == EdgeKind::periodic ? nx_ - 1 : x - 1;
        Deficit deficit{x,
                        {per_x * std::max(0.0 - through(row.east, west), 0.0),
                         per_x * std::max(through(row.east, x), 0.0),
                         per_y * std::max(0.0 - through(south, x), 0.0),
                         per_y * std::max(through(row.north, x), 0.0)}};
        const double asked = sum_of_pairs(deficit.to);
        const double there = water_->depth(x, y);
        if (!(asked > there)) continue;
        for (double& to : deficit.to) to *= stage.weight * (1.0 - there / asked);
        row.deficits.push_back(deficit);
    }
}

/// Of all stages, one of each cell.
void ShorePlanes::merge_deficits(std::vector<Deficit>& deficits) {
    std::ranges::stable_sort(deficits, {}, &Deficit::x);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < deficits.size(); ++k) {
        if (kept > 0 && deficits[kept - 1].x == deficits[k].x) {
            for (std::size_t side = 0; side < 4; ++side)
                deficits[kept - 1].to[side] += deficits[k].to[side];
        } else {
            deficits[kept++] = deficits[k];
        }
    }
    deficits.resize(kept);
}

void ShorePlanes::deliver_deficits(Water& water, double dt, const DeliveryNotes& notes,
                                   std::vector<int>& changed_rows) {
    std::vector<Delivery> deliveries;
    for (int y = 0; y < ny_; ++y) {
        std::vector<Deficit>& deficits = rows_[slot(y)].deficits;
        if (deficits.empty()) continue;
        changed_rows.push_back(y);
        merge_deficits(deficits);
        for (const Deficit& deficit : deficits) {
            const int x = deficit.x;
            double& depth = water.depth(x, y);
            const double lacking = sum_of_pairs(deficit.to);
            if (!(depth > 0.0) || !(lacking > 0.0)) continue;
            const double share = std::min(depth / lacking, 1.0);
            const auto deliver = [&](std::size_t side, int dx, int dy) {
                const double part = share * deficit.to[side];
                if (!(part > 0.0)) return;
                const CellReference to = at(x + dx, y + dy);
                deliveries.push_back(
                    {to.y, to.x, side ^ 1U, part, water.velocity_x(x, y), water.velocity_y(x, y)});
                if (notes.faces != nullptr)
                    notes.faces->add(x, y, static_cast<GridSide>(side), to.x, to.y,
                                     part * (domain_.dx * domain_.dy));
                if (notes.flow == nullptr) return;
                const double passed = 2.0 * part / dt;  // a stage counts for half in the mean
                if (dx != 0) notes.flow->east(x + (dx + 1) / 2, y) += dx * (passed * domain_.dx);
                if (dy != 0) notes.flow->north(x, y + (dy + 1) / 2) += dy * (passed * domain_.dy);
            };
            deliver(0, -1, 0);
            deliver(1, 1, 0);
            deliver(2, 0, -1);
            deliver(3, 0, 1);
            depth = share < 1.0 ? 0.0 : std::max(depth - lacking, 0.0);
            if (depth > dry_depth) continue;
            water.velocity_x(x, y) = 0.0;
            water.velocity_y(x, y) = 0.0;
        }
        deficits.clear();
    }
    for (const Delivery& one : deliveries) changed_rows.push_back(one.y);
    std::ranges::sort(changed_rows);
    changed_rows.erase(std::unique(changed_rows.begin(), changed_rows.end()), changed_rows.end());
    take(std::move(deliveries), water, dry_depth);
}

}  // namespace fumon
