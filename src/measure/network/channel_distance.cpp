#include "measure/network/channel_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "measure/shared/undefined.h"

namespace fumon {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The distance along a row to the nearest channel; infinite where the row has none.
void distances_in_row(const Field<std::uint8_t>& channels, int y, double dx, bool wraps_x,
                      Grid& distances) {
    const int nx = channels.nx();
    const int cells = wraps_x ? 2 * nx : nx;  // a second round knows what lies across the edge
    for (const int way : {1, -1}) {
        double since = infinite;
        for (int i = 0; i < cells; ++i) {
            const int x = way > 0 ? i % nx : nx - 1 - i % nx;
            since = channels(x, y) != 0 ? 0.0 : since + dx;
            distances(x, y) = std::min(distances(x, y), since);
        }
    }
}

/// The least of (y − i)²·dy² + squares[i] over i, for each y.
class Envelope {
  public:
    Envelope(const std::vector<double>& squares, double dy) : squares_(squares), dy_(dy) {
        for (std::size_t i = 0; i < squares.size(); ++i) {
            if (squares[i] == infinite) continue;
            while (!lowest_.empty() && crossing(lowest_.back(), i) <= from_.back()) {
                lowest_.pop_back();
                from_.pop_back();
            }
            from_.push_back(lowest_.empty() ? -infinite : crossing(lowest_.back(), i));
            lowest_.push_back(i);
        }
    }

    /// For ever larger y; there must be one finite square.
    double at(double y) {
        while (place_ + 1 < lowest_.size() && from_[place_ + 1] <= y) ++place_;
        const double off = (y - static_cast<double>(lowest_[place_])) * dy_;
        return off * off + squares_[lowest_[place_]];
    }
    [[nodiscard]] bool empty() const { return lowest_.empty(); }

  private:
    /// The y from which the later of two parabolas is the lower one.
    [[nodiscard]] double crossing(std::size_t i, std::size_t later) const {
        const auto a = static_cast<double>(i);
        const auto b = static_cast<double>(later);
        return 0.5 * ((squares_[later] - squares_[i]) / (dy_ * dy_ * (b - a)) + a + b);
    }

    const std::vector<double>& squares_;
    double dy_;
    std::vector<std::size_t> lowest_;
    std::vector<double> from_;
    std::size_t place_ = 0;
};

}  // namespace

double mean_channel_distance(const Field<std::uint8_t>& channels, const Mask& nodata, double dx,
                             double dy, bool wraps_x) {
    Grid along(channels.nx(), channels.ny(), infinite);
    for (int y = 0; y < channels.ny(); ++y) distances_in_row(channels, y, dx, wraps_x, along);
    double sum = 0.0;
    std::int64_t cells = 0;
    std::vector<double> squares(static_cast<std::size_t>(channels.ny()));
    for (int x = 0; x < channels.nx(); ++x) {
        for (int y = 0; y < channels.ny(); ++y)
            squares[static_cast<std::size_t>(y)] = along(x, y) * along(x, y);
        Envelope envelope(squares, dy);
        if (envelope.empty()) return undefined;  // no row has a channel
        for (int y = 0; y < channels.ny(); ++y) {
            const double square = envelope.at(y);
            if (!nodata.empty() && nodata(x, y) != 0) continue;
            sum += std::sqrt(square);
            ++cells;
        }
    }
    return sum / static_cast<double>(cells);
}

}  // namespace fumon
