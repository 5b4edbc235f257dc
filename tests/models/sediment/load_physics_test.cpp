// What grains in water do, against analysis.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "models/sediment/load_parameters.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

constexpr double manning = 0.03;
constexpr double uniform_slope = manning * manning;  // of water a metre deep at 1 m/s
constexpr double falling = 9.8;                      // m/s²

/// A stream a metre deep that runs east at 1 m/s over an even bed, and carries nothing.
GullyParameters even_stream() {
    GullyParameters gully = WaterParameters();
    gully.transport = SedimentTransport::loads;
    gully.friction = FrictionLaw::manning;
    gully.manning = manning;
    gully.slope_x = uniform_slope;
    gully.initial_water = InitialWater::film;
    gully.depth = 1.0;
    gully.time_step = 1.0;
    gully.loads.bed_load = BedLoadLaw::none;
    gully.loads.bank_failure = BankFailure::none;
    return gully;
}

/// Largest difference of the concentration along 100 m from an exact curve, of a stream whose water
/// has come in through all of it, on cells of so many metres.
double concentration_error(GullyParameters gully, double dx,
                           const std::function<double(double)>& exact) {
    const int nx = static_cast<int>(100.0 / dx);
    gully.edges = {edge(GridSide::west, EdgeFlow::discharge, 20.0),
                   edge(GridSide::east, EdgeFlow::level, 1.0)};
    GullyRun run(gully, Grid(nx, 2), 1, dx, 10.0);
    run.to(200.0);
    const Grid concentration = run.field("concentration");
    double error = 0.0;
    for (int x = 0; x < nx; ++x)
        error = std::max(error, std::fabs(concentration(x, 1) - exact((x + 0.5) * dx)));
    return error;
}

TEST(LoadPhysics, SuspendedGrainsSettleOverTheirLength) {
    GullyParameters gully = even_stream();
    gully.loads.morphological_factor = 0.0;
    gully.loads.inflow_concentration = 0.002;
    gully.loads.settling_velocity = {"", 0.05};
    const auto exact = [](double x) { return 0.002 * std::exp(-x * 0.05); };  // h u / w_s = 20 m
    const double coarse = concentration_error(gully, 2.0, exact) / 0.002;
    const double fine = concentration_error(gully, 1.0, exact) / 0.002;
    EXPECT_LT(fine, 0.03);
    EXPECT_NEAR(coarse / fine, 2.0, 0.3) << "first order";
}

TEST(LoadPhysics, ClearWaterTakesUpWhatItCanHoldOverTheSameLength) {
    GullyParameters gully = even_stream();
    gully.loads.morphological_factor = 0.0;
    gully.loads.entrainment = EntrainmentLaw::excess_shear;
    gully.loads.entrainment_stress = 0.5 * 1000.0 * falling * uniform_slope;
    gully.loads.entrainment_rate = 0.265;  // so that E is 1e-4 m/s
    gully.loads.settling_velocity = {"", 0.02};
    gully.loads.settling_factor = 2.5;
    const auto exact = [](double x) { return 0.002 * (1.0 - std::exp(-x * 0.05)); };
    EXPECT_LT(concentration_error(gully, 1.0, exact), 0.03 * 0.002);
}

/// q_b of Meyer-Peter & Müller, m²/s, of grains of half a millimetre under a metre of water less z,
/// of which 1 m²/s run over a bed of that Manning roughness.
double bed_load_over(double z, double roughness) {
    const double depth = 1.0 - z / (1.0 - 1.0 / falling);  // the surface sinks over a rise
    const double speed = 1.0 / depth;
    const double stress = falling * roughness * roughness * speed * speed / std::cbrt(depth);
    const double shields = stress / (1.65 * falling * 0.0005);
    return 8.0 * std::pow(shields - 0.047, 1.5) * std::sqrt(1.65 * falling * std::pow(0.0005, 3));
}

