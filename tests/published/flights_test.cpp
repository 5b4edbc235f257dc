// Terada 2025: grains that fly in computed air, the hop law fitted to them, and the ripples that
// sand makes by it. Expected numbers are those of independent programs where the thesis's own are
// rounded or depend on its missing page.

#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <string>

#include "base/worker_pool.h"
#include "models/air/airflow.h"
#include "models/air/grain_flight.h"
#include "models/air/section_flights.h"
#include "numerics/hop_law.h"
#include "published/sweep_table.h"
#include "support/program.h"
#include "support/snapshot_number.h"

namespace fumon::test {
namespace {

/// Table 3 with its cosine, or of its height a flat bed at 2 h0 (appendix B).
ModelSetup box(int nx, WorkerPool& pool) {
    constexpr double spacing = 2.5e-5;
    return {Grid(nx, 1), {}, {spacing, spacing, 1.0, true}, 1, pool};
}

AirflowParameters air_of_table_3() {
    AirflowParameters parameters;
    parameters.nz = 60;
    parameters.time_step = 2.5e-6;
    parameters.flight.flights = true;
    return parameters;
}

/// Section 4 finds a = 5.4 per mm, and an exponential better than a line.
TEST(PublishedFlights, TheHopLawOfTable3) {
    WorkerPool pool;
    Airflow model(air_of_table_3(), box(1200, pool));
    for (int n = 0; n < 2000; ++n) model.step();
    const Snapshot snapshot = model.snapshot();
    expect_within(number(snapshot, "hop_base"), 5.19, 0.03, "a of all angles");
    EXPECT_NEAR(number(snapshot, "hop_r_squared"), 0.729, 0.01);
    EXPECT_NEAR(number(snapshot, "hop_line_r_squared"), 0.711, 0.01);
    EXPECT_GE(number(snapshot, "largest_grain_reynolds"), 9.0);
    EXPECT_LT(number(snapshot, "largest_grain_reynolds"), 10.0);

    const std::vector<Flight> flights = model.fly_grains(1);
    ASSERT_EQ(flights.size(), 4800U);
    const auto base_of_angle = [&](std::size_t n) {
        return fit_exponential(hop_points(std::span(flights).subspan(n * 1200, 1200))).base;
    };
    expect_within(base_of_angle(0), 2.55, 0.03, "a at 10 degrees");
    expect_within(base_of_angle(2), 6.61, 0.03, "a at 30 degrees");
}

/// Table B1: 0.98, 1.5 and 1.4 mm; in closed form (eqs. B6, B8) 0.9788, 1.5231 and 1.4260 mm.
TEST(PublishedFlights, OverTheFlatBedOfAppendixB) {
    WorkerPool pool;
    AirflowParameters parameters = air_of_table_3();
    parameters.nz = 40;  // what is left of table 3's box above 2 h0
    parameters.bed = AirBedShape::given;
    parameters.flight.launch_angles = {20.0, 40.0, 60.0};
    Airflow model(parameters, box(400, pool));
    for (int n = 0; n < 10; ++n) model.step();
    for (const Flight& flight : model.fly_grains(1)) {
        const double expected = flight.angle == 20.0   ? 0.9788e-3
                                : flight.angle == 40.0 ? 1.5231e-3
                                                       : 1.4260e-3;
        EXPECT_NEAR(flight.length, expected, 0.003 * expected) << flight.angle << " degrees";
    }
}

/// Section 5: sand that hops by the measured law makes ripples; with the thesis's a = 5.4 their
/// wavelength at step 300 is 7.23 sites.
TEST(PublishedFlights, TheMeasuredLawMakesRipples) {
    const ScratchFolder folder;
    const std::string scene = std::string(FUMON_SCENES_FOLDER) + "/terada-hop-law.toml";
    const std::string law = (folder / "law.toml").string();
    const Ended measured =
        fumon({"hop-law", scene, "-o", law, "-q", "--set", "model.flights=false"}, folder.path());
    ASSERT_EQ(measured.status, 0) << measured.errors;
    const SweepTable table({law, {}, {"output.fields_at=[]", "frames.at=[300]"}});
    expect_within(table.mean("wavelength_spectrum"), 7.23, 0.04, "wavelength of the ripples");
    expect_within(table.mean("standard_deviation"), 0.196, 0.04, "standard deviation of the bed");
}

}  // namespace
}  // namespace fumon::test
