#include "models/water/water_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/multiversion.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

/// 0, or not a number where one of the row's values is not finite; below 0 where a depth is.
FUMON_MULTIVERSION
double fault_of_row(const double* h, const double* u, const double* v, const double* z, int count) {
    double fault[8] = {};
    const auto one = [&](int x) {
        const double shallow = h[x] < 0.0 ? -1.0 : 0.0;
        return shallow + ((h[x] - h[x]) + (u[x] - u[x])) + ((v[x] - v[x]) + (z[x] - z[x]));
    };
    int x = 0;
    for (; x + 8 <= count; x += 8) {
        for (int k = 0; k < 8; ++k) fault[k] += one(x + k);
    }
    for (; x < count; ++x) fault[0] += one(x);
    return ((fault[0] + fault[1]) + (fault[2] + fault[3])) +
           ((fault[4] + fault[5]) + (fault[6] + fault[7]));
}

[[noreturn]] void report(const Water& water, const Grid& bed, int y, double time) {
    const auto fail = [&](const char* quantity, double value, const char* unit, int x) {
        throw Error(
            fmt::format("{} became {:.4g} {} at cell ({}, {}), t = {:.6g} s; try a smaller "
                        "model.courant_number or model.time_step, more model.bed_diffusion or "
                        "model.scheme = \"cip\"",
                        quantity, value, unit, x, y, time));
    };
    for (int x = 0; x < bed.nx(); ++x) {
        const double depth = water.depth(x, y);
        if (!(depth >= 0.0) || std::isinf(depth)) fail("the water depth", depth, "m", x);
        const double u = water.velocity_x(x, y);
        if (!std::isfinite(u)) fail("the eastward velocity", u, "m/s", x);
        const double v = water.velocity_y(x, y);
        if (!std::isfinite(v)) fail("the northward velocity", v, "m/s", x);
        if (!std::isfinite(bed(x, y))) fail("the bed height", bed(x, y), "m", x);
    }
    throw Error(fmt::format("the water in row {} is not what it was, t = {:.6g} s", y, time));
}

}  // namespace

void check_water(const Water& water, const Grid& bed, double time, WorkerPool& pool) {
    std::vector<char> faulty(static_cast<std::size_t>(bed.ny()));
    pool.for_ranges(bed.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const double fault =
                fault_of_row(water.depth.row(y).data(), water.velocity_x.row(y).data(),
                             water.velocity_y.row(y).data(), bed.row(y).data(), bed.nx());
            faulty[static_cast<std::size_t>(y)] = fault == 0.0 ? 0 : 1;
        }
    });
    const auto first = std::find(faulty.begin(), faulty.end(), 1);
    if (first != faulty.end()) report(water, bed, static_cast<int>(first - faulty.begin()), time);
}

void refuse_speed(const Water& water, double time, const std::string& reason) {
    const auto speed = [&](int x, int y) {
        const double u = water.velocity_x(x, y);
        const double v = water.velocity_y(x, y);
        return std::sqrt(u * u + v * v);
    };
    int fastest_x = 0;
    int fastest_y = 0;
    for (int y = 0; y < water.depth.ny(); ++y) {
        for (int x = 0; x < water.depth.nx(); ++x) {
            if (!(speed(x, y) > speed(fastest_x, fastest_y))) continue;
            fastest_x = x;
            fastest_y = y;
        }
    }
    throw Error(
        fmt::format("the speed became {:.4g} m/s at cell ({}, {}), t = {:.6g} s, so that {}; try a "
                    "smaller model.time_step, more model.friction_coefficient or "
                    "model.bed_diffusion",
                    speed(fastest_x, fastest_y), fastest_x, fastest_y, time, reason));
}

}  // namespace fumon
