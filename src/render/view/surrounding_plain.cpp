#include "render/view/surrounding_plain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/find_named.h"
#include "base/random.h"
#include "base/worker_pool.h"
#include "numerics/plane_filter.h"
#include "numerics/smooth_step.h"
#include "numerics/tension_surface.h"
#include "render/view/bilinear_height.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr int least_margin = 24;            // cells on each side
constexpr double margin_share = 0.5;        // of the bed's longer side
constexpr int more_margin = 32;             // at most, for a side whose Fourier transform is fast
constexpr double plain_from = 0.85;         // of the margin: the plain alone
constexpr double relief_share = 1.0 / 6.0;  // of the bed's shorter side: its largest features
constexpr double taper_share =
    1.0 / 10.0;                           // over which the bed's edge is faded out of its spectrum
constexpr double edge_share = 1.0 / 4.0;  // depth into the bed to which its relief counts most
constexpr double quiet_share = 0.25;      // the share of the edges that are quieter than the plain
constexpr double most_rough = 1.6;        // logarithm: an edge against the plain
constexpr std::uint64_t seed = 15;

/// What pictures of endless ground read besides its heights.
constexpr std::array<std::string_view, 9> drawn_fields{"water_depth",    "velocity_x", "velocity_y",
                                                       "concentration",  "sand",       "cover",
                                                       "last_avalanche", "grass",      "shrubs"};

Snapshot without_fields(const Snapshot& snapshot) {
    Snapshot bare;
    bare.step = snapshot.step;
    bare.time = snapshot.time;
    bare.time_unit = snapshot.time_unit;
    bare.scale = snapshot.scale;
    bare.highest_expected = snapshot.highest_expected;
    bare.periodic = snapshot.periodic;
    bare.numbers = snapshot.numbers;
    bare.landform = snapshot.landform;
    bare.winds = snapshot.winds;
    return bare;
}

bool is_fast(int length) {
    for (const int prime : {2, 3, 5})
        while (length % prime == 0) length /= prime;
    return length == 1;
}

int tile_side(int cells, int margin) {
    for (int more = 0; more <= more_margin; ++more)
        if (is_fast(cells + 2 * (margin + more))) return cells + 2 * (margin + more);
    return cells + 2 * margin;
}

/// Sums over 2r + 1 rows around each, over the edges: of all columns side by side.
void box_sums_of_rows(Grid& field, int radius) {
    const int count = field.ny();
    radius = std::min(radius, (count - 1) / 2);
    const Grid before = field;
    const auto row = [&](int y) { return before.row((y % count + count) % count); };
    std::vector<double> sum(static_cast<std::size_t>(field.nx()));
    const auto add = [&](int y) {
        std::ranges::transform(sum, row(y), sum.begin(), std::plus<>());
    };
    for (int y = -radius; y <= radius; ++y) add(y);
    for (int y = 0; y < count; ++y) {
        std::ranges::copy(sum, field.row(y).begin());
        const auto enters = row(y + radius + 1);
        const auto leaves = row(y - radius);
        for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += enters[x] - leaves[x];
    }
}

/// The same over columns.
void box_sums_of_columns(Grid& field, int radius) {
    const int count = field.nx();
    radius = std::min(radius, (count - 1) / 2);
    std::vector<double> line(static_cast<std::size_t>(count));
    const auto from = [&](int i) {
        return line[static_cast<std::size_t>(i < 0 ? i + count : i < count ? i : i - count)];
    };
    for (int y = 0; y < field.ny(); ++y) {
        const auto row = field.row(y);
        std::ranges::copy(row, line.begin());
        double sum = 0.0;
        for (int i = -radius; i <= radius; ++i) sum += from(i);
        for (int i = 0; i < count; ++i) {
            row[static_cast<std::size_t>(i)] = sum;
            sum += from(i + radius + 1) - from(i - radius);
        }
    }
}

