// Million cell-steps per second of the wind-blown sand family on all processors, over grid sizes,
// and beside plain loops on one.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/random.h"
#include "base/stopwatch.h"
#include "base/worker_pool.h"
#include "models/sand/sand.h"
#include "plain/sand_plain.h"

namespace fumon {
namespace {

constexpr int beside_plain_side = 1024;
constexpr int beside_plain_sites = 1'000'000;

Grid noise(int side, double low, double high) {
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = low + (high - low) * stream.uniform();
    }
    return bed;
}

SandParameters terada_ripples() {
    return {};
}

SandParameters terada_dunes() {
    SandParameters sand;
    sand.hop_length = HopLength::slope;
    sand.hop_amount = HopAmount::slope;
    sand.landing = Landing::truncate;
    return sand;
}

SandParameters terada_exponential() {
    SandParameters sand;
    sand.hop_length = HopLength::exponential;
    sand.creep_rate = 0.7;
    return sand;
}

SandParameters sudo(Creep creep) {
    SandParameters sand;
    sand.order = HopOrder::random_sequential;
    sand.hop_base = 3.0;
    sand.hop_per_height = 1.0;
    sand.landing = Landing::truncate;
    sand.limit_amount = false;
    sand.creep = creep;
    sand.creep_rate = 0.1;
    return sand;
}

/// Of several steps the fastest, which other programs disturbed least.
class Fastest {
  public:
    template <class Model>
    double step(Model& model) {
        const Stopwatch watch;
        model.step();
        const double seconds = watch.seconds();
        seconds_ = std::min(seconds_, seconds);
        return seconds;
    }
    /// Million cell-steps per second.
    [[nodiscard]] double rate(double cells) const { return 1e-6 * cells / seconds_; }

  private:
    double seconds_ = std::numeric_limits<double>::infinity();
};

/// Steps after the bed has come to a pattern. `beside_plain`: between those of the plain loops,
/// whose bed must come out the same where they draw the same random numbers.
void measure(benchmark::State& state, const SandParameters& parameters, const Grid& bed,
             int steps_to_a_pattern, bool beside_plain) {
    constexpr std::uint64_t seed = 1;
    WorkerPool pool;
    Sand sand(parameters, {bed, {}, {}, seed, pool});
    plain::Sand plain_sand(parameters, bed, seed, plain::Draw::row_by_row);
    plain::Sand published(parameters, bed, seed, plain::Draw::whole_grid);
    const bool random = parameters.order == HopOrder::random_sequential;
    for (int step = 0; step < steps_to_a_pattern; ++step) {
        sand.step();
        if (!beside_plain) continue;
        plain_sand.step();
        if (random) published.step();
    }
    Fastest fastest;
    Fastest plain_fastest;
    Fastest published_fastest;
    for ([[maybe_unused]] auto _ : state) {
        state.SetIterationTime(fastest.step(sand));
        if (!beside_plain) continue;
        plain_fastest.step(plain_sand);
        if (random) published_fastest.step(published);
    }
    const auto cells = static_cast<double>(bed.size());
    state.counters["million_cell_steps_per_second"] = fastest.rate(cells);
    if (!beside_plain) return;
    state.counters["plain"] = plain_fastest.rate(cells);
    state.counters["ratio_to_plain"] = fastest.rate(cells) / plain_fastest.rate(cells);
    if (random) {
        state.counters["plain_over_whole_grid"] = published_fastest.rate(cells);
        state.counters["ratio_to_plain_over_whole_grid"] =
            fastest.rate(cells) / published_fastest.rate(cells);
    }
    if (sand.snapshot().bed != plain_sand.bed())
        state.SkipWithError("the plain loops came to another bed");
}

void measure(benchmark::State& state, const SandParameters& parameters, double low, double high) {
    const int side = static_cast<int>(state.range(0));
    measure(state, parameters, noise(side, low, high), 30, side == beside_plain_side);
}

void ripples(benchmark::State& state) {
    measure(state, terada_ripples(), 0.0, 1.0);
}
void dunes(benchmark::State& state) {
    measure(state, terada_dunes(), 0.0, 1.0);
}
void exponential(benchmark::State& state) {
    measure(state, terada_exponential(), 0.0, 1.0);
}
void sudo_every_cell(benchmark::State& state) {
    measure(state, sudo(Creep::every_cell), 2.85, 3.15);
}
void sudo_maxima_only(benchmark::State& state) {
    measure(state, sudo(Creep::maxima_only), 2.85, 3.15);
}

/// One row of 10,000 to 4 million sites: Sudo's profile model.
void profile(benchmark::State& state) {
    const int sites = static_cast<int>(state.range(0));
    SandParameters parameters = sudo(Creep::profile);
    parameters.hop_base = 50.0;
    Grid bed(sites, 1);
    RandomStream stream(1, 0, 0, Purpose::initial_bed);
    for (double& height : bed.values()) height = 48.5 + 3.0 * stream.uniform();
    measure(state, parameters, bed, 100, sites == beside_plain_sites);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(2)->Range(128, 4096)->Unit(benchmark::kMillisecond)->UseManualTime();
}

BENCHMARK(ripples)->Apply(sizes);
BENCHMARK(dunes)->Apply(sizes);
BENCHMARK(exponential)->Apply(sizes);
BENCHMARK(sudo_every_cell)->Apply(sizes);
BENCHMARK(sudo_maxima_only)->Apply(sizes);
BENCHMARK(profile)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(4000000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
