// What the processor can do at most, by which the bounds in README.md are reckoned: its clock, its
// sums and products of four doubles at once, and the bytes that pass between memory and its
// threads.

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/worker_pool.h"
#include "fastest.h"

namespace fumon {
namespace {

/// Takes the value for changed, so that the compiler works nothing out beforehand.
void changed(std::uint64_t& value) {
    asm volatile("" : "+r"(value));
}

/// Rotations that wait for one another, one a cycle: billions of cycles a second.
void clock_rate(benchmark::State& state) {
    constexpr int turns = 1 << 20;
    constexpr unsigned by = 7;
    std::uint64_t word = 1;
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state) {
        state.SetIterationTime(fastest.time([&] {
            for (int i = 0; i < turns; ++i) {
                word = (word << by) | (word >> (64U - by));
                changed(word);
            }
        }));
    }
    state.counters["gigahertz"] = 1e-3 * fastest.rate(turns);
}

using FourDoubles [[gnu::vector_size(32)]] = double;

/// Sums and products of four doubles, as many at once as the processor can: billions of vectors a
/// second.
void sums_and_products(benchmark::State& state) {
    constexpr int rounds = 1 << 17;
    constexpr std::size_t chains = 6;
    const FourDoubles by = {1.0000001, 0.9999999, 1.0000001, 0.9999999};
    std::array<FourDoubles, chains> sums{by, by, by, by, by, by};
    std::array<FourDoubles, chains> products = sums;
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state) {
        state.SetIterationTime(fastest.time([&] {
            for (int round = 0; round < rounds; ++round) {
                for (FourDoubles& sum : sums) sum += by;
                for (FourDoubles& product : products) product *= by;
            }
        }));
        benchmark::DoNotOptimize(sums);
        benchmark::DoNotOptimize(products);
    }
    state.counters["billion_vectors_per_second"] = 1e-3 * fastest.rate(2.0 * chains * rounds);
}

/// A field larger than the caches is read and written in place, by so many threads: gigabytes a
/// second, both ways.
void memory(benchmark::State& state) {
    constexpr int cells = 1 << 26;
    constexpr double bytes_of_a_cell = 16.0;
    std::vector<double> field(cells, 1.0);
    WorkerPool pool(static_cast<int>(state.range(0)));
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state) {
        state.SetIterationTime(fastest.time([&] {
            pool.for_ranges(cells, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) field[static_cast<std::size_t>(i)] += 1.0;
            });
        }));
    }
    state.counters["gigabytes_per_second"] = 1e-3 * bytes_of_a_cell * fastest.rate(cells);
}

BENCHMARK(clock_rate)->UseManualTime();
BENCHMARK(sums_and_products)->UseManualTime();
BENCHMARK(memory)->Arg(1)->Arg(0)->UseManualTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
