// Million cell-steps per second of the finite-volume shallow water on all processors, over grid
// sizes; a cell-step is one cell advanced by one sub-step, both stages and its length included. The
// film beside plain loops on one processor. Loads: the whole model, whose step is one sub-step of
// water, bed load, suspended load and bed, and the failing of banks.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/state_archive.h"
#include "base/worker_pool.h"
#include "fastest.h"
#include "models/water/finite_volume_scheme.h"
#include "models/water/gully.h"
#include "plain/finite_volume_plain.h"

namespace fumon {
namespace {

constexpr int beside_plain_side = 512;
constexpr double slope = 0.04;
constexpr double depth = 0.01;  // m
constexpr double speed = 0.6;   // m/s
constexpr double rain = 1e-5;   // m/s
constexpr double courant_number = 0.4;

Grid noise(int side, double height) {
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& z : bed.row(y)) z = height * stream.uniform();
    }
    return bed;
}

void measure(benchmark::State& state, double roughness, EdgeKind edges, bool has_plain) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    WaterDomain domain;
    domain.slope = slope;
    domain.edges_x = domain.edges_y = edges;
    const Grid bed = noise(side, roughness);
    const Water film{Grid(side, side, depth), Grid(side, side), Grid(side, side, -speed)};
    FiniteVolumeScheme scheme({}, domain, pool);
    Water water = film;
    double step_at_one = scheme.step_at_courant_one(water);
    const auto advance = [&] {
        step_at_one = scheme.advance(water, bed, courant_number * step_at_one, rain);
    };
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state) state.SetIterationTime(fastest.time(advance));
    const double cells = static_cast<double>(side) * side;
    state.counters["million_cell_steps_per_second"] = fastest.rate(cells);
    if (!has_plain || side != beside_plain_side) return;
    // A step of fumon's after each plain one, so that both meet the same disturbances.
    plain::FiniteVolume plain(bed, slope, depth, speed);
    water = film;
    step_at_one = scheme.step_at_courant_one(water);
    Fastest plain_fastest;
    constexpr int steps = 30;
    for (int step = 0; step < steps; ++step) {
        plain_fastest.time([&] { plain.step(courant_number, rain); });
        fastest.time(advance);
    }
    if (water.depth != plain.depth() || water.velocity_y != plain.velocity_y())
        state.SkipWithError("the plain loops came to another end");
    state.counters["million_cell_steps_per_second"] = fastest.rate(cells);
    state.counters["plain"] = plain_fastest.rate(cells);
    state.counters["ratio_to_plain"] = fastest.rate(cells) / plain_fastest.rate(cells);
}

void film(benchmark::State& state) {
    measure(state, 0.001, EdgeKind::periodic, true);
}
void film_with_islands(benchmark::State& state) {
    measure(state, 0.1, EdgeKind::open, false);
}

GullyParameters parameters_of_loads(BedLoadLaw bed_load, EntrainmentLaw entrainment) {
    GullyParameters parameters;
    parameters.scheme = WaterScheme::finite_volume;
    parameters.transport = SedimentTransport::loads;
    parameters.friction = FrictionLaw::manning;
    parameters.slope = slope;
    parameters.depth = depth;
    parameters.time_step = 0.1;
    parameters.substeps = Substeps::fixed;
    parameters.loads.bed_load = bed_load;
    parameters.loads.entrainment = entrainment;
    return parameters;
}

/// Puts the same load into the water everywhere, m.
class LoadAll : public StateArchive {
  public:
    explicit LoadAll(double load) : load_(load) {}
    void values(std::string_view name, std::span<double> values) override {
        if (name == "suspended_load") std::ranges::fill(values, load_);
    }
    void values(std::string_view /*name*/, std::span<std::int64_t> /*values*/) override {}
    void list(std::string_view /*name*/, std::vector<double>& /*values*/) override {}
    void list(std::string_view /*name*/, std::vector<std::int64_t>& /*values*/) override {}
    void text(std::string_view /*name*/, std::string& /*text*/) override {}
    [[noreturn]] void refuse(const std::string& why) const override { throw Error(why); }

  private:
    double load_;
};

void measure_loads(benchmark::State& state, const GullyParameters& parameters, double load = 0.0) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    Gully gully(parameters, {noise(side, 0.001), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    LoadAll loaded(load);
    gully.serialise(loaded);
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state)
        state.SetIterationTime(fastest.time([&] { gully.step(); }));
    state.counters["million_cell_steps_per_second"] =
        fastest.rate(static_cast<double>(side) * side);
}

void bed_load(benchmark::State& state) {
    measure_loads(state,
                  parameters_of_loads(BedLoadLaw::meyer_peter_mueller, EntrainmentLaw::none));
}
void bed_and_suspended_load(benchmark::State& state) {
    measure_loads(
        state, parameters_of_loads(BedLoadLaw::meyer_peter_mueller, EntrainmentLaw::excess_shear));
}
void suspended_load(benchmark::State& state) {
    measure_loads(state, parameters_of_loads(BedLoadLaw::none, EntrainmentLaw::excess_shear));
}
/// Far from where any is taken up, of grains that settle slowly: so little that a processor keeps
/// it as a subnormal number.
void faded_load(benchmark::State& state) {
    GullyParameters parameters =
        parameters_of_loads(BedLoadLaw::none, EntrainmentLaw::excess_shear);
    parameters.loads.entrainment_stress = 1000.0;
    parameters.loads.settling_velocity = {"", 1e-6};
    measure_loads(state, parameters, 1e-310);
}

/// A river that winds through dry ground, 5 % of the cells, beside the same ground under water.
void river(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    const Grid bed = noise(side, 0.1);
    Water wet{Grid(side, side, 1.0), Grid(side, side), Grid(side, side)};
    Water water{Grid(side, side), Grid(side, side), Grid(side, side)};
    const double turn = 6.2831853 / side;  // two bends
    int cells = 0;
    for (int x = 0; x < side; ++x) {
        const double middle = side * (0.5 + 0.15 * std::sin(2.0 * turn * x));
        for (int y = 0; y < side; ++y) {
            if (std::fabs(y - middle) > 0.025 * side) continue;
            water.depth(x, y) = 1.0;
            ++cells;
        }
    }
    const auto time_of = [&](Water& one, auto&& each) {
        FiniteVolumeScheme scheme({}, {}, pool);
        double step_at_one = scheme.step_at_courant_one(one);
        Fastest fastest;
        each([&] {
            return fastest.time(
                [&] { step_at_one = scheme.advance(one, bed, courant_number * step_at_one, 0.0); });
        });
        return fastest.rate(1.0);
    };
    const double of_river = time_of(water, [&](const auto& step) {
        for ([[maybe_unused]] auto _ : state) state.SetIterationTime(step());
    });
    const double of_all = time_of(wet, [](const auto& step) {
        for (int k = 0; k < 10; ++k) step();
    });
    state.counters["wet_share"] = cells / (static_cast<double>(side) * side);
    state.counters["cost_over_all_wet"] = of_all / of_river;
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(2)->Range(128, 4096)->Unit(benchmark::kMillisecond)->UseManualTime();
}

BENCHMARK(film)->Apply(sizes);
BENCHMARK(film_with_islands)->Apply(sizes);
BENCHMARK(bed_load)->Arg(512)->Arg(2048)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(bed_and_suspended_load)
    ->Arg(512)
    ->Arg(2048)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK(suspended_load)->Arg(512)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(faded_load)->Arg(512)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(river)->Arg(512)->Arg(2048)->Unit(benchmark::kMillisecond)->UseManualTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