/// A smooth mean of a field with weights, over about `radius` cells.
Grid smoothed(const Grid& field, const Grid& weight, int radius) {
    Grid mean(field.nx(), field.ny());
    Grid sum = weight;
    for (std::size_t i = 0; i < field.size(); ++i)
        mean.values()[i] = field.values()[i] * weight.values()[i];
    const int third = std::max(1, (radius + 1) / 2);
    const double share = 1.0 / ((2.0 * third + 1.0) * (2.0 * third + 1.0));
    for (int pass = 0; pass < 3; ++pass) {
        for (Grid* summed : {&mean, &sum}) {
            box_sums_of_columns(*summed, third);
            box_sums_of_rows(*summed, third);
        }
        for (double& value : mean.values()) value *= share;
        for (double& value : sum.values()) value *= share;
    }
    for (std::size_t i = 0; i < mean.size(); ++i)
        mean.values()[i] = sum.values()[i] > 1e-6 ? mean.values()[i] / sum.values()[i] : 0.0;
    return mean;
}

/// Gives a plane's Fourier modes phases by chance.
void draw_phases(Grid& plane, WorkerPool& pool) {
    const auto drawn = [](int n, std::span<double> real, std::span<double> imaginary,
                          std::span<double> mirrored_real, std::span<double> mirrored_imaginary) {
        RandomStream stream(seed, static_cast<std::uint32_t>(n), 0, Purpose::plain);
        const auto turn = [&](double& re, double& im) {
            const double phase = 2.0 * std::numbers::pi * stream.uniform();
            re = elementary::cos(phase);
            im = elementary::sin(phase);
        };
        for (std::size_t m = 0; m < real.size(); ++m) {
            turn(real[m], imaginary[m]);
            turn(mirrored_real[m], mirrored_imaginary[m]);
        }
        if (n == 0) real[0] = imaginary[0] = mirrored_real[0] = mirrored_imaginary[0] = 0.0;
    };
    PlaneFilter(plane.nx(), plane.ny(), pool).apply(plane, drawn);
}

}  // namespace

bool is_bounded(const Snapshot& snapshot) {
    return !snapshot.periodic || !snapshot.nodata.empty();
}

SurroundingPlain::SurroundingPlain(const Snapshot& first, WorkerPool& pool,
                                   std::optional<double> sea)
    : bed_nx_(first.bed.nx()), bed_ny_(first.bed.ny()) {
    const int margin =
        std::max(static_cast<int>(margin_share * std::max(bed_nx_, bed_ny_)), least_margin);
    nx_ = tile_side(bed_nx_, margin);
    ny_ = tile_side(bed_ny_, margin);
    west_ = (nx_ - bed_nx_) / 2;
    south_ = (ny_ - bed_ny_) / 2;
    nodata_ = first.nodata;
    surroundings_ = surroundings(nodata_);
    const Mask& outside = surroundings_->outside;
    const Grid heights = in_tile(first.bed);
    const Field<float> depth = distances_to(outside);
    find_level(heights, outside, depth);
    make_relief(heights, outside, depth, pool);
    const bool land = first.landform == Landform::terrain || first.landform == Landform::water;
    if (land && first.bed.ny() > 1) make_land(first, outside, sea);
}

Mask SurroundingPlain::outside_of(const Mask& nodata) const {
    Mask outside(nx_, ny_, 1);
    for (int y = 0; y < bed_ny_; ++y)
        for (int x = 0; x < bed_nx_; ++x)
            outside(x + west_, y + south_) =
                nodata.empty() || nodata(x, y) == 0 ? std::uint8_t{0} : std::uint8_t{1};
    return outside;
}

Grid SurroundingPlain::in_tile(const Grid& field) const {
    Grid tile(nx_, ny_);
    for (int y = 0; y < bed_ny_; ++y)
        std::ranges::copy(field.row(y), tile.row(y + south_).begin() + west_);
    return tile;
}

