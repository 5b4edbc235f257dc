#include "models/grain_lanes.h"

#include "models/grain_drag.h"
#include "support/multiversion.h"

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
        const double here_x = at_x[lane];
        const double here_z = at_z[lane];
        const double vx = speed_x[lane];
        const double vz = speed_z[lane];
        double x = here_x + dt * vx;
        const double z = here_z + dt * vz;
        const double turned = x >= width ? 1.0 : (x < 0.0 ? -1.0 : 0.0);
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
        const double next_x = vx - dt * (drag * slip_x);
        const double next_z = vz - dt * (gravity + drag * slip_z);

        double goes_on = z <= ground ? 0.0 : moves;
        goes_on = z > lid ? 0.0 : goes_on;
        const double largest = fastest[lane] > slip ? fastest[lane] : slip;
        at_x[lane] = moves != 0.0 ? x : here_x;
        at_z[lane] = moves != 0.0 ? z : here_z;
        turns[lane] += moves * turned;
        done[lane] += moves;
        speed_x[lane] = goes_on != 0.0 ? next_x : vx;
        speed_z[lane] = goes_on != 0.0 ? next_z : vz;
        fastest[lane] = goes_on != 0.0 ? largest : fastest[lane];
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
