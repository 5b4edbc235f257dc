// What passes the faces that gauges watch, by CIP.

#include "models/water/cip_scheme.h"

namespace fumon {

void CipScheme::count_watched(const Block& block, int y, cip::Strip& strip) const {
    for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
        const int k = face.x - block.first_x;
        if (k < 0 || k >= block.count) continue;
        const auto outward = [&]() {
            switch (face.side) {
                case GridSide::west:
                    return 0.0 - strip.row(cip::Strip::faces_east, y)[k - 1];
                case GridSide::east:
                    return strip.row(cip::Strip::faces_east, y)[k];
                case GridSide::south:
                    return 0.0 - strip.row(cip::Strip::faces_north, y - 1)[k];
                case GridSide::north:
                    break;
            }
            return strip.row(cip::Strip::faces_north, y)[k];
        };
        face.volume = outward() * (domain_.dx * domain_.dy);
    }
}

/// Instead of what would have passed if there had been enough.
void CipScheme::count_shared(const PassedDepth& passed) const {
    for (int y = 0; y < ny_; ++y) {
        for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
            const auto outward = [&]() {
                switch (face.side) {
                    case GridSide::west:
                        return 0.0 - passed.east(face.x, y);
                    case GridSide::east:
                        return passed.east(face.x + 1, y);
                    case GridSide::south:
                        return 0.0 - passed.north(face.x, wrapped(y - 1));
                    case GridSide::north:
                        break;
                }
                return passed.north(face.x, y);
            };
            face.volume = outward() * (domain_.dx * domain_.dy);
        }
    }
}

void CipScheme::count_as_published(const Water& water, double dt) const {
    for (int y = 0; y < ny_; ++y) {
        for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
            const bool is_x = face.side == GridSide::west || face.side == GridSide::east;
            const int toward = face.side == GridSide::west || face.side == GridSide::south ? -1 : 1;
            const int beside_x = is_x ? (face.x + toward + nx_) % nx_ : face.x;
            const int beside_y = is_x ? y : wrapped(y + toward);
            const Grid& velocity = is_x ? water.velocity_x : water.velocity_y;
            const double mean =
                0.5 * (water.depth(face.x, y) * velocity(face.x, y) +
                       water.depth(beside_x, beside_y) * velocity(beside_x, beside_y));
            face.volume = toward * mean * dt * (is_x ? domain_.dy : domain_.dx);
        }
    }
}

}  // namespace fumon
