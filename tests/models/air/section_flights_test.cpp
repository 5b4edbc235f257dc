#include "models/air/section_flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/worker_pool.h"
#include "support/couette_section.h"

namespace fumon::test {
namespace {

constexpr double spacing = 0.025e-3;

SnapshotSection wavy() {
    return couette_section(400, 61, spacing, 1.0, [](double x) {
        return 0.25e-3 * (1.0 + std::cos(628.3185307179586 * x));
    });
}

TEST(SectionFlights, AddsACurveAnAngleAndThePathsAskedFor) {
    SnapshotSection section = wavy();
    const SnapshotSection before = section;
    WorkerPool pool(2);
    FlightParameters parameters;
    parameters.launch_angles = {10.0, 37.5};
    parameters.shown_paths = 3;
    const auto numbers = add_flights(section, parameters, {}, pool);
    ASSERT_EQ(section.curves.size(), before.curves.size() + 2);
    EXPECT_EQ(section.curves[2].name, "flight_length_10");
    EXPECT_EQ(section.curves[3].name, "flight_length_37.5");
    const Launch launch{150 * spacing, 37.5};
    const Flight flight = GrainFlights(before, parameters, {}, pool).fly({&launch, 1}).front();
    ASSERT_EQ(section.curves[3].values.size(), 400U);
    EXPECT_EQ(section.curves[3].values[150], flight.length);
    ASSERT_EQ(section.paths.size(), 6U);
    EXPECT_EQ(section.paths[0].launch_angle, 10.0);
    EXPECT_EQ(section.paths[5].launch_angle, 37.5);
    EXPECT_NEAR(section.paths[5].x.front(), 266 * spacing, 1e-12);
    ASSERT_EQ(numbers.size(), 4U);
    EXPECT_EQ(numbers[0].name, "hop_base");
    EXPECT_GT(numbers[0].value, 1.0);
    EXPECT_GT(numbers[3].value, flight.reynolds * 0.5);
}

TEST(SectionFlights, AFlatBedHasNoHopLaw) {
    SnapshotSection section = couette_section(40, 61, spacing, 1.0, [](double) { return 0.5e-3; });
    WorkerPool pool(1);
    const auto numbers = add_flights(section, {}, {}, pool);
    ASSERT_EQ(numbers.size(), 1U);
    EXPECT_EQ(numbers[0].name, "largest_grain_reynolds");
    EXPECT_GT(numbers[0].value, 2.0) << "that of the launch, beyond the thesis's own limit";
}

}  // namespace
}  // namespace fumon::test