/// Cells of the tile that are neither of the bed nor so far from it that the plain is all there is.
Mask SurroundingPlain::between_bed_and_plain(const Mask& outside) const {
    return within_of_bed(outside, plain_from);
}

Mask SurroundingPlain::within_of_bed(const Mask& outside, double share) const {
    const auto far = [share](int cell, int count, int margin) {
        const int from_edge = std::min(cell, count - 1 - cell);
        return from_edge < (1.0 - share) * margin;
    };
    Mask between = outside;
    for (int y = 0; y < ny_; ++y)
        for (int x = 0; x < nx_; ++x)
            if (far(x, nx_, west_) || far(y, ny_, south_)) between(x, y) = 0;
    return between;
}

/// The mean height of the cells along the bed's edges.
void SurroundingPlain::find_level(const Grid& heights, const Mask& outside,
                                  const Field<float>& depth) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (outside.values()[i] != 0 || depth.values()[i] > 2.0F) continue;
        sum += heights.values()[i];
        ++count;
    }
    if (count > 0) level_ = sum / static_cast<double>(count);
}

Grid SurroundingPlain::broad(const Grid& tile) const {
    constexpr int radius = 8;  // cells
    return smoothed(tile, Grid(nx_, ny_, 1.0), radius);
}

Grid SurroundingPlain::mean_of(const Grid& field, const Mask& cells) const {
    Grid weight(nx_, ny_);
    for (std::size_t i = 0; i < weight.size(); ++i)
        if (cells.values()[i] != 0) weight.values()[i] = 1.0;
    const int reach = std::max(west_, south_);
    return smoothed(field, weight, reach);
}

void SurroundingPlain::make_relief(const Grid& heights, const Mask& outside,
                                   const Field<float>& depth, WorkerPool& pool) {
    const double shorter = std::min(bed_nx_, bed_ny_);
    const int largest = std::max(2, static_cast<int>(relief_share * shorter));
    const double taper = std::max(3.0, taper_share * shorter);
    const double edge = std::max(4.0, edge_share * shorter);
    Grid known(nx_, ny_);
    Grid extended = heights;  // so that means near an edge are not those of one side
    for (std::size_t i = 0; i < known.size(); ++i) {
        known.values()[i] = outside.values()[i] == 0 ? 1.0 : 0.0;
        if (outside.values()[i] != 0) extended.values()[i] = level_;
    }
    surroundings_->between.fill(extended);
    const Grid broad = smoothed(extended, Grid(nx_, ny_, 1.0), largest);
    relief_ = Grid(nx_, ny_);
    Grid squares(nx_, ny_);
    for (std::size_t i = 0; i < relief_.size(); ++i) {
        if (outside.values()[i] != 0) continue;
        const auto deep = static_cast<double>(depth.values()[i]);
        const double detail = heights.values()[i] - broad.values()[i];
        const double weight = smooth_step(0.0, taper, deep) / (1.0 + (deep / edge) * (deep / edge));
        relief_.values()[i] = weight * detail;
        squares.values()[i] = detail * detail;
    }
    // How rough the bed is, as a logarithm. The plain is as rough as the quieter edges are.
    squares = smoothed(squares, known, std::max(2, largest / 2));
    double all = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i)
        if (outside.values()[i] == 0) all = std::max(all, squares.values()[i]);
    const double least = std::max(1e-4 * all, 1e-300);
    std::vector<double> edges;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        if (outside.values()[i] != 0) continue;
        double& rough = squares.values()[i];
        rough = 0.5 * elementary::log(std::max(rough, least));
        if (depth.values()[i] <= 2.0F) edges.push_back(rough);
    }
    double usual = 0.0;
    if (!edges.empty()) {
        const auto position =
            static_cast<std::ptrdiff_t>(quiet_share * static_cast<double>(edges.size()));
        std::nth_element(edges.begin(), edges.begin() + position, edges.end());
        usual = edges[static_cast<std::size_t>(position)];
    }
    for (std::size_t i = 0; i < squares.size(); ++i) {
        double& rough = squares.values()[i];
        rough = outside.values()[i] == 0 ? std::clamp(rough - usual, -most_rough, most_rough) : 0.0;
    }
    surroundings_->between.fill(squares);
    for (double& rough : squares.values())
        rough = elementary::exp(std::clamp(rough, -most_rough, most_rough));
    roughness_ = std::move(squares);

    draw_phases(relief_, pool);
    double power = 0.0;
    for (const double height : relief_.values()) power += height * height;
    power /= static_cast<double>(relief_.size());
    const double scale = power > 0.0 && all > 0.0 ? elementary::exp(usual) / std::sqrt(power) : 0.0;
    for (double& height : relief_.values()) height *= scale;
}

