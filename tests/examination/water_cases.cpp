#include "examination/water_cases.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "base/compensated_sum.h"
#include "base/worker_pool.h"
#include "examination/first_order.h"
#include "models/water/finite_volume_scheme.h"
#include "models/water/water_setup.h"

namespace fumon::examination {

namespace {

using exact::Flow;

Grid bed_along_x(int cells, int rows, const std::function<double(int)>& height) {
    Grid bed(cells, rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < cells; ++x) bed(x, y) = height(x);
    }
    return bed;
}

GullyParameters frictionless() {
    WaterParameters parameters;
    parameters.gravity = exact::gravity;
    parameters.friction_coefficient = 0.0;
    parameters.edges_x = EdgeKind::wall;
    parameters.edges_y = EdgeKind::periodic;
    return parameters;
}

/// Of flows that become steady: the limiter would keep ripples standing in them.
constexpr double calm_tolerance = 0.01;
/// By steeper slopes a jump that stands still keeps sending waves.
constexpr double steepness_at_jumps = 1.3;

/// A discharge is in m²/s here; setting_of() multiplies it by the width.
EdgeSettings edge(GridSide side, EdgeFlow kind, double value = 0.0, double depth = 0.0) {
    EdgeSettings edge;
    edge.side = side;
    edge.kind = kind;
    edge.value = value;
    edge.depth = depth;
    return edge;
}

Case bump_case(const char* name, const char* title, double duration) {
    Case one;
    one.name = name;
    one.title = title;
    one.length = 25.0;
    one.duration = duration;
    one.parameters = frictionless();
    one.bed = [](int cells, int rows) {
        return bed_along_x(cells, rows,
                           [&](int x) { return exact::bump((x + 0.5) * 25.0 / cells); });
    };
    one.kinks = {8.0, 12.0};
    return one;
}

Case lake(const char* name, const char* title, double level) {
    Case one = bump_case(name, title, 100.0);
    one.level = level;
    one.start = [level](double, double, double bed) {
        return Flow{std::max(level - bed, 0.0), 0.0, 0.0};
    };
    one.exact = [level](double x, double, double) {
        return Flow{std::max(level - exact::bump(x), 0.0), 0.0, 0.0};
    };
    return one;
}

Case flow_over_bump(const char* name, const char* title, double q, double out,
                    const std::function<Flow(double)>& steady) {
    Case one = bump_case(name, title, 300.0);
    one.level = out;
    one.parameters.limiter_tolerance = calm_tolerance;
    one.parameters.edges = {edge(GridSide::west, EdgeFlow::discharge, q),
                            edge(GridSide::east, EdgeFlow::level, out)};
    one.start = [out](double, double, double bed) {
        return Flow{std::max(out - bed, 0.0), 0.0, 0.0};
    };
    one.exact = [steady](double x, double, double) { return steady(x); };
    return one;
}

void add_bumps(std::vector<Case>& cases) {
    cases.push_back(lake("lake-immersed-bump", "lake at rest, immersed bump", 0.5));
    cases.push_back(lake("lake-emerged-bump", "lake at rest, emerged bump", 0.1));
    cases.push_back(flow_over_bump("bump-subcritical", "bump, subcritical", 4.42, 2.0,
                                   [](double x) { return exact::bump_subcritical(x, 4.42, 2.0); }));
    cases.back().smooth = true;
    cases.push_back(flow_over_bump("bump-transcritical", "bump, transcritical", 1.53, 0.66,
                                   [](double x) { return exact::bump_transcritical(x, 1.53); }));
    cases.back().kinks.push_back(10.0);
    cases.back().smooth = true;
    cases.back().parameters.limiter_tolerance = 0.001;  // below the bed's steps at its kinks
    cases.push_back(flow_over_bump("bump-jump", "bump, transcritical with a jump", 0.18, 0.33,
                                   [](double x) { return exact::bump_with_jump(x, 0.18, 0.33); }));
    cases.back().kinks.push_back(10.0);
    cases.back().kinks.push_back(exact::bump_jump(0.18, 0.33));
    cases.back().parameters.limiter_tolerance = 0.0;  // waves behind its jump never end
    cases.back().parameters.limiter_steepness = steepness_at_jumps;
}

Case channel_case(const char* name, const char* title, const exact::Channel& channel) {
    Case one;
    one.name = name;
    one.title = title;
    one.length = channel.length;
    one.duration = 3000.0;
    one.parameters = frictionless();
    one.parameters.limiter_tolerance = calm_tolerance;
    one.parameters.friction = FrictionLaw::manning;
    one.parameters.manning = channel.manning;
    if (channel.rain > 0.0) one.parameters.rain = channel.rain * 3.6e6;
    one.bed = [channel](int cells, int rows) {
        const std::vector<double> heights = channel.bed(cells);
        return bed_along_x(cells, rows,
                           [&](int x) { return heights[static_cast<std::size_t>(x)]; });
    };
    const double in = channel.depth(0.0);
    const double out = channel.depth(channel.length);
    const auto is_fast = [&](double x) {
        const double h = channel.depth(x);
        return channel.discharge(x) > h * std::sqrt(exact::gravity * h);
    };
    one.parameters.edges = {
        edge(GridSide::west, EdgeFlow::discharge, channel.inflow, is_fast(0.0) ? in : 0.0),
        is_fast(channel.length) ? edge(GridSide::east, EdgeFlow::open)
                                : edge(GridSide::east, EdgeFlow::level, out)};
    one.level = out;
    one.start = [out](double, double, double bed) {
        return Flow{std::max(out - bed, 0.0), 0.0, 0.0};
    };
    one.exact = [channel](double x, double, double) {
        const double h = channel.depth(x);
        return Flow{h, channel.discharge(x) / h, 0.0};
    };
    if (channel.jump > 0.0) {
        one.kinks = {channel.jump};
    } else {
        one.smooth = true;
    }
    return one;
}

void add_channels(std::vector<Case>& cases) {
    cases.push_back(channel_case("channel-subcritical", "channel, subcritical",
                                 exact::subcritical_channel(2.0, 0.0)));
    cases.push_back(channel_case("channel-supercritical", "channel, supercritical",
                                 exact::supercritical_channel(0.0)));
    cases.push_back(channel_case("channel-transcritical", "channel, sub- to supercritical",
                                 exact::channel_to_supercritical()));
    cases.back().kinks = {500.0};
    cases.push_back(channel_case("channel-jump", "channel, super- to subcritical, with a jump",
                                 exact::channel_with_jump()));
    cases.push_back(channel_case("channel-rain-subcritical", "channel in rain, subcritical",
                                 exact::subcritical_channel(1.0, 0.001)));
    cases.push_back(channel_case("channel-rain-supercritical", "channel in rain, supercritical",
                                 exact::supercritical_channel(0.001)));
}

Case dam(const char* name, const char* title, double length, double left, double right,
         double duration) {
    Case one;
    one.name = name;
    one.title = title;
    one.length = length;
    one.west = -0.5 * length;
    one.duration = duration;
    one.behind = left;
    one.before = right;
    one.parameters = frictionless();
    one.bed = [](int cells, int rows) { return Grid(cells, rows); };
    one.start = [left, right](double x, double, double) {
        return Flow{x < 0.0 ? left : right, 0.0, 0.0};
    };
    one.exact = [left, right](double x, double, double t) {
        return exact::dam_break(left, right, x, t);
    };
    return one;
}

void add_dams(std::vector<Case>& cases) {
    cases.push_back(dam("dam-wet", "breaking dam, wet bed (Stoker)", 10.0, 0.005, 0.001, 6.0));
    cases.push_back(dam("dam-dry", "breaking dam, dry bed (Ritter)", 10.0, 0.005, 0.0, 6.0));
    cases.push_back(dam("dam-friction",
                        "breaking dam, dry bed, friction (Dressler), before its tip", 2000.0, 6.0,
                        0.0, 40.0));
    Case& one = cases.back();
    one.parameters.friction = FrictionLaw::chezy;
    one.parameters.chezy = 40.0;
    one.exact = [](double x, double, double t) { return exact::dressler(6.0, 40.0, x, t); };
    one.until = exact::dressler_tip(6.0, 40.0, 40.0);
}

Case basin(const char* name, const char* title, bool square, double h0, double duration,
           const std::function<Flow(double, double, double)>& flow) {
    Case one;
    one.name = name;
    one.title = title;
    one.length = 4.0;
    one.square = square;
    one.west = -2.0;
    one.duration = duration;
    one.parameters = frictionless();
    if (square) one.parameters.edges_y = EdgeKind::wall;
    one.bed = [square, h0](int cells, int rows) {
        Grid bed(cells, rows);
        const auto middle = [&](int k) { return (k + 0.5) * 4.0 / cells - 2.0; };
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < cells; ++x) {
                const double r2 = middle(x) * middle(x) + (square ? middle(y) * middle(y) : 0.0);
                bed(x, y) = h0 * (r2 - 1.0);
            }
        }
        return bed;
    };
    one.exact = flow;
    one.start = [flow](double x, double y, double) { return flow(x, y, 0.0); };
    one.parameters.shore_cells = ShoreCells::planes;
    one.smooth = true;
    one.basin = true;
    return one;
}

