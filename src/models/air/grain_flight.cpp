#include "models/air/grain_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/cancellation.h"
#include "base/elementary.h"
#include "base/error.h"
#include "base/find_named.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/air/grain_drag.h"

namespace fumon {

namespace {

constexpr double gravity = 9.8;      // m/s² (Terada 2025)
constexpr int steps_per_check = 16;  // for lanes that are done; results do not depend on it

const Grid& field_of(const SnapshotSection& section, std::string_view name) {
    if (const SnapshotField* field = find_named(section.fields, name)) return field->values;
    throw Error(fmt::format("grains cannot fly in a section without the field {}", name));
}

const std::vector<double>& curve_of(const SnapshotSection& section, std::string_view name) {
    if (const SectionCurve* curve = find_named(section.curves, name)) return curve->values;
    throw Error(fmt::format("grains cannot fly in a section without the curve {}", name));
}

std::vector<double> with_margins(const Grid& field) {
    const auto columns = static_cast<std::size_t>(field.nx());
    std::vector<double> wide;
    wide.reserve((columns + 2) * (static_cast<std::size_t>(field.ny()) + 1));
    for (int k = 0; k <= field.ny(); ++k) {
        const auto row = field.row(std::min(k, field.ny() - 1));
        wide.insert(wide.end(), row.begin(), row.end());
        wide.push_back(row[0]);
        wide.push_back(row[1 % columns]);
    }
    return wide;
}

std::vector<double> with_margins(const std::vector<double>& curve) {
    std::vector<double> wide = curve;
    wide.push_back(curve[0]);
    wide.push_back(curve[1 % curve.size()]);
    return wide;
}

std::vector<double> central_slopes(const std::vector<double>& bed, double dx) {
    const std::size_t n = bed.size();
    std::vector<double> slope(n);
    for (std::size_t i = 0; i < n; ++i)
        slope[i] = (bed[(i + 1) % n] - bed[(i + n - 1) % n]) / (2.0 * dx);
    return slope;
}

struct Direction {
    double x;
    double z;
};

/// Of the angle θ turned by the bed's slope, exactly cos and sin of θ + arctan ∂h/∂x.
Direction direction(double degrees, double slope) {
    constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;
    const double cosine = elementary::cos(degrees * radians_per_degree);
    const double sine = elementary::sin(degrees * radians_per_degree);
    const double along = std::sqrt(1.0 + slope * slope);
    return {(cosine - sine * slope) / along, (sine + cosine * slope) / along};
}

double wrapped(double x, double width) {
    const double within = x - width * std::floor(x / width);
    return within < width ? within : 0.0;
}

}  // namespace

GrainFlights::GrainFlights(const SnapshotSection& section, const FlightParameters& parameters,
                           const Air& air, WorkerPool& pool)
    : air_(air),
      beyond_stokes_(parameters.drag == GrainDrag::schiller_naumann),
      reynolds_per_speed_(parameters.grain_diameter * metres_per_millimetre / air.viscosity),
      steps_at_most_(std::ceil(longest_time / parameters.flight_time_step)),
      pool_(pool) {
    check(parameters);
    const Grid& velocity_x = field_of(section, "velocity_x");
    velocity_x_ = with_margins(velocity_x);
    velocity_z_ = with_margins(field_of(section, "velocity_z"));
    const std::vector<double>& bed = curve_of(section, "bed_height");
    bed_ = with_margins(bed);
    slope_ = with_margins(central_slopes(bed, section.dx));
    stress_ = with_margins(curve_of(section, "bed_shear_stress"));
    lane_air_.nx = velocity_x.nx();
    lane_air_.nz = velocity_x.ny();
    if (velocity_z_.size() != velocity_x_.size() || bed_.size() != stress_.size() ||
        std::ssize(bed) != lane_air_.nx) {
        throw Error("grains cannot fly in a section whose fields and curves differ in size");
    }
    lane_air_.dx = section.dx;
    lane_air_.dz = section.dz;
    lane_air_.rate = drag::stokes_rate(air.density, air.viscosity, parameters.grain_density,
                                       parameters.grain_diameter * metres_per_millimetre);
    lane_air_.reynolds_scale = reynolds_per_speed_ * reynolds_per_speed_;
    lane_air_.gravity = gravity;
    lane_air_.time_step = parameters.flight_time_step;
    lane_air_.velocity_x = velocity_x_.data();
    lane_air_.velocity_z = velocity_z_.data();
    lane_air_.bed = bed_.data();
    constexpr double largest_share = 0.5;  // of its slip that a grain may lose in one step
    if (lane_air_.rate * parameters.flight_time_step > largest_share) {
        throw KeyError("model.flight_time_step",
                       fmt::format("grains of {:g} mm lose their speed against the air in {:.3g} "
                                   "s; model.flight_time_step = {:g} s is too long for them, take "
                                   "at most {:.2g}",
                                   parameters.grain_diameter, 1.0 / lane_air_.rate,
                                   parameters.flight_time_step, largest_share / lane_air_.rate));
    }
}

GrainFlights::Start GrainFlights::start(const Launch& launch) const {
    Start start;
    start.flight.x = wrapped(launch.x, lane_air_.nx * lane_air_.dx);
    start.flight.angle = launch.angle;
    const double column = start.flight.x / lane_air_.dx;
    // x = i·dx may divide to a little below i: what is that near to a node is on it
    constexpr double near = 1e-9;
    const double nearest = std::round(column);
    const bool on_node = std::fabs(column - nearest) < near;
    const auto i = static_cast<std::size_t>(on_node ? nearest : std::floor(column));
    const double share = on_node ? 0.0 : column - static_cast<double>(i);
    const auto between = [&](const std::vector<double>& curve) {
        return curve[i] + share * (curve[i + 1] - curve[i]);
    };
    start.flight.height = between(bed_);
    start.flight.slope = between(slope_);
    const double speed = std::sqrt(std::fabs(between(stress_)) / air_.density);
    const Direction to = direction(launch.angle, start.flight.slope);
    start.speed_x = speed * to.x;
    start.speed_z = speed * to.z;
    return start;
}

void GrainFlights::advance(GrainLanes& lanes, int count, int steps) const {
    if (beyond_stokes_) {
        advance_schiller_naumann(lanes, lane_air_, count, steps);
    } else {
        advance_stokes(lanes, lane_air_, count, steps);
    }
}

bool GrainFlights::is_over(const GrainLanes& lanes, int lane) const {
    const auto n = static_cast<std::size_t>(lane);
    return lanes.flying[n] == 0.0 || lanes.steps[n] >= steps_at_most_;
}

GrainFlights::End GrainFlights::finish(const GrainLanes& lanes, int lane, Flight& flight) const {
    const auto n = static_cast<std::size_t>(lane);
    flight.length = (lanes.x[n] - flight.x) + lanes.turns[n] * (lane_air_.nx * lane_air_.dx);
    flight.time = lanes.steps[n] * lane_air_.time_step;
    flight.reynolds = std::sqrt(lanes.fastest[n]) * reynolds_per_speed_;
    if (lanes.flying[n] != 0.0) return End::still_up;
    return lanes.z[n] > (lane_air_.nz - 1) * lane_air_.dz ? End::left_through_lid : End::landed;
}

namespace {

void load(GrainLanes& lanes, int lane, const Flight& flight, double speed_x, double speed_z) {
    const auto n = static_cast<std::size_t>(lane);
    lanes.x[n] = flight.x;
    lanes.z[n] = flight.height;
    lanes.speed_x[n] = speed_x;
    lanes.speed_z[n] = speed_z;
    lanes.turns[n] = 0.0;
    lanes.steps[n] = 0.0;
    lanes.fastest[n] = speed_x * speed_x + speed_z * speed_z;  // the air at the bed is at rest
    lanes.flying[n] = 1.0;
}

void move_lane(GrainLanes& lanes, int from, int to) {
    const auto a = static_cast<std::size_t>(from);
    const auto b = static_cast<std::size_t>(to);
    for (GrainLanes::Values* values : {&lanes.x, &lanes.z, &lanes.speed_x, &lanes.speed_z,
                                       &lanes.turns, &lanes.steps, &lanes.fastest, &lanes.flying}) {
        (*values)[b] = (*values)[a];
    }
}

}  // namespace

void GrainFlights::fly_waiting(std::span<const Launch> launches, std::atomic<std::size_t>& waiting,
                               std::span<Flight> flights, std::span<End> ends) const {
    GrainLanes lanes;
    std::array<std::size_t, static_cast<std::size_t>(GrainLanes::most)> grain{};
    const auto take_next = [&](int lane) {
        const std::size_t next = waiting.fetch_add(1, std::memory_order_relaxed);
        if (next >= launches.size()) return false;
        const Start begun = start(launches[next]);
        flights[next] = begun.flight;
        load(lanes, lane, begun.flight, begun.speed_x, begun.speed_z);
        grain.at(static_cast<std::size_t>(lane)) = next;
        return true;
    };
    int count = 0;
    while (count < GrainLanes::most && take_next(count)) ++count;
    while (count > 0) {
        throw_if_cancelled();
        advance(lanes, count, steps_per_check);
        for (int lane = count - 1; lane >= 0; --lane) {
            if (!is_over(lanes, lane)) continue;
            const std::size_t done = grain.at(static_cast<std::size_t>(lane));
            ends[done] = finish(lanes, lane, flights[done]);
            if (take_next(lane)) continue;
            --count;
            move_lane(lanes, count, lane);
            grain.at(static_cast<std::size_t>(lane)) = grain.at(static_cast<std::size_t>(count));
        }
    }
}

void GrainFlights::refuse(const Flight& flight, End end) const {
    const std::string which =
        fmt::format("the grain launched at x = {:.6g} m at {:g} degrees", flight.x, flight.angle);
    if (end == End::left_through_lid) {
        throw Error(fmt::format(
            "{} leaves through the lid (z = {:.4g} m) after {:.3g} s; raise the lid, or try a "
            "smaller model.launch_angles or slower air",
            which, (lane_air_.nz - 1) * lane_air_.dz, flight.time));
    }
    throw Error(fmt::format(
        "{} is not down after {:g} s; try a larger model.grain_diameter or model.grain_density, or "
        "slower air",
        which, longest_time));
}

std::vector<Flight> GrainFlights::fly(std::span<const Launch> launches) const {
    std::vector<Flight> flights(launches.size());
    std::vector<End> ends(launches.size(), End::landed);
    std::atomic<std::size_t> waiting = 0;
    pool_.for_ranges(pool_.size(),
                     [&](int, int) { fly_waiting(launches, waiting, flights, ends); });
    for (std::size_t n = 0; n < flights.size(); ++n) {
        if (ends[n] != End::landed) refuse(flights[n], ends[n]);
    }
    return flights;
}

std::vector<Launch> GrainFlights::every_column(std::span<const double> angles) const {
    std::vector<Launch> launches;
    launches.reserve(angles.size() * static_cast<std::size_t>(lane_air_.nx));
    for (const double angle : angles) {
        for (int i = 0; i < lane_air_.nx; ++i) launches.push_back({i * lane_air_.dx, angle});
    }
    return launches;
}

std::vector<Flight> GrainFlights::in_succession(std::span<const Launch> launches, int hops) const {
    std::vector<Flight> total = fly(launches);
    std::vector<Launch> next(launches.begin(), launches.end());
    for (int hop = 1; hop < hops; ++hop) {
        for (std::size_t n = 0; n < next.size(); ++n) next[n].x = total[n].x + total[n].length;
        const std::vector<Flight> more = fly(next);
        for (std::size_t n = 0; n < next.size(); ++n) {
            total[n].length += more[n].length;
            total[n].time += more[n].time;
            total[n].reynolds = std::max(total[n].reynolds, more[n].reynolds);
        }
    }
    return total;
}

GrainPath GrainFlights::path(const Launch& launch) const {
    Start begun = start(launch);
    GrainLanes lanes;
    load(lanes, 0, begun.flight, begun.speed_x, begun.speed_z);
    GrainPath path{launch.angle, {begun.flight.x}, {begun.flight.height}};
    const double width = lane_air_.nx * lane_air_.dx;
    while (!is_over(lanes, 0)) {
        throw_if_cancelled();
        advance(lanes, 1, 1);
        path.x.push_back(lanes.x[0] + lanes.turns[0] * width);
        path.z.push_back(lanes.z[0]);
    }
    const End end = finish(lanes, 0, begun.flight);
    if (end != End::landed) refuse(begun.flight, end);
    return path;
}

}  // namespace fumon
