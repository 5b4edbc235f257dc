// The saturation length of the drift over dunes: how fast it follows a change of the wind, and what
// that makes of waves of a bed, against ∂q/∂x = (q_sat − q)/ℓ.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/dunes/transport/saturation_hops.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

ModelSetup box_of(Grid bed, WorkerPool& pool, double cell) {
    return {std::move(bed), {}, {cell, cell, 1.0, true}, 7, pool};
}

/// How far into sand behind bare rock the drift reaches 1 − 1/e of the saturated one, metres along
/// x, under a wind that crosses the edge of the sand at any angle.
double saturated_after(DunesParameters dunes, double from, double cell) {
    constexpr int nx = 120;
    constexpr int edge = 40;
    constexpr double step = 1e-5;
    constexpr double sand = 0.02;  // m
    dunes.winds = {{from, 1.0, 1.0}};
    dunes.speed_up = DuneSpeedUp::none;
    dunes.edges_x = DuneEdge::open;
    dunes.flux = 4.0;
    dunes.slope_drift = 0.0;
    dunes.time_step = step;
    Grid bed(nx, 4);
    for (int y = 0; y < 4; ++y) std::ranges::fill(bed.row(y).subspan(edge), sand);
    WorkerPool pool(1);
    Dunes model(dunes, box_of(std::move(bed), pool, cell));
    for (int n = 0; n < 150; ++n) model.step();
    const FixedPointGrid before = model.bed().surface;
    model.step();
    const double whole = std::abs(std::sin(from * degree)) * dunes.flux * step / cell;  // m
    const double reached = (1.0 - std::exp(-1.0)) * whole;
    double drift = 0.0;
    for (int x = edge; x < nx; ++x) {
        const double gained = to_metres(before(x, 2) - model.bed().surface(x, 2));
        if (drift + gained > reached) return cell * (x - edge + (reached - drift) / gained);
        drift += gained;
    }
    return 0.0;
}

TEST(DuneSaturation, TheDriftFollowsOverTheSaturationLength) {
    for (const double length : {1.0, 2.5}) {
        for (const double p : {0.2, 0.45, 0.6, 0.95}) {
            for (const double from : {270.0, 247.0, 225.0, 315.0}) {
                DunesParameters dunes;
                dunes.deposit_on_sand = p;
                dunes.saturation_length = length;
                const double along = length * std::abs(std::sin(from * degree));
                const double measured = saturated_after(dunes, from, 0.1 * length);
                EXPECT_NEAR(measured / along, 1.0, 0.02) << length << ", " << p << ", " << from;
            }
        }
    }
}

/// The former law: hops of one length, whose number is geometric.
TEST(DuneSaturation, HopsOfOneLengthSaturateOverLessThanTheirLengthDividedByTheShareThatStays) {
    for (const double p : {0.3, 0.6, 0.9}) {
        DunesParameters dunes;
        dunes.deposit_on_sand = p;
        dunes.saturation_length = {"hops", 0.0};
        const double law = (2.0 - p) / (2.0 * p);
        EXPECT_NEAR(saturated_after(dunes, 270.0, 0.1) / law, 1.0, p > 0.8 ? 0.16 : 0.04) << p;
    }
}

/// Growth rates by the linear theory, 1/yr: Q k² ((B − A k ℓ)/(1 + k² ℓ²) − c).
double growth_in_theory(const DunesParameters& of, double length, double wave) {
    const double k = 2.0 * std::acos(-1.0) / wave;
    const double lag = k * length;
    return of.flux * k * k *
           ((of.shear_ahead - of.shear_in_phase * lag) / (1.0 + lag * lag) - of.slope_drift);
}

double wave_amplitude(const Dunes& model) {
    const auto row = model.bed().surface.row(1);
    double real = 0.0;
    double imaginary = 0.0;
    for (std::size_t x = 0; x < row.size(); ++x) {
        const double phase =
            2.0 * std::acos(-1.0) * static_cast<double>(x) / static_cast<double>(row.size());
        real += to_metres(row[x]) * std::cos(phase);
        imaginary += to_metres(row[x]) * std::sin(phase);
    }
    return std::hypot(real, imaginary);
}

/// Of a wave along the wind, in cells of a 32nd of it or of a metre. Steps are the default ones, or
/// for waves below 18 m, which run far in them, a sixth of these.
double growth_of_wave(DunesParameters dunes, double wave, int finer = 0) {
    const double cell = std::min(1.0, wave / 32.0);
    const int nx = static_cast<int>(std::lround(wave / cell));
    if (finer == 0) finer = wave < 18.0 ? 6 : 1;
    if (finer > 1)
        dunes.time_step = 0.03 * cell * dunes.saturation_length.value / dunes.flux / finer;
    Grid bed(nx, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < nx; ++x)
            bed(x, y) = 1.0 + 0.002 * std::cos(2.0 * std::acos(-1.0) * x / nx);
    }
    WorkerPool pool(1);
    Dunes model(dunes, box_of(std::move(bed), pool, cell));
    for (int n = 0; n < 60 * finer; ++n) model.step();
    const double first = wave_amplitude(model);
    const double then = model.time();
    for (int n = 0; n < 100 * finer; ++n) model.step();
    return std::log(wave_amplitude(model) / first) / (model.time() - then);
}

