#include "figure/ground/stream_lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/grid.h"
#include "measure/network/channel_network.h"
#include "measure/network/flow_routing.h"

namespace fumon {

namespace {

constexpr double streams_of_ground = 500.0;
constexpr int smoothings = 2;

double area_of(const Snapshot& snapshot) {
    double cells = 0.0;
    if (snapshot.nodata.empty()) {
        cells = static_cast<double>(snapshot.bed.size());
    } else {
        for (const auto outside : snapshot.nodata.values()) cells += outside == 0 ? 1.0 : 0.0;
    }
    return cells * snapshot.scale.dx * snapshot.scale.dy;
}

BedPlace place_of(std::int32_t cell, int nx, int ny) {
    const std::int32_t row = cell / nx;
    return {(cell % nx + 0.5) / nx, (row + 0.5) / ny};
}

/// A line whose points are means of three; its ends stay.
std::vector<BedPlace> smoothed(std::vector<BedPlace> line) {
    for (int pass = 0; pass < smoothings; ++pass) {
        const std::vector<BedPlace> before = line;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                line[i][axis] =
                    0.25 * before[i - 1][axis] + 0.5 * before[i][axis] + 0.25 * before[i + 1][axis];
            }
        }
    }
    return line;
}

/// Whether water crosses from the western edge to the eastern one between two cells.
bool goes_round(std::int32_t from, std::int32_t to, int nx) {
    const int columns = from % nx - to % nx;
    return columns > 1 || columns < -1;
}

}  // namespace

std::vector<StreamLine> stream_lines(const Snapshot& snapshot, double channel_area) {
    const FlowRouting routing = route_flow(snapshot);
    const double least = channel_area > 0.0 ? channel_area : area_of(snapshot) / streams_of_ground;
    const ChannelNetwork network = channel_network(routing, drainage_area(routing), least);
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    const auto order = [&](std::int32_t cell) {
        return static_cast<int>(network.order.values()[static_cast<std::size_t>(cell)]);
    };
    const auto below = [&](std::int32_t cell) {
        return routing.receiver.values()[static_cast<std::size_t>(cell)];
    };
    // Of each cell, whether a stream of its own order comes in: a stream's first cell has none.
    Field<std::uint8_t> continued(nx, ny);
    for (const std::int32_t cell : routing.upward) {
        const std::int32_t next = below(cell);
        if (order(cell) > 0 && next != FlowRouting::outlet && order(next) == order(cell))
            continued.values()[static_cast<std::size_t>(next)] = 1;
    }
    std::vector<StreamLine> streams;
    for (const std::int32_t first : routing.upward) {
        if (order(first) == 0 || continued.values()[static_cast<std::size_t>(first)] != 0) continue;
        StreamLine stream;
        stream.order = order(first);
        const auto end_part = [&] {
            if (stream.places.size() > 1) {
                stream.places = smoothed(std::move(stream.places));
                streams.push_back(stream);
            }
            stream.places.clear();
        };
        std::int32_t cell = first;
        while (true) {
            stream.places.push_back(place_of(cell, nx, ny));
            const std::int32_t next = below(cell);
            if (next == FlowRouting::outlet) break;
            if (goes_round(cell, next, nx)) {
                end_part();
            } else if (order(next) != stream.order) {
                stream.places.push_back(place_of(next, nx, ny));
                break;
            }
            if (order(next) != stream.order) break;
            cell = next;
        }
        end_part();
    }
    return streams;
}

}  // namespace fumon