void add_basins(std::vector<Case>& cases) {
    const double parabola = 2.0 * std::numbers::pi / std::sqrt(2.0 * exact::gravity * 0.5);
    cases.push_back(basin(
        "thacker-parabola", "Thacker's parabola, 1 m x 4 m, 5 periods", false, 0.5, 5.0 * parabola,
        [](double x, double, double t) { return exact::thacker_parabola(x, t, 1.0, 0.5); }));
    const double planar = 2.0 * std::numbers::pi / std::sqrt(2.0 * exact::gravity * 0.1);
    cases.push_back(basin("thacker-planar", "Thacker's plane surface going round, 1 period", true,
                          0.1, planar, [](double x, double y, double t) {
                              return exact::thacker_planar(x, y, t, 1.0, 0.1, 0.5);
                          }));
    const double radial = 2.0 * std::numbers::pi / std::sqrt(8.0 * exact::gravity * 0.1);
    cases.push_back(basin("thacker-radial", "Thacker's curved surface, 1 period", true, 0.1, radial,
                          [](double x, double y, double t) {
                              return exact::thacker_radial(x, y, t, 1.0, 0.1, 0.8);
                          }));
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    add_bumps(cases);
    add_channels(cases);
    add_dams(cases);
    add_basins(cases);
    return cases;
}