TEST(DuneSaturation, WavesGrowAsTheLinearTheoryHasIt) {
    for (const double p : {0.2, 0.6, 0.95}) {
        DunesParameters dunes;
        dunes.saturation_length = 1.0;
        dunes.deposit_on_sand = p;
        const double fastest = growth_in_theory(dunes, 1.0, 20.0);
        for (const double wave : {12.0, 16.0, 20.0, 24.0, 32.0, 48.0, 64.0, 128.0}) {
            const double theory = growth_in_theory(dunes, 1.0, wave);
            const double measured = growth_of_wave(dunes, wave);
            std::printf("    p %.2f, %3.0f m: %.3f measured, %.3f predicted, of %.3f\n", p, wave,
                        measured, theory, fastest);
            EXPECT_NEAR(measured / theory, 1.0, 0.03) << p << ", " << wave;
        }
        // The cut-off, between waves that decay and that grow.
        const double short_wave = growth_of_wave(dunes, 13.0);
        const double long_wave = growth_of_wave(dunes, 14.0);
        EXPECT_LT(growth_in_theory(dunes, 1.0, 13.44), 0.0);
        EXPECT_GT(growth_in_theory(dunes, 1.0, 13.5), 0.0);
        EXPECT_NEAR(13.0 + short_wave / (short_wave - long_wave), 13.49, 0.02 * 13.49);
    }
}

TEST(DuneSaturation, TheGridDoesNotSetTheSaturationLength) {
    for (const double cell : {1.0, 1.5}) {  // of lengths that reach one cell
        DunesParameters dunes;
        dunes.saturation_length = 1.5;
        Grid bed(32, 4);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 32; ++x)
                bed(x, y) = 1.0 + 0.002 * std::cos(2.0 * std::acos(-1.0) * x / 32.0);
        }
        WorkerPool pool(1);
        Dunes model(dunes, box_of(std::move(bed), pool, cell));
        for (int n = 0; n < 60; ++n) model.step();
        const double first = wave_amplitude(model);
        const double then = model.time();
        for (int n = 0; n < 100; ++n) model.step();
        const double measured = std::log(wave_amplitude(model) / first) / (model.time() - then);
        EXPECT_NEAR(measured / growth_in_theory(dunes, 1.5, 32.0 * cell), 1.0, 0.03) << cell;
    }
}

/// A wave at 45 degrees to the wind, as long as the diagonal of a square box of so many cells.
struct ObliqueWave {
    int cells;
    double cell;  ///< m
    [[nodiscard]] double wave_number() const { return 2.0 * std::acos(-1.0) / (cells * cell); }
    [[nodiscard]] double phase(int x, int y) const { return wave_number() * cell * (x + y); }
};

double amplitude_of(const ObliqueWave& wave, const FixedPointGrid& surface) {
    double in_phase = 0.0;
    double out_of_phase = 0.0;
    for (int y = 0; y < wave.cells; ++y) {
        for (int x = 0; x < wave.cells; ++x) {
            in_phase += to_metres(surface(x, y)) * std::cos(wave.phase(x, y));
            out_of_phase += to_metres(surface(x, y)) * std::sin(wave.phase(x, y));
        }
    }
    return std::hypot(in_phase, out_of_phase);
}

double growth_of(const ObliqueWave& wave, DunesParameters dunes) {
    dunes.time_step = {"", 0.0005 * wave.cell / 1.3};
    Grid bed(wave.cells, wave.cells);
    for (int y = 0; y < wave.cells; ++y) {
        for (int x = 0; x < wave.cells; ++x) bed(x, y) = 1.0 + 0.002 * std::cos(wave.phase(x, y));
    }
    WorkerPool pool(1);
    Dunes model(dunes, box_of(std::move(bed), pool, wave.cell));
    for (int n = 0; n < 40; ++n) model.step();
    const double first = amplitude_of(wave, model.bed().surface);
    const double then = model.time();
    for (int n = 0; n < 100; ++n) model.step();
    return std::log(amplitude_of(wave, model.bed().surface) / first) / (model.time() - then);
}

