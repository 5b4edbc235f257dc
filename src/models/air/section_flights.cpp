#include "models/air/section_flights.h"

#include <fmt/format.h>

#include <algorithm>

namespace fumon {

namespace {

constexpr double millimetres_per_metre = 1e3;

void add_curves(SnapshotSection& section, const std::vector<double>& angles,
                const std::vector<Flight>& flights) {
    auto flight = flights.begin();
    for (const double angle : angles) {
        SectionCurve curve{fmt::format("flight_length_{:g}", angle),
                           fmt::format("flight length of grains launched at {:g} degrees", angle),
                           "m",
                           {}};
        const auto columns = flights.size() / angles.size();
        for (std::size_t i = 0; i < columns; ++i) curve.values.push_back((flight++)->length);
        section.curves.push_back(std::move(curve));
    }
}

bool by_height(const Flight& a, const Flight& b) {
    return a.height < b.height;
}

}  // namespace

std::vector<HopPoint> hop_points(std::span<const Flight> flights) {
    std::vector<HopPoint> points;
    points.reserve(flights.size());
    const auto lowest = std::min_element(flights.begin(), flights.end(), by_height);
    for (const Flight& flight : flights) {
        points.push_back({millimetres_per_metre * (flight.height - lowest->height), flight.slope,
                          millimetres_per_metre * flight.length});
    }
    return points;
}

std::vector<SnapshotNumber> add_flights(SnapshotSection& section,
                                        const FlightParameters& parameters, const Air& air,
                                        WorkerPool& pool) {
    const GrainFlights grains(section, parameters, air, pool);
    const std::vector<Flight> flights = grains.fly(grains.every_column(parameters.launch_angles));
    add_curves(section, parameters.launch_angles, flights);
    const auto columns =
        static_cast<std::int64_t>(flights.size() / parameters.launch_angles.size());
    for (const double angle : parameters.launch_angles) {
        for (std::int64_t n = 0; n < parameters.shown_paths; ++n) {
            const std::int64_t column = n * columns / parameters.shown_paths;
            section.paths.push_back(grains.path({static_cast<double>(column) * section.dx, angle}));
        }
    }
    const auto [low, high] = std::minmax_element(flights.begin(), flights.end(), by_height);
    std::vector<SnapshotNumber> numbers;
    if (high->height > low->height) {
        const std::vector<HopPoint> points = hop_points(flights);
        const ExponentialLaw law = fit_exponential(points);
        numbers.push_back({"hop_base", "per mm", law.base});
        numbers.push_back({"hop_r_squared", "1", law.r_squared});
        numbers.push_back({"hop_line_r_squared", "1", fit_linear(points).r_squared});
    }
    const auto fastest =
        std::max_element(flights.begin(), flights.end(),
                         [](const Flight& a, const Flight& b) { return a.reynolds < b.reynolds; });
    numbers.push_back({"largest_grain_reynolds", "1", fastest->reynolds});
    return numbers;
}

}  // namespace fumon
