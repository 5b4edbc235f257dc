#include "hop_law/flight_table.h"

#include <fmt/format.h>

#include <iterator>

namespace fumon {

std::string flight_table(std::span<const Flight> flights) {
    std::string text = "x,height,slope,angle,length,time,reynolds\n";
    for (const Flight& flight : flights) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", flight.x, flight.height,
                       flight.slope, flight.angle, flight.length, flight.time, flight.reynolds);
    }
    return text;
}

}  // namespace fumon