Setting setting_of(const Case& one, int cells) {
    const int rows = one.square ? cells : strip_rows;
    const double dx = one.length / cells;
    Setting setting{one.bed(cells, rows),
                    {Grid(cells, rows), Grid(cells, rows), Grid(cells, rows)},
                    {},
                    one.parameters};
    for (EdgeSettings& edge : setting.parameters.edges) {
        if (edge.kind == EdgeFlow::discharge) edge.value *= dx * rows;
    }
    setting.domain.dx = setting.domain.dy = dx;
    setting.domain.edges_x = setting.parameters.edges_x;
    setting.domain.edges_y = setting.parameters.edges_y;
    setting.domain.segments = edge_segments_of(setting.parameters, setting.domain, cells, rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < cells; ++x) {
            const Flow flow =
                one.start(one.west + (x + 0.5) * dx, one.west + (y + 0.5) * dx, setting.bed(x, y));
            setting.water.depth(x, y) = flow.depth;
            setting.water.velocity_x(x, y) = flow.u;
            setting.water.velocity_y(x, y) = flow.v;
        }
    }
    return setting;
}

namespace {

/// The mean depth over a cell that the shore crosses; of others the depth at its middle, as that
/// over a bed whose heights are those of the middles.
double mean_depth(const Case& one, double x, double y, double dx) {
    const double middle = one.exact(x, y, one.duration).depth;
    const int parts = one.square ? 32 : 256;
    const int parts_y = one.square ? parts : 1;
    const auto at = [&](int k, int of) { return ((k + 0.5) / of - 0.5) * dx; };
    const auto sample = [&](int kx, int ky) {
        return one.exact(x + at(kx, parts), y + at(ky, parts_y), one.duration).depth;
    };
    int wet = 0;
    for (const int kx : {0, parts - 1}) {
        for (const int ky : {0, parts_y - 1}) wet += sample(kx, ky) > 0.0 ? 1 : 0;
    }
    if (wet == 4 || (wet == 0 && !(middle > 0.0))) return middle;
    double sum = 0.0;
    for (int ky = 0; ky < parts_y; ++ky) {
        for (int kx = 0; kx < parts; ++kx) sum += sample(kx, ky);
    }
    return sum / (parts * parts_y);
}

}  // namespace

