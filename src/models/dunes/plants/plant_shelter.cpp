#include "models/dunes/plants/plant_shelter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/cancellation.h"
#include "base/elementary.h"
#include "base/error.h"
#include "base/worker_pool.h"
#include "models/dunes/plants/plants.h"
#include "models/dunes/wind/row_traversal.h"

namespace fumon {

namespace {

/// Lines that go side by side.
constexpr int lines_of_shelter = 64;

/// Of a wake less than e to the minus this is left where it is no longer followed.
constexpr double followed_lengths = 7.0;

constexpr std::size_t room_of_lines = lines_of_shelter + 2;
using OfShelterLines = std::array<double, room_of_lines>;

/// Where lines stand in a row across the wind: the first at `cell` + `beyond`.
struct LinesInRow {
    int row;
    std::int64_t cell;
    double beyond;
};

/// Calls each(i, x, y) for `count` cells from the first one on that lie on the grid.
template <class Each>
void for_each_cell(const RowTraversal& traversal, const LinesInRow& lines, int count,
                   const Each& each) {
    const std::int64_t across = traversal.across;
    std::int64_t at = lines.cell;
    if (traversal.periodic_across) at = (at % across + across) % across;
    for (int i = 0; i < count; ++i, ++at) {
        if (traversal.periodic_across && at == across) at = 0;
        if (at < 0 || at >= across) continue;
        const auto cell = static_cast<int>(at);
        each(static_cast<std::size_t>(i), traversal.turned ? lines.row : cell,
             traversal.turned ? cell : lines.row);
    }
}

}  // namespace

void check_plant_shelter(const DunesParameters& parameters) {
    if (parameters.plant_shelter == DunePlantShelter::none) return;
    if (parameters.plants == DunePlants::none) {
        throw KeyError("model.plant_shelter",
                       "there are no plants; write model.plants = \"grow\" or \"fixed\", or "
                       "model.plant_shelter = \"none\"");
    }
    if (parameters.transport == DuneTransport::slabs) {
        throw KeyError("model.plant_shelter",
                       "plants slow the wind of continuous transport only; write "
                       "model.transport = \"continuous\", or model.plant_shelter = \"none\"");
    }
}

PlantShelter::PlantShelter(const DunesParameters& parameters, const DuneGround& ground,
                           WorkerPool& pool)
    : ground_(ground),
      pool_(pool),
      has_wakes_(parameters.plant_shelter == DunePlantShelter::okin),
      drag_(parameters.plant_drag),
      grass_length_(parameters.shelter_length * parameters.grass.height),
      shrub_length_(parameters.shelter_length * parameters.shrubs.height),
      deficit_(ground.nx, ground.ny),
      reach_(ground.nx, ground.ny),
      stress_(ground.nx, ground.ny, 1.0) {}

void PlantShelter::set_plants(const Plants& plants) {
    const Grid grass = plants.grass();
    const Grid shrubs = plants.shrubs();
    for (std::size_t cell = 0; cell < stress_.size(); ++cell) {
        const double stress = 1.0 / (1.0 + drag_ * plants.cover().values()[cell]);
        const double length = std::max(grass_length_ * std::sqrt(grass.values()[cell]),
                                       shrub_length_ * std::sqrt(shrubs.values()[cell]));
        stress_.values()[cell] = stress;
        deficit_.values()[cell] = 1.0 - std::sqrt(stress);
        reach_.values()[cell] = deficit_.values()[cell] * length;
    }
}

void PlantShelter::find(const BlowingWind& wind) {
    if (!has_wakes_) return;
    const RowTraversal traversal(ground_, wind);
    const double farthest = followed_lengths * std::max(grass_length_, shrub_length_);
    const int rows_before = traversal.periodic_along
                                ? static_cast<int>(std::min<double>(
                                      std::ceil(farthest / traversal.distance), traversal.along))
                                : 0;
    pool_.for_ranges(traversal.lines(), [&](int begin, int end) {
        for (int first = begin; first < end; first += lines_of_shelter)
            follow_lines(traversal, rows_before, first, std::min(first + lines_of_shelter, end));
    });
}

void PlantShelter::follow_lines(const RowTraversal& traversal, int rows_before, int first,
                                int last) {
    constexpr double no_reach = 1e-30;   // m
    const int count = last - first + 1;  // the line before the first one, too
    OfShelterLines deficit{};            // of each line, where it is
    OfShelterLines kept{};               // of it to the next row
    OfShelterLines here{};               // of the cells of a row
    OfShelterLines reach{};
    for (int n = -rows_before; n < traversal.along; ++n) {
        throw_if_cancelled();
        const double at = traversal.first_cell() + traversal.shift * n;
        const double cell = std::floor(at);
        const double beyond = at - cell;
        LinesInRow lines{traversal.row(n), first - 1 + static_cast<std::int64_t>(cell), beyond};
        here.fill(0.0);
        reach.fill(0.0);
        for_each_cell(traversal, lines, count + 1, [&](std::size_t i, int x, int y) {
            here[i] = deficit_(x, y);
            reach[i] = reach_(x, y);
        });
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const double carried = deficit[i] * kept[i];
            const double met = here[i] + beyond * (here[i + 1] - here[i]);
            const double met_reach = reach[i] + beyond * (reach[i + 1] - reach[i]);
            const bool deeper = met >= carried;
            deficit[i] = deeper ? met : carried;
            if (deeper && met > 0.0) {
                kept[i] = elementary::exp(
                    -std::min(met * traversal.distance / std::max(met_reach, no_reach), 700.0));
            }
        }
        if (n < 0) continue;
        ++lines.cell;
        for_each_cell(traversal, lines, count - 1, [&](std::size_t i, int x, int y) {
            const double found = deficit[i + 1] + beyond * (deficit[i] - deficit[i + 1]);
            const double left = 1.0 - std::max(found, deficit_(x, y));
            stress_(x, y) = left * left;
        });
    }
}

}  // namespace fumon
