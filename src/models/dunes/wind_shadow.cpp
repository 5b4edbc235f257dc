#include "models/dunes/wind_shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/give_up.h"
#include "base/worker_pool.h"
#include "models/dunes/shadow_vectors.h"

namespace fumon {

namespace {

constexpr double below_all_ground = -1e30;  // m

/// to(y, x) = from(x, y) for the rows [begin, end) of `to`.
template <class From, class To, class Convert>
void turn(const From& from, To& to, int begin, int end, const Convert& convert) {
    constexpr int tile = 16;
    for (int x0 = begin; x0 < end; x0 += tile) {
        give_up_if_asked();
        const int x1 = std::min(x0 + tile, end);
        for (int y0 = 0; y0 < from.ny(); y0 += tile) {
            const int y1 = std::min(y0 + tile, from.ny());
            for (int x = x0; x < x1; ++x) {
                for (int y = y0; y < y1; ++y) to(y, x) = convert(from(x, y));
            }
        }
    }
}

/// The values at `first`, first + 1 … of a row that goes on past its ends, with its other side or
/// with its last cells.
void copy_beyond(std::span<const double> row, std::int64_t first, bool periodic,
                 std::span<double> values) {
    const auto size = static_cast<std::int64_t>(row.size());
    if (!periodic) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto cell =
                std::clamp<std::int64_t>(first + static_cast<std::int64_t>(i), 0, size - 1);
            values[i] = row[static_cast<std::size_t>(cell)];
        }
        return;
    }
    std::int64_t cell = ((first % size) + size) % size;
    for (std::size_t i = 0; i < values.size();) {
        const auto many =
            std::min<std::size_t>(values.size() - i, static_cast<std::size_t>(size - cell));
        std::copy_n(row.begin() + cell, many, values.begin() + static_cast<std::ptrdiff_t>(i));
        i += many;
        cell = 0;
    }
}

}  // namespace

WindShadow::WindShadow(const DuneGround& ground, WorkerPool& pool)
    : ground_(ground),
      pool_(pool),
      shade_(ground.nx, ground.ny),
      envelope_(ground.nx, ground.ny),
      lowest_(static_cast<std::size_t>(ground.ny)),
      highest_(static_cast<std::size_t>(ground.ny)) {}

void WindShadow::cast(const WholeGrid& surface, const BlowingWind& wind,
                      const ShadowTangents& tangents, Find find) {
    const bool turned = std::abs(wind.x) / ground_.dx > std::abs(wind.y) / ground_.dy;
    take_heights(surface, turned);
    const Way way = way_of(wind, turned);
    const int lines =
        way.periodic_across
            ? way.across
            : way.across + static_cast<int>(std::ceil(std::abs(way.shift) * way.along)) + 3;
    pool_.for_ranges(lines, [&](int first, int last) { follow_lines(way, tangents, first, last); });
    give_back(turned, find);
}

WindShadow::Way WindShadow::way_of(const BlowingWind& wind, bool turned) const {
    const double cells_x = wind.x / ground_.dx;
    const double cells_y = wind.y / ground_.dy;
    Way way;
    way.across = heights_.nx();
    way.along = heights_.ny();
    way.periodic_across = turned ? ground_.periodic_y : ground_.periodic_x;
    way.periodic_along = turned ? ground_.periodic_x : ground_.periodic_y;
    const double along = turned ? cells_x : cells_y;
    const double across = turned ? cells_y : cells_x;
    way.forward = along > 0.0;
    way.shift = across / std::abs(along);
    way.distance = 1.0 / std::abs(along);
    return way;
}

void WindShadow::take_heights(const WholeGrid& surface, bool turned) {
    const int across = turned ? ground_.ny : ground_.nx;
    const int along = turned ? ground_.nx : ground_.ny;
    if (heights_.nx() != across || heights_.ny() != along) {
        heights_ = Grid(across, along);
        found_shade_ = Grid(across, along);
        found_envelope_ = Grid(across, along);
    }
    pool_.for_ranges(along, [&](int begin, int end) {
        if (turned) {
            turn(surface, heights_, begin, end, to_metres);
        } else {
            for (int y = begin; y < end; ++y)
                std::ranges::transform(surface.row(y), heights_.row(y).begin(), to_metres);
        }
    });
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const auto [low, high] = std::ranges::minmax(surface.row(y));
            lowest_[static_cast<std::size_t>(y)] = to_metres(low);
            highest_[static_cast<std::size_t>(y)] = to_metres(high);
        }
    });
}

void WindShadow::give_back(bool turned, Find find) {
    if (!turned) {
        std::swap(shade_, found_shade_);
        std::swap(envelope_, found_envelope_);
        return;
    }
    const auto as_it_is = [](double value) { return value; };
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        turn(found_shade_, shade_, begin, end, as_it_is);
        if (find == Find::shade_and_envelope)
            turn(found_envelope_, envelope_, begin, end, as_it_is);
    });
}

void WindShadow::follow_lines(const Way& way, const ShadowTangents& tangents, int first, int last) {
    // Line l is at cell l + base + shift·n of row n; of those that come in from the sides base
    // makes room. One line more lies beside the first cell.
    const double base = way.periodic_across ? 0.0
                        : way.shift > 0.0   ? -std::ceil(way.shift * way.along) - 1.0
                                            : -1.0;
    const double soft_drop = tangents.soft * way.distance;
    const shadow_vectors::Fall fall{way.distance, soft_drop, tangents.full * way.distance};
    const double relief = *std::ranges::max_element(highest_) - *std::ranges::min_element(lowest_);
    const double reach = std::min<double>(std::ceil(relief / soft_drop) + 1.0, way.along);
    const int before = way.periodic_along ? static_cast<int>(reach) : 0;

    const int count = last - first + 1;
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> soft(size, below_all_ground);
    std::vector<double> full(size, below_all_ground);
    std::vector<double> since(size);
    std::vector<double> heights(size + 1);
    std::vector<double> shade(size);
    std::vector<double> envelope(size);
    const shadow_vectors::Lines lines{soft.data(), full.data(), since.data(), count};
    for (int n = -before; n < way.along; ++n) {
        give_up_if_asked();
        const double at = base + way.shift * n;
        const double cell = std::floor(at);
        const std::int64_t from = first - 1 + static_cast<std::int64_t>(cell);
        const int going = ((n % way.along) + way.along) % way.along;
        const int row = way.forward ? going : way.along - 1 - going;
        copy_beyond(heights_.row(row), from, way.periodic_across, heights);
        const shadow_vectors::Between between{heights.data(), at - cell};
        shadow_vectors::fall(lines, fall);
        if (n >= 0) {
            shadow_vectors::shade(lines, between, tangents.full - tangents.soft, shade.data(),
                                  envelope.data());
            const auto shade_row = found_shade_.row(row);
            const auto envelope_row = found_envelope_.row(row);
            for (int i = 0; i + 1 < count;) {
                std::int64_t to = from + 1 + i;
                if (way.periodic_across) {
                    to = ((to % way.across) + way.across) % way.across;
                } else if (to < 0 || to >= way.across) {
                    i = to < 0 ? static_cast<int>(std::min<std::int64_t>(i - to, count)) : count;
                    continue;
                }
                const auto many = std::min<std::int64_t>(count - 1 - i, way.across - to);
                std::copy_n(shade.begin() + i, many, shade_row.begin() + to);
                std::copy_n(envelope.begin() + i, many, envelope_row.begin() + to);
                i += static_cast<int>(many);
            }
        }
        shadow_vectors::lift(lines, between);
    }
}

}  // namespace fumon