TEST(LoadPhysics, AHumpMovesAtTheCelerityOfExner) {
    constexpr double roughness = 0.5 * manning;  // little backwater upstream of the hump
    constexpr double factor = 40.0;  // slow against the water, which is in equilibrium with it
    constexpr double seconds = 1200.0;
    constexpr int nx = 200;
    GullyParameters gully = even_stream();
    gully.edges_x = EdgeKind::periodic;
    gully.loads.bed_load = BedLoadLaw::meyer_peter_mueller;
    gully.loads.bed_load_slope = 0.0;
    gully.manning = roughness;
    gully.slope_x = roughness * roughness;
    gully.loads.repose_angle = 85.0;
    gully.loads.morphological_factor = factor;
    Grid bed(nx, 2);
    for (int x = 0; x < nx; ++x) {
        const double away = (x - 80) / 10.0;
        bed(x, 0) = bed(x, 1) = 0.02 * std::exp(-0.5 * away * away);
    }
    GullyRun run(gully, bed, 1, 1.0, 10.0);
    run.to(seconds);
    const Grid after = run.gully.snapshot().bed;
    const auto middle = [](const Grid& of) {
        double sum = 0.0;
        double moment = 0.0;
        for (int x = 0; x < nx; ++x) {
            sum += of(x, 1);
            moment += of(x, 1) * x;
        }
        return moment / sum;
    };
    double grown = 0.0;  // of bed load over the hump
    double volume = 0.0;
    for (int x = 0; x < nx; ++x) {
        grown += bed_load_over(bed(x, 1), roughness) - bed_load_over(0.0, roughness);
        volume += bed(x, 1);
    }
    const double celerity = factor / 0.6 * grown / volume;
    EXPECT_GT(celerity * seconds, 15.0) << "a way that can be measured";
    EXPECT_NEAR(middle(after) - middle(bed), celerity * seconds, 0.03 * celerity * seconds);
    EXPECT_LT(std::fabs(run.number("sediment_volume")), 1e-12 * run.number("eroded_volume"));
}

TEST(LoadPhysics, TheBedWaitsUntilItsStart) {
    constexpr double factor = 5.0;
    GullyParameters gully = even_stream();
    gully.loads.bed_load = BedLoadLaw::meyer_peter_mueller;
    gully.loads.entrainment = EntrainmentLaw::excess_shear;
    gully.loads.entrainment_stress = 0.5;
    gully.loads.morphological_factor = factor;
    gully.bed_diffusion = 1e-3;
    gully.time_step = 0.5;
    gully.loads.bed_start = 9.7;  // in the twentieth step, so after it
    Grid bed(40, 2);
    for (int x = 0; x < 40; ++x) bed(x, 0) = bed(x, 1) = x == 20 ? 0.05 : 0.0;
    GullyRun run(gully, bed, 1, 1.0, 10.0);
    GullyParameters rigid = gully;
    rigid.transport = SedimentTransport::none;
    rigid.bed_diffusion = 0.0;
    GullyRun over_rigid(rigid, bed, 1, 1.0, 10.0);
    run.to(10.0);
    over_rigid.to(10.0);
    const Snapshot waiting = run.gully.snapshot();
    EXPECT_EQ(waiting.bed(20, 1), 0.05);
    EXPECT_EQ(run.number("eroded_volume"), 0.0);
    EXPECT_EQ(run.number("bed_time"), 0.0);
    EXPECT_EQ(run.number("water_volume"), over_rigid.number("water_volume"));
    run.to(20.0);
    EXPECT_GT(run.number("eroded_volume"), 0.0);
    EXPECT_DOUBLE_EQ(run.number("bed_time"), factor * 10.0);
    EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12);
}

TEST(LoadPhysics, GrainsThatComeIntoALakeMakeADelta) {
    GullyParameters gully = WaterParameters();
    gully.transport = SedimentTransport::loads;
    gully.friction = FrictionLaw::manning;
    gully.initial_water = InitialWater::surface;
    gully.surface = 1.0;
    gully.time_step = 2.0;
    gully.loads.bed_load = BedLoadLaw::none;
    gully.loads.settling_velocity = {"", 0.02};
    gully.loads.inflow_concentration = 0.01;
    gully.loads.morphological_factor = 10.0;
    EdgeSettings inlet = edge(GridSide::north, EdgeFlow::discharge, 2.0);
    inlet.from = 24.0;
    inlet.to = 36.0;
    gully.edges = {inlet, edge(GridSide::south, EdgeFlow::level, 1.0)};
    GullyRun run(gully, Grid(20, 30), 1, 3.0, 3.0);
    run.to(600.0);
    const double factor = 10.0 / 0.6;
    const double entered = run.number("grains_entered_volume");
    const double suspended = run.number("suspended_volume");
    const double left = run.number("grains_left_volume");
    const double settled = run.number("deposited_volume");
    EXPECT_NEAR(entered, 2.0 * 0.01 * 600.0, 0.01) << "with a little of waves at the lake's end";
    EXPECT_EQ(run.number("eroded_volume"), 0.0);
    EXPECT_NEAR(factor * (entered - suspended - left), settled, 1e-12 * settled);
    EXPECT_GT(settled, 0.9 * factor * entered);
    const Grid bed = run.gully.snapshot().bed;
    EXPECT_GT(bed(9, 29), 0.1);
    for (int y = 20; y < 29; ++y) EXPECT_LT(bed(9, y), bed(9, y + 1));
    EXPECT_LT(bed(9, 5), 0.2 * bed(9, 29)) << "far out";
    EXPECT_NEAR(bed(9, 25), bed(10, 25), 1e-9) << "alike on both sides";
}