std::shared_ptr<const SurroundingPlain::Surroundings> SurroundingPlain::surroundings(
    const Mask& nodata) const {
    if (surroundings_ && nodata == nodata_) return surroundings_;
    const Mask outside = outside_of(nodata);
    Mask inside = outside;
    for (std::uint8_t& cell : inside.values()) cell = cell == 0 ? 1 : 0;
    Mask edge(nx_, ny_);
    const Field<float> depth = distances_to(outside);
    for (std::size_t i = 0; i < edge.size(); ++i) {
        if (inside.values()[i] == 0 || depth.values()[i] > 2.0F) continue;
        edge.values()[i] = depth.values()[i] > 1.5F ? 1 : 2;
    }
    return std::make_shared<const Surroundings>(
        Surroundings{outside, std::move(edge), distances_to(inside),
                     TensionSurface(between_bed_and_plain(outside))});
}

/// Of any field but the heights: what it has at the bed's edge runs out into its mean there.
Grid SurroundingPlain::continued(const Grid& field, const Surroundings& all) const {
    const Mask& outside = all.outside;
    Grid tile = in_tile(field);
    for (double& value : tile.values())
        if (!std::isfinite(value)) value = 0.0;  // a gap in a concentration
    double sum = 0.0;
    double low = 1e300;
    double high = -1e300;
    std::size_t count = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) {
        if (outside.values()[i] != 0) continue;
        low = std::min(low, tile.values()[i]);
        high = std::max(high, tile.values()[i]);
        if (all.edge.values()[i] == 0) continue;
        sum += tile.values()[i];
        ++count;
    }
    const double mean = count > 0 ? sum / static_cast<double>(count) : 0.0;
    for (std::size_t i = 0; i < tile.size(); ++i)
        if (outside.values()[i] != 0) tile.values()[i] = mean;
    all.between.fill(tile);
    Grid maps(2 * nx_, ny_, mean);
    for (int y = 0; y < ny_; ++y)
        std::ranges::transform(tile.row(y), maps.row(y).begin(), [&](double value) {
            return count > 0 ? std::clamp(value, low, high) : value;
        });
    return maps;
}

