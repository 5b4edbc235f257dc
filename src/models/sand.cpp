#include "models/sand.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "support/error.h"
#include "support/worker_pool.h"
#include "terrain/random.h"

namespace fumon {

namespace {

void check_bed(const SandParameters& parameters, const ModelSetup& setup) {
    if (!setup.nodata.empty()) {
        throw KeyError("bed.file",
                       "the bed has cells without data, over which sand cannot hop; write "
                       "bed.nodata = \"fill\" or give "
                       "them a height");
    }
    const double box = setup.bed.nx();
    if (parameters.hop_length == HopLength::slope) {
        const double longest = parameters.hop_base + parameters.hop_slope_factor;
        if (longest <= box) return;
        throw KeyError("model.hop_slope_factor",
                       fmt::format("hops of up to {:.4g} sites (model.hop_base + "
                                   "model.hop_slope_factor) exceed the box "
                                   "of {} sites; take a wider grid or shorter hops",
                                   longest, box));
    }
    const double highest = *std::max_element(setup.bed.values().begin(), setup.bed.values().end());
    const double longest = RowHops(parameters, setup.bed.nx()).length(highest, 0.0);
    if (longest <= box) return;
    throw KeyError(
        "grid.height_unit",
        fmt::format(
            "the highest sand ({:.4g} heights of grid.height_unit = {:.4g} m) would hop {:.4g} "
            "sites, "
            "further than the box of {}; raise grid.height_unit, lower the bed or shorten the hops",
            highest, setup.scale.height_unit, longest, box));
}

void check_creep(const SandParameters& parameters) {
    constexpr double highest = 0.75;  // Terada (2024), eq. (13)
    if (parameters.creep == Creep::every_cell && parameters.creep_rate > highest) {
        throw KeyError(
            "model.creep_rate",
            fmt::format(
                "model.creep_rate is {}; with every-cell creep it takes a number > 0 and ≤ {}",
                parameters.creep_rate, highest));
    }
}

}  // namespace

Sand::Sand(const SandParameters& parameters, ModelSetup setup)
    : parameters_(parameters), scale_(setup.scale), seed_(setup.seed), pool_(setup.pool) {
    check_creep(parameters);
    check_bed(parameters, setup);
    bed_ = std::move(setup.bed);
    next_ = Grid(bed_.nx(), bed_.ny());
    picks_.resize(static_cast<std::size_t>(bed_.ny()));
}

void Sand::step() {
    if (parameters_.order == HopOrder::random_sequential) share_picks();
    if (parameters_.creep == Creep::every_cell) {
        hop_rows_and_creep();
    } else {
        hop_rows();
    }
    std::swap(bed_, next_);
    if (parameters_.creep == Creep::maxima_only) maxima_creep_(bed_, parameters_.creep_rate);
    ++steps_;
}

Snapshot Sand::snapshot() const {
    return {steps_, time(), std::string(time_unit()), bed_, {}, scale_, true};
}

void Sand::share_picks() {
    RandomStream stream(seed_, 0, steps_, Purpose::picks_per_row);
    multinomial_equal(stream, static_cast<std::int64_t>(bed_.size()), picks_);
}

/// Both at once: a row creeps as soon as it and its two neighbours have hopped, so the bed is read
/// once and written once. Rows at the border of two threads hop in both.
void Sand::hop_rows_and_creep() {
    pool_.for_ranges(bed_.ny(), [this](int begin, int end) {
        const int ny = bed_.ny();
        RowHops hops(parameters_, bed_.nx());
        std::array<std::vector<double>, 3> hopped;
        for (auto& row : hopped) row.resize(static_cast<std::size_t>(bed_.nx()));
        const auto hop = [&](int y) {
            hop_row(hops, (y + ny) % ny, hopped[static_cast<std::size_t>((y + 3) % 3)]);
        };
        const auto row = [&](int y) -> std::span<const double> {
            return hopped[static_cast<std::size_t>((y + 3) % 3)];
        };
        hop(begin - 1);
        hop(begin);
        for (int y = begin; y < end; ++y) {
            hop(y + 1);
            creep_row(row(y - 1), row(y), row(y + 1), parameters_.creep_rate, next_.row(y));
        }
    });
}

void Sand::hop_rows() {
    pool_.for_ranges(bed_.ny(), [this](int begin, int end) {
        RowHops hops(parameters_, bed_.nx());
        for (int y = begin; y < end; ++y) hop_row(hops, y, next_.row(y));
    });
}

void Sand::hop_row(RowHops& hops, int y, std::span<double> after) const {
    const auto before = bed_.row(y);
    if (parameters_.order == HopOrder::synchronous) {
        hops.synchronous(before, after);
    } else {
        std::copy(before.begin(), before.end(), after.begin());
        hops.random_sequential(after, picks_[static_cast<std::size_t>(y)], seed_,
                               static_cast<std::uint32_t>(y), steps_);
    }
}

}  // namespace fumon
