// Terada 2025: the stress of the air on its cosine beds, as published and steady.

#include "models/air/airflow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/worker_pool.h"
#include "support/snapshot_number.h"

namespace fumon::test {
namespace {

struct Box {
    int nx;
    int nz;
    double spacing;
    double time_step;
};

AirflowParameters in(const Box& box) {
    AirflowParameters parameters;
    parameters.nz = box.nz;
    parameters.time_step = box.time_step;
    return parameters;
}

ModelSetup over(const Box& box, WorkerPool& pool) {
    return {Grid(box.nx, 1), {}, {box.spacing, box.spacing, 1.0, true}, 1, pool};
}

constexpr Box table_c1{500, 150, 1e-5, 1e-6};
constexpr Box table_3{1200, 60, 2.5e-5, 2.5e-6};

TEST(PublishedAirflow, StressOfTableC1) {
    WorkerPool pool;
    Airflow model(in(table_c1), over(table_c1, pool));
    for (int n = 0; n < 5000; ++n) model.step();
    EXPECT_NEAR(number(model.snapshot(), "stress_mean"), 0.00949, 0.02 * 0.00949);
    EXPECT_NEAR(number(model.snapshot(), "stress_amplitude"), 0.01278, 0.02 * 0.01278);
    EXPECT_NEAR(number(model.snapshot(), "stress_phase"), std::numbers::pi / 14.2,
                0.02 * std::numbers::pi / 14.2);  // appendix C's own number
}

/// Section 3.4: "a positive correlation" of stress and height.
TEST(PublishedAirflow, StressOfTable3RisesWithTheBed) {
    WorkerPool pool;
    Airflow model(in(table_3), over(table_3, pool));
    for (int n = 0; n < 2000; ++n) model.step();
    EXPECT_GT(number(model.snapshot(), "stress_amplitude"),
              0.5 * number(model.snapshot(), "stress_mean"));
    EXPECT_LT(std::abs(number(model.snapshot(), "stress_phase")), std::numbers::pi / 6.0);
}

/// Table C1's geometry on coarser staircases: the steady state, from an independent spectral
/// solver, is a3 = 0.01185 Pa, a1 = 0.01665 Pa, a2 = π/11.08. What the staircase lacks of amplitude
/// and phase shrinks with the spacing.
TEST(PublishedAirflow, SteadyStressOnAStaircase) {
    WorkerPool pool;
    const auto fit = [&](const Box& box) {
        AirflowParameters parameters = in(box);
        parameters.until_steady = true;
        Airflow model(parameters, over(box, pool));
        for (int n = 0; n < 20'000; ++n) model.step();
        EXPECT_EQ(number(model.snapshot(), "steady"), 1.0);
        EXPECT_GT(number(model.snapshot(), "steady_time"), 0.045);
        EXPECT_LT(number(model.snapshot(), "steady_time"), 0.080);
        StressFit reached;
        reached.amplitude = number(model.snapshot(), "stress_amplitude");
        reached.phase = number(model.snapshot(), "stress_phase");
        reached.mean = number(model.snapshot(), "stress_mean");
        return reached;
    };
    const StressFit coarse = fit({100, 30, 5e-5, 1e-5});
    const StressFit fine = fit({250, 75, 2e-5, 4e-6});
    const double phase = std::numbers::pi / 11.08;
    EXPECT_NEAR(fine.mean, 0.01185, 0.02 * 0.01185);
    EXPECT_LT(std::abs(fine.amplitude - 0.01665), 0.7 * std::abs(coarse.amplitude - 0.01665));
    EXPECT_LT(std::abs(fine.phase - phase), 0.7 * std::abs(coarse.phase - phase));
}

TEST(PublishedAirflow, SteadyStressOnAFittedGrid) {
    constexpr Box box{100, 30, 5e-5, 2e-5};
    WorkerPool pool;
    AirflowParameters parameters = in(box);
    parameters.until_steady = true;
    parameters.scheme = AirSchemeKind::boundary_fitted;
    Airflow model(parameters, over(box, pool));
    for (int n = 0; n < 5000; ++n) model.step();
    EXPECT_EQ(number(model.snapshot(), "steady"), 1.0);
    EXPECT_NEAR(number(model.snapshot(), "stress_mean"), 0.01185, 0.02 * 0.01185);
    EXPECT_NEAR(number(model.snapshot(), "stress_amplitude"), 0.01665, 0.02 * 0.01665);
    EXPECT_NEAR(number(model.snapshot(), "stress_phase"), std::numbers::pi / 11.08,
                0.02 * std::numbers::pi / 11.08);
}

}  // namespace
}  // namespace fumon::test