Snapshot SurroundingPlain::around(const Snapshot& snapshot, WorkerPool& pool,
                                  std::string_view coloured) const {
    const std::shared_ptr<const Surroundings> kept = surroundings(snapshot.nodata);
    const Surroundings& all = *kept;
    const Mask& outside = all.outside;
    const Grid heights = in_tile(snapshot.bed);
    Grid ground = own_;
    if (!is_drained()) {
        ground = Grid(nx_, ny_);
        for (std::size_t i = 0; i < ground.size(); ++i)
            ground.values()[i] = level_ + roughness_.values()[i] * relief_.values()[i];
    }
    // What is missing to the bed's heights.
    Grid missing(nx_, ny_);
    bool misses = false;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (outside.values()[i] != 0) continue;
        missing.values()[i] = is_drained() ? heights.values()[i] - own_.values()[i]
                                           : heights.values()[i] - level_ -
                                                 roughness_.values()[i] * relief_.values()[i];
        misses = misses || missing.values()[i] != 0.0;
    }
    Snapshot maps = without_fields(snapshot);
    maps.periodic = true;
    std::vector<const SnapshotField*> drawn;
    for (const SnapshotField& field : snapshot.fields)
        if (std::ranges::find(drawn_fields, field.name) != drawn_fields.end())
            drawn.push_back(&field);
    maps.fields.resize(drawn.size());
    // The heights first, then each of the fields.
    pool.for_ranges(1 + static_cast<int>(drawn.size()), [&](int begin, int end) {
        if (begin == 0 && misses) all.between.fill(missing);
        for (int i = std::max(begin, 1); i < end; ++i) {
            const auto k = static_cast<std::size_t>(i - 1);
            maps.fields[k] = {drawn[k]->name, drawn[k]->long_name, drawn[k]->unit,
                              continued(drawn[k]->values, all)};
        }
    });
    maps.bed = Grid(2 * nx_, ny_);
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            maps.bed(x, y) = outside(x, y) == 0 ? heights(x, y) : ground(x, y) + missing(x, y);
            maps.bed(nx_ + x, y) = level_ + relief_(x, y);
        }
    }
    const bool is_drawn = std::ranges::find(drawn_fields, coloured) != drawn_fields.end();
    if (const SnapshotField* field = find_named(snapshot.fields, coloured); field && !is_drawn) {
        Grid values(2 * nx_, ny_, std::numeric_limits<double>::quiet_NaN());
        const Grid known = in_tile(field->values);
        for (int y = 0; y < ny_; ++y)
            for (int x = 0; x < nx_; ++x)
                if (outside(x, y) == 0) values(x, y) = known(x, y);
        maps.fields.push_back({field->name, field->long_name, field->unit, std::move(values)});
    }
    if (is_drained() && has_water(snapshot)) add_water(snapshot, all, maps);
    return maps;
}

Field<std::uint8_t> SurroundingPlain::invented_share(const Snapshot& first) const {
    constexpr double fades_within = 12.0;  // cells
    const std::shared_ptr<const Surroundings> all = surroundings(first.nodata);
    Field<std::uint8_t> share(2 * nx_, ny_, 255);
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const double far = all->outside(x, y) == 0 ? 0.0 : static_cast<double>(all->away(x, y));
            share(x, y) =
                static_cast<std::uint8_t>(255.0 * smooth_step(0.0, fades_within, far) + 0.5);
        }
    }
    return share;
}

Snapshot SurroundingPlain::own_tile(const Snapshot& maps) const {
    const auto tile_of = [&](const Grid& field) {
        Grid tile(nx_, ny_);
        for (int y = 0; y < ny_; ++y) std::copy_n(field.row(y).begin(), nx_, tile.row(y).begin());
        return tile;
    };
    Snapshot tile = without_fields(maps);
    tile.bed = tile_of(maps.bed);
    for (const SnapshotField& field : maps.fields)
        tile.fields.push_back({field.name, field.long_name, field.unit, tile_of(field.values)});
    return tile;
}

void SurroundingPlain::stand_in(const CameraSettings& camera, const Snapshot& maps,
                                Block& block) const {
    const Block ground = ground_of(block);
    block.tiles = ground.tiles;
    const auto set = [&](std::optional<glm::dvec3>& at, const std::vector<double>& position) {
        if (!at || position.empty()) return;
        const glm::dvec2 tiles(at->x / ground.width_x + 0.5, at->y / ground.width_y + 0.5);
        const double height = bilinear_height(maps.bed, ground.tiles.in_maps(tiles), true);
        at->z = block.z(height + position[2] / maps.scale.height_unit);
    };
    set(block.eye, camera.at);
    set(block.look_at, camera.look_at);
}

Block SurroundingPlain::ground_of(const Block& bed) const {
    Block ground = bed;
    ground.width_x *= static_cast<double>(nx_) / bed_nx_;
    ground.width_y *= static_cast<double>(ny_) / bed_ny_;
    ground.tiles = {true};
    return ground;
}

}  // namespace fumon