/// How a film from noise cuts a periodic plane that descends so many degrees east of south.
struct CutPlane {
    double eroded = 0.0;     ///< m³
    double deviation = 0.0;  ///< of the bed, m
    double across = 0.0;     ///< degrees from east toward north: of the steepest changes
};
CutPlane cut_plane(double degrees, std::uint64_t seed) {
    const double angle = degrees * std::numbers::pi / 180.0;
    GullyParameters gully = WaterParameters();
    gully.transport = SedimentTransport::loads;
    gully.friction = FrictionLaw::manning;
    gully.manning = 0.05;
    gully.edges_x = gully.edges_y = EdgeKind::periodic;
    gully.slope = {"", 0.03 * std::cos(angle)};
    gully.slope_x = 0.03 * std::sin(angle);
    gully.initial_water = InitialWater::film;
    gully.depth = 0.02;
    gully.time_step = 1.0;
    gully.loads.bed_load = BedLoadLaw::none;
    gully.loads.entrainment = EntrainmentLaw::excess_shear;
    gully.loads.entrainment_stress = 4.0;
    gully.loads.entrainment_rate = 0.005;
    gully.loads.settling_velocity = {"", 0.0005};
    gully.loads.morphological_factor = 100.0;
    gully.bed_diffusion = {"", 1e-5};
    constexpr int n = 64;
    GullyRun run(gully, noise(n, n, 0.01, seed), 1, 0.25, 0.25);
    run.to(60.0);
    const Grid bed = run.gully.snapshot().bed;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    double mean = 0.0;
    double square = 0.0;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double zx = bed((x + 1) % n, y) - bed((x + n - 1) % n, y);
            const double zy = bed(x, (y + 1) % n) - bed(x, (y + n - 1) % n);
            xx += zx * zx;
            yy += zy * zy;
            xy += zx * zy;
            mean += bed(x, y) / (n * n);
            square += bed(x, y) * bed(x, y) / (n * n);
        }
    }
    return {run.number("eroded_volume"), std::sqrt(square - mean * mean),
            0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi};
}

TEST(LoadPhysics, APlaneTurnedByThirtyDegreesIsCutAlike) {
    CutPlane straight;
    CutPlane turned;
    for (const std::uint64_t seed : {1U, 2U}) {
        const CutPlane a = cut_plane(0.0, seed);
        const CutPlane b = cut_plane(30.0, seed);
        straight.eroded += a.eroded / 2.0;
        straight.deviation += a.deviation / 2.0;
        straight.across += a.across / 2.0;
        turned.eroded += b.eroded / 2.0;
        turned.deviation += b.deviation / 2.0;
        turned.across += b.across / 2.0;
    }
    EXPECT_NEAR(turned.eroded, straight.eroded, 0.03 * straight.eroded);
    EXPECT_NEAR(turned.deviation, straight.deviation, 0.1 * straight.deviation);
    EXPECT_NEAR(straight.across, 0.0, 3.0) << "channels run down the slope";
    EXPECT_NEAR(turned.across, 30.0, 3.0);
}

TEST(LoadPhysics, SettlingVelocityIsThatOfFergusonAndChurch) {
    LoadParameters loads;
    loads.grain_size = 0.01;  // Stokes: R g d² / 18 ν
    EXPECT_NEAR(settling_velocity(loads, 9.8), 1.65 * 9.8 * 1e-10 / 18e-6, 1e-6);
    loads.grain_size = 10.0;  // turbulent: √(R g d / 0.75)
    EXPECT_NEAR(settling_velocity(loads, 9.8), std::sqrt(1.65 * 9.8 * 0.01 / 0.75), 0.01);
    loads.settling_velocity = {"", 0.3};
    EXPECT_EQ(settling_velocity(loads, 9.8), 0.3);
}

}  // namespace
}  // namespace fumon::test
