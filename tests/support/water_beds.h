#pragma once

#include <utility>

#include "support/view_beds.h"

namespace fumon {

inline void add_field(Snapshot& snapshot, const char* name, Grid values) {
    snapshot.fields.push_back({name, "", "", std::move(values)});
}

/// Water of one depth (m) and speed (m/s, northward) over a bed in metres.
inline Snapshot under_water(Snapshot snapshot, double depth, double speed) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    snapshot.scale = {1.0, 1.0, 1.0, true};
    add_field(snapshot, "water_depth", Grid(nx, ny, depth));
    add_field(snapshot, "velocity_x", Grid(nx, ny));
    add_field(snapshot, "velocity_y", Grid(nx, ny, speed));
    return snapshot;
}

/// A flat bed of nx × ny metres.
inline Snapshot flat_bed(int nx, int ny) {
    Snapshot snapshot;
    snapshot.bed = Grid(nx, ny, 1.0);
    snapshot.scale = {1.0, 1.0, 1.0, true};
    return snapshot;
}

}  // namespace fumon