Errors errors_of(const Case& one, const Setting& setting, const Water& water, DepthsAtShore kept) {
    constexpr int near = 5;
    const int nx = water.depth.nx();
    const int ny = water.depth.ny();
    const double dx = setting.domain.dx;
    const auto middle = [&](int k) { return one.west + (k + 0.5) * dx; };
    Grid exact_depth(nx, ny);
    Errors errors;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const Flow flow = one.exact(middle(x), middle(y), one.duration);
            exact_depth(x, y) = flow.depth;
            if (!(flow.depth > 0.0)) continue;
            const double du = water.velocity_x(x, y) - flow.u;
            const double dv = water.velocity_y(x, y) - flow.v;
            errors.speed = std::max(errors.speed, std::sqrt(du * du + dv * dv));
        }
    }
    const auto is_away = [&](int x, int y) {
        for (const double kink : one.kinks) {
            if (std::fabs(middle(x) - kink) < (near + 0.5) * dx) return false;
        }
        const int reach = one.square ? near : 0;
        for (int ny_ = y - reach; ny_ <= y + reach; ++ny_) {
            for (int nx_ = x - near; nx_ <= x + near; ++nx_) {
                if (nx_ < 0 || nx_ >= nx || ny_ < 0 || ny_ >= ny) continue;
                if (!(exact_depth(nx_, ny_) > 0.0)) return false;
            }
        }
        return true;
    };
    double volume = 0.0;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (middle(x) > one.until) continue;
            const double exact = kept == DepthsAtShore::means
                                     ? mean_depth(one, middle(x), middle(y), dx)
                                     : exact_depth(x, y);
            const double error = std::fabs(water.depth(x, y) - exact);
            volume += exact_depth(x, y);
            errors.depth += error;
            if (is_away(x, y)) errors.away += error;
        }
    }
    errors.depth /= volume;
    errors.away /= volume;
    return errors;
}

DepthsAtShore depths_of(const Case& one) {
    return one.basin && one.parameters.shore_cells == ShoreCells::planes
               ? DepthsAtShore::means
               : DepthsAtShore::at_middles;
}

Outcome run_case(const Case& one, int cells, int threads) {
    Setting setting = setting_of(one, cells);
    WorkerPool pool(threads);
    FiniteVolumeScheme scheme(setting.parameters, setting.domain, pool);
    scheme.convert_to_means(setting.water, setting.bed);
    Outcome outcome;
    const double rain = setting.parameters.rain / 3.6e6;
    const auto volume = [&] {
        CompensatedSum sum;
        for (const double depth : setting.water.depth.values()) sum.add(depth);
        return sum.value() * setting.domain.dx * setting.domain.dy;
    };
    const double area =
        setting.domain.dx * setting.domain.dy * static_cast<double>(setting.bed.size());
    const double before = volume();
    const double began = processor_seconds();
    CompensatedSum fallen;
    double time = 0.0;
    double of_water = scheme.step_at_courant_one(setting.water);
    while (time < one.duration) {
        const double at_one =
            std::min(of_water, scheme.edge_step_at_courant_one(time, setting.bed));
        const double dt = std::min(0.4 * at_one, one.duration - time);
        scheme.set_time(time + 0.5 * dt);
        of_water = scheme.advance(setting.water, setting.bed, dt, rain);
        fallen.add(rain * dt * area);
        time += dt;
        ++outcome.steps;
    }
    outcome.seconds = processor_seconds() - began;
    outcome.errors = errors_of(one, setting, setting.water, depths_of(one));
    const double after = volume();
    const double balance = ((after - before) - fallen.value()) + (scheme.left() - scheme.entered());
    outcome.errors.mass =
        std::fabs(balance) / std::max({after, before, scheme.left(), scheme.entered()});
    return outcome;
}

Outcome run_plainly(const Case& one, int cells) {
    Setting setting = setting_of(one, cells);
    FirstOrder scheme(setting.parameters, setting.domain, setting.bed, setting.water);
    Outcome outcome;
    const double began = processor_seconds();
    double time = 0.0;
    while (time < one.duration) {
        const double dt = std::min(0.9 * scheme.step_at_courant_one(), one.duration - time);
        scheme.advance(time + 0.5 * dt, dt);
        time += dt;
        ++outcome.steps;
    }
    outcome.seconds = processor_seconds() - began;
    outcome.errors = errors_of(one, setting, scheme.water(), DepthsAtShore::at_middles);
    return outcome;
}

}  // namespace fumon::examination