/// Hops spread across the wind too, by D = dx² v / (2 length) of the drift, with which a wave of
/// wave numbers k_w along the wind and k_n across it loses Q D k_n² A k_w² / |k| of its growth.
TEST(DuneSaturation, ObliqueWavesGrowTooLittleByTheSpreadOfHops) {
    constexpr double box = 31.2;  // m
    DunesParameters dunes;
    dunes.saturation_length = {"", 1.3};
    for (const int cells : {24, 48, 96}) {
        const ObliqueWave wave{cells, box / cells};
        const double k = wave.wave_number();          // along the wind, and across it
        const double steepened = k / std::sqrt(2.0);  // k_w² / |k|
        const double lag = 1.3 * k;
        const double theory =
            dunes.flux *
            (k * steepened * (dunes.shear_ahead - dunes.shear_in_phase * lag) / (1.0 + lag * lag) -
             dunes.slope_drift * 2.0 * k * k);
        const SaturationHops hops =
            saturation_hops(dunes, {cells, cells, wave.cell, wave.cell, true, true}, 1.0, 0.0);
        const double spread = wave.cell * wave.cell * hops.spread_y / (2.0 * hops.length);
        const double lost = dunes.flux * spread * k * k * dunes.shear_in_phase * steepened;
        const double measured = growth_of(wave, dunes);
        std::printf("    cells of %.3f m: %.3f measured, %.3f predicted, %.3f without spread\n",
                    wave.cell, measured, theory - lost, theory);
        EXPECT_NEAR(measured, theory - lost, 0.1) << wave.cell;
        if (cells == 96) {
            EXPECT_NEAR(measured, theory, 0.1);
        }
    }
}

/// Near the threshold of transport B is B − 1/(μ r²) and relief counts 1/(1 − 1/r²) times (Gadal et
/// al. 2019), r = u*/u*t.
TEST(DuneSaturation, NearTheThresholdFlatBedsAreMoreStable) {
    for (const double ratio : {1.2, 1.5, 2.0, 5.0}) {
        DunesParameters dunes;
        dunes.saturation_length = 1.0;
        dunes.slope_drift = 0.0;
        DuneWind wind;
        wind.threshold_ratio = ratio;
        dunes.winds = {wind};
        const double over = 1.0 / (1.0 - 1.0 / (ratio * ratio));
        DunesParameters above = dunes;
        above.shear_ahead = over * (dunes.shear_ahead - 1.0 / (0.63 * ratio * ratio));
        above.shear_in_phase = over * dunes.shear_in_phase;
        for (const double wave : {24.0, 40.0, 80.0}) {
            const double theory = growth_in_theory(above, 1.0, wave);
            const double fastest = growth_in_theory(above, 1.0, 40.0);
            const int finer = ratio < 1.4 ? 24 : 6;  // these waves run faster
            EXPECT_NEAR(growth_of_wave(dunes, wave, finer), theory, 0.03 * std::abs(fastest))
                << ratio << ", " << wave;
        }
    }
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.speed_up = DuneSpeedUp::none;
    DuneWind wind;
    wind.threshold_ratio = 2.0;
    dunes.winds = {wind};
    EXPECT_NE(message_of<KeyError>([&] {
                  Dunes(dunes, box_of(Grid(20, 20, 1.0), pool, 1.0));
              }).find("a threshold needs the shear stress over relief"),
              std::string::npos);
}

/// Sand blows in at the share of saturation that was asked for, whatever hops it comes in.
TEST(DuneSaturation, WhatBlowsInIsAShareOfTheSaturatedDrift) {
    for (const char* word : {"auto", "hops"}) {
        DunesParameters dunes;
        dunes.saturation_length = {word, 0.0};
        dunes.edges_x = DuneEdge::open;
        dunes.influx = 0.3;
        WorkerPool pool(1);
        Dunes model(dunes, box_of(Grid(60, 8), pool, 0.5));
        for (int n = 0; n < 40; ++n) model.step();
        const std::int64_t inflow = model.bed().inflow;
        const double then = model.time();
        for (int n = 0; n < 20; ++n) model.step();
        const double came = to_metres(model.bed().inflow - inflow) * 0.25;  // m³, over 4 m
        EXPECT_NEAR(came / (4.0 * (model.time() - then)), 0.3 * dunes.flux, 1e-3) << word;
    }
}

TEST(DuneSaturation, WhatDoesNotFitIsRefused) {
    WorkerPool pool(1);
    const auto refusal = [&](const DunesParameters& dunes, double cell) {
        return message_of<KeyError>([&] { Dunes(dunes, box_of(Grid(20, 20, 1.0), pool, cell)); });
    };
    DunesParameters dunes;
    dunes.saturation_length = 0.5;
    EXPECT_NE(refusal(dunes, 1.0).find("cells of 1 m cannot resolve a saturation length of 0.5 m"),
              std::string::npos);
    dunes.saturation_length = 50.0;
    EXPECT_NE(refusal(dunes, 1.0).find("exceeds the box of 20 m"), std::string::npos);
    dunes.saturation_length = 2.0;
    dunes.hop_length = 2.0;
    EXPECT_NE(refusal(dunes, 1.0).find("hops follow from model.saturation_length"),
              std::string::npos);
    dunes.transport = DuneTransport::slabs;
    dunes.speed_up = DuneSpeedUp::none;
    EXPECT_NE(refusal(dunes, 1.0).find("slabs hop by model.hop_length"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
