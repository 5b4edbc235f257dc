#include "measure/bed/row_waves.h"

#include <cmath>
#include <cstddef>

namespace fumon {

namespace {

bool ends_armed(std::span<const double> departures, double threshold) {
    for (std::size_t x = departures.size(); x-- > 0;) {
        if (departures[x] > threshold) return false;
        if (departures[x] < -threshold) return true;
    }
    return false;
}

}  // namespace

void find_upward_crossings(std::span<const double> departures, bool periodic,
                           std::vector<int>& sites) {
    sites.clear();
    double squares = 0.0;
    for (const double height : departures) squares += height * height;
    if (squares == 0.0) return;
    const double threshold = 0.5 * std::sqrt(squares / static_cast<double>(departures.size()));
    bool armed = periodic && ends_armed(departures, threshold);
    for (std::size_t x = 0; x < departures.size(); ++x) {
        if (departures[x] < -threshold) {
            armed = true;
        } else if (armed && departures[x] > threshold) {
            armed = false;
            sites.push_back(static_cast<int>(x));
        }
    }
}

}  // namespace fumon
