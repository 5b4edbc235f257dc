#include "models/air/grain_lanes.h"

#include "base/multiversion.h"
#include "models/air/grain_drag.h"

namespace fumon {

namespace {

/// Within [0, high]; 0 for what is not a number.
inline double within(double value, double high) {
    const double positive = value > 0.0 ? value : 0.0;
    return positive < high ? positive : high;
}

inline double mixed(double a, double b, double share) {
    return a + share * (b - a);
}

template <bool beyond_stokes>
[[gnu::always_inline]] inline void advance_once(GrainLanes& lanes, const LaneAir& air,
                                                const double* __restrict velocity_x,
                                                const double* __restrict velocity_z,
                                                const double* __restrict bed, int count) {
    const double width = air.nx * air.dx;
    const double lid = (air.nz - 1) * air.dz;
    const double per_dx = 1.0 / air.dx;
    const double per_dz = 1.0 / air.dz;
    const double last_column = air.nx;
    const double last_row = air.nz - 1;
    const int stride = air.nx + 2;
    const double rate = air.rate;
    const double scale = air.reynolds_scale;
    const double gravity = air.gravity;
    const double dt = air.time_step;
    double* __restrict at_x = lanes.x.data();
    double* __restrict at_z = lanes.z.data();
    double* __restrict speed_x = lanes.speed_x.data();
    double* __restrict speed_z = lanes.speed_z.data();
    double* __restrict turns = lanes.turns.data();
    double* __restrict done = lanes.steps.data();
    double* __restrict fastest = lanes.fastest.data();
    double* __restrict flying = lanes.flying.data();
    for (int lane = 0; lane < count; ++lane) {
        const double moves = flying[lane];
        const double vx = speed_x[lane];
        const double vz = speed_z[lane];
        double x = at_x[lane] + moves * (dt * vx);
        const double z = at_z[lane] + moves * (dt * vz);
        const double turned_east = x >= width ? 1.0 : 0.0;
        const double turned_west = x < 0.0 ? 1.0 : 0.0;
        const double turned = turned_east - turned_west;
        x = x - turned * width;

        const double column = within(x * per_dx, last_column);
        const int i = static_cast<int>(column);
        const double east = column - i;
        const double ground = mixed(bed[i], bed[i + 1], east);
        const double row = within(z * per_dz, last_row);
        const int k = static_cast<int>(row);
        const double up = row - k;
        const int node = k * stride + i;
        const double u =
            mixed(mixed(velocity_x[node], velocity_x[node + 1], east),
                  mixed(velocity_x[node + stride], velocity_x[node + stride + 1], east), up);
        const double w =
            mixed(mixed(velocity_z[node], velocity_z[node + 1], east),
                  mixed(velocity_z[node + stride], velocity_z[node + stride + 1], east), up);

        const double slip_x = vx - u;
        const double slip_z = vz - w;
        const double slip = slip_x * slip_x + slip_z * slip_z;
        double drag = rate;
        if constexpr (beyond_stokes) drag *= drag::schiller_naumann_factor(scale * slip);

        const double above_bed = z <= ground ? 0.0 : 1.0;
        const double below_lid = z > lid ? 0.0 : 1.0;
        const double goes_on = moves * (above_bed * below_lid);
        const double counted = goes_on * slip;
        const double fastest_before = fastest[lane];
        at_x[lane] = x;
        at_z[lane] = z;
        turns[lane] += turned;
        done[lane] += moves;
        speed_x[lane] = vx - goes_on * (dt * (drag * slip_x));
        speed_z[lane] = vz - goes_on * (dt * (gravity + drag * slip_z));
        fastest[lane] = fastest_before > counted ? fastest_before : counted;
        flying[lane] = goes_on;
    }
}

}  // namespace

FUMON_MULTIVERSION void advance_stokes(GrainLanes& lanes, const LaneAir& air, int count,
                                       int steps) {
    for (int step = 0; step < steps; ++step) {
        advance_once<false>(lanes, air, air.velocity_x, air.velocity_z, air.bed, count);
    }
}

FUMON_MULTIVERSION void advance_schiller_naumann(GrainLanes& lanes, const LaneAir& air, int count,
                                                 int steps) {
    for (int step = 0; step < steps; ++step) {
        advance_once<true>(lanes, air, air.velocity_x, air.velocity_z, air.bed, count);
    }
}

}  // namespace fumon
