#include "models/air/airflow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/registry.h"

namespace fumon {
namespace {

constexpr double table_2_spacing = 5e-5;

struct AirRun {
    AirRun(const AirflowParameters& parameters, const Grid& bed, double spacing = table_2_spacing,
           int threads = 1)
        : pool(threads), model(parameters, {bed, {}, {spacing, spacing, 1.0, true}, 1, pool}) {}
    void step(int count) {
        for (int n = 0; n < count; ++n) model.step();
    }
    [[nodiscard]] double number(const std::string& name) const {
        for (const SnapshotNumber& one : model.snapshot().numbers) {
            if (one.name == name) return one.value;
        }
        return std::numeric_limits<double>::quiet_NaN();
    }
    WorkerPool pool;
    Airflow model;
};

std::vector<double> copied(const StateField& field) {
    return {field.values.begin(), field.values.end()};
}

/// Ripples that are no cosine: a row whose slopes differ on both sides.
Grid asymmetric_bed(int nx, double height, int shift = 0) {
    Grid bed(nx, 1);
    for (int i = 0; i < nx; ++i) {
        const double turn = 2.0 * std::numbers::pi * ((i + shift) % nx) / nx;
        bed(i, 0) = height * (1.0 + std::cos(turn) + 0.3 * std::sin(2.0 * turn));
    }
    return bed;
}

// ---- Terada 2025, table 2 ----

TEST(Airflow, MeetsTheStressOfTable2) {
    AirRun run({}, Grid(100, 1));
    run.step(1000);
    EXPECT_NEAR(run.number("stress_mean"), 0.00951, 0.02 * 0.00951);
    EXPECT_NEAR(run.number("stress_amplitude"), 0.01124, 0.02 * 0.01124);
    EXPECT_GT(run.number("stress_phase"), 0.0);  // the stress is largest upwind of the crest
    EXPECT_DOUBLE_EQ(run.model.time(), 1000 * 5e-6);
    EXPECT_EQ(run.number("steady"), 0.0);  // not yet, whatever eq. 36 says
}

// ---- exact solutions ----

TEST(Airflow, KeepsCouetteFlowOverALevelBed) {
    AirflowParameters parameters;
    parameters.bed = AirBedShape::given;
    AirRun run(parameters, Grid(16, 1));
    run.step(200);
    const Snapshot snapshot = run.model.snapshot();
    const auto lid = static_cast<double>(parameters.nz);
    for (int k = 0; k < parameters.nz; ++k) {
        EXPECT_NEAR(snapshot.section->fields[0].values(3, k), k / lid, 1e-12);
        EXPECT_NEAR(snapshot.section->fields[1].values(3, k), 0.0, 1e-12);
    }
    const double stress = parameters.density * parameters.viscosity / (lid * table_2_spacing);
    EXPECT_NEAR(run.number("stress_mean"), stress, 1e-9 * stress);
    EXPECT_LT(run.number("largest_divergence"), 1e-6);
}

TEST(Airflow, RestsUnderALidAtRest) {
    AirflowParameters parameters;
    parameters.lid_speed = 0.0;
    AirRun run(parameters, Grid(100, 1));
    run.step(20);
    for (const StateField& field : run.model.state()) {
        for (const double value : field.values) ASSERT_EQ(value, 0.0) << field.name;
    }
}

TEST(Airflow, MovesWithTheBed) {
    constexpr int nx = 60;
    constexpr int shift = 17;
    AirflowParameters parameters;
    parameters.bed = AirBedShape::given;
    AirRun here(parameters, asymmetric_bed(nx, 1e-4));
    AirRun there(parameters, asymmetric_bed(nx, 1e-4, shift));
    here.step(100);
    there.step(100);
    const auto section = here.model.snapshot().section;
    const auto shifted = there.model.snapshot().section;
    for (int i = 0; i < nx; ++i) {
        for (int k = 0; k < parameters.nz; ++k) {
            for (const std::size_t field : {0U, 1U}) {
                ASSERT_NEAR(section->fields[field].values((i + shift) % nx, k),
                            shifted->fields[field].values(i, k), 1e-10);
            }
        }
    }
}

TEST(Airflow, LosesLittleMass) {
    AirRun run({}, Grid(100, 1));
    run.step(1000);
    // Velocities differ by up to 1 m/s over a cell: 20,000 1/s.
    EXPECT_LT(run.number("largest_divergence"), 0.01 / table_2_spacing);
}

// ---- the steady state ----

TEST(Airflow, HoldsASteadyFlow) {
    AirflowParameters parameters;
    parameters.until_steady = true;
    parameters.steady_tolerance = 0.01;
    AirRun run(parameters, Grid(100, 1));
    run.step(20'000);
    ASSERT_EQ(run.number("steady"), 1.0);
    const double reached = run.number("steady_time");
    EXPECT_EQ(run.model.time(), reached);
    EXPECT_LT(reached, 0.09);
    const std::vector<double> before = copied(run.model.state()[0]);
    run.step(10);
    EXPECT_EQ(copied(run.model.state()[0]), before);
    EXPECT_EQ(run.model.steps_done(), 20'010);
}

// ---- second order ----

/// The staircase disturbs both alike, so the upward velocity is compared above the crests.
TEST(Airflow, SecondOrderIsNearerToAFinerGrid) {
    const auto flow = [](AirAdvection advection, int refinement) {
        AirflowParameters parameters;
        parameters.advection = advection;
        parameters.nz = 30 * refinement;
        parameters.time_step = 5e-6 / (refinement * refinement);
        AirRun run(parameters, Grid(100 * refinement, 1), table_2_spacing / refinement);
        run.step(600 * refinement * refinement);
        return run.model.snapshot().section->fields[1].values;
    };
    const Grid reference = flow(AirAdvection::second_order, 2);
    const auto error = [&](AirAdvection advection) {
        const Grid w = flow(advection, 1);
        double sum = 0.0;
        for (int i = 0; i < w.nx(); ++i) {
            for (int k = 15; k < w.ny(); ++k) sum += std::pow(w(i, k) - reference(2 * i, 2 * k), 2);
        }
        return sum;
    };
    EXPECT_LT(error(AirAdvection::second_order), error(AirAdvection::upwind));
}

// ---- the fitted grid ----

/// Table 2's box has the geometry of table C1. The reference is the steady state of an independent
/// spectral solver: a3 0.01185 Pa, a1 0.01665 Pa, a2 π/11.08.
TEST(FittedAirflow, NearsTheSmoothBedsStressUnderRefinement) {
    const auto error = [](int refinement) {
        AirflowParameters parameters;
        parameters.scheme = AirSchemeKind::boundary_fitted;
        parameters.until_steady = true;
        parameters.nz = 6 * refinement;
        parameters.time_step = 2e-5;
        AirRun run(parameters, Grid(20 * refinement, 1), 2.5e-4 / refinement);
        for (int n = 0; n < 4000 && run.number("steady") == 0.0; n += 100) run.step(100);
        EXPECT_EQ(run.number("steady"), 1.0);
        return std::max(std::abs(run.number("stress_mean") / 0.01185 - 1.0),
                        std::abs(run.number("stress_amplitude") / 0.01665 - 1.0));
    };
    const double coarse = error(1);
    const double medium = error(2);
    const double fine = error(4);
    EXPECT_LT(medium, 0.5 * coarse);
    EXPECT_LT(fine, medium);
    EXPECT_LT(fine, 0.02);
}

TEST(FittedAirflow, KeepsCouetteFlowOverALevelBed) {
    AirflowParameters parameters;
    parameters.bed = AirBedShape::given;
    parameters.scheme = AirSchemeKind::boundary_fitted;
    AirRun run(parameters, Grid(16, 1));
    run.step(50);
    const Snapshot snapshot = run.model.snapshot();
    for (int k = 0; k < parameters.nz; ++k) {
        EXPECT_NEAR(snapshot.section->fields[0].values(3, k), k / 30.0, 1e-9);
        EXPECT_NEAR(snapshot.section->fields[1].values(3, k), 0.0, 1e-9);
        EXPECT_NEAR(snapshot.section->fields[2].values(3, k), 0.0, 1e-7);
    }
}

/// Two schemes that share no equation: pressures and velocities in the middle of the gap.
TEST(FittedAirflow, AgreesWithTheStaircase) {
    AirflowParameters parameters;
    AirRun stairs(parameters, Grid(100, 1));
    parameters.scheme = AirSchemeKind::boundary_fitted;
    AirRun fitted(parameters, Grid(100, 1));
    stairs.step(1000);
    fitted.step(1000);
    const auto a = stairs.model.snapshot().section;
    const auto b = fitted.model.snapshot().section;
    const auto difference = [&](std::size_t field) {
        const Grid& one = a->fields[field].values;
        const Grid& other = b->fields[field].values;
        double squares = 0.0;
        double all = 0.0;
        for (int i = 0; i < one.nx(); ++i) {
            const double shift = other(0, 20) - one(0, 20);
            const double constant = field == 2 ? shift : 0.0;  // the pressure's is free
            squares += std::pow(other(i, 20) - one(i, 20) - constant, 2);
            all += std::pow(one(i, 20) - (field == 2 ? one(0, 20) : 0.0), 2);
        }
        return std::sqrt(squares / all);
    };
    EXPECT_LT(difference(0), 0.05);
    EXPECT_LT(difference(1), 0.15);
    EXPECT_LT(difference(2), 0.15);
}

// ---- threads ----

TEST(Airflow, GivesTheSameBytesOnAnyNumberOfThreads) {
    AirflowParameters parameters;
    parameters.nz = 120;
    parameters.time_step = 1e-6;
    AirRun one(parameters, Grid(400, 1), 1.25e-5, 1);
    AirRun three(parameters, Grid(400, 1), 1.25e-5, 3);
    one.step(5);
    three.step(5);
    const auto fields = one.model.state();
    const auto others = three.model.state();
    for (std::size_t n = 0; n < fields.size(); ++n) EXPECT_EQ(copied(fields[n]), copied(others[n]));
}

// ---- what is refused ----

struct Refused {
    std::string key;
    AirflowParameters parameters;
    Grid bed;
};

class RefusedAir : public testing::TestWithParam<Refused> {};

TEST_P(RefusedAir, NamesItsKey) {
    const Refused& wrong = GetParam();
    try {
        const AirRun run(wrong.parameters, wrong.bed);
        FAIL() << "nothing was refused";
    } catch (const KeyError& error) {
        EXPECT_EQ(error.key(), wrong.key) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

AirflowParameters with(void (*change)(AirflowParameters&)) {
    AirflowParameters parameters;
    change(parameters);
    return parameters;
}

Grid step_bed() {
    Grid bed(20, 1);
    bed(5, 0) = 3 * table_2_spacing;
    return bed;
}

std::vector<Refused> refused_air() {
    std::vector<Refused> cases;
    const auto add = [&](const char* key, void (*change)(AirflowParameters&), Grid bed) {
        cases.push_back({key, with(change), std::move(bed)});
    };
    const Grid level(100, 1);
    add(
        "model.time_step", [](auto& air) { air.time_step = 5e-5; }, level);
    add(
        "model.time_step", [](auto& air) { air.viscosity = 2e-4; }, level);
    add(
        "model.nz", [](auto& air) { air.nz = 12; }, level);
    add(
        "model.nz", [](auto& air) { air.nz = 8; }, level);
    add(
        "model.bed_amplitude", [](auto& air) { air.bed_waves = 4; }, level);
    const auto no_angles = [](AirflowParameters& air) {
        air.flight.flights = true;
        air.flight.launch_angles.clear();
    };
    add("model.launch_angles", no_angles, level);
    const auto many_waves = [](AirflowParameters& air) {
        air.bed_waves = 50;
        air.bed_amplitude = 0.0;
    };
    add("model.bed_waves", many_waves, level);
    const auto far_row = [](AirflowParameters& air) {
        air.bed_row = 2;
        air.bed = AirBedShape::given;
    };
    add("model.bed_row", far_row, Grid(100, 2));
    add(
        "bed.kind", [](auto& /*air*/) {}, step_bed());
    add(
        "grid.nx", [](auto& /*air*/) {}, Grid(3, 1));
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Airflow, RefusedAir, testing::ValuesIn(refused_air()));

TEST(Airflow, SaysWhereTheExtrapolatedPressureBlowsUp) {
    AirflowParameters parameters;
    parameters.bed_pressure = BedPressure::extrapolated;
    AirRun run(parameters, Grid(100, 1));
    try {
        run.step(1000);
        FAIL() << "it did not blow up";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("one-sided"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace fumon
