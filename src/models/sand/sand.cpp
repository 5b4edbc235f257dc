#include "models/sand/sand.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/random.h"
#include "base/worker_pool.h"
#include "models/sand/creep.h"
#include "models/sand/profile_creep.h"
#include "models/sand/saltation_flux.h"

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

void check_table(const SandParameters& parameters) {
    if (parameters.hop_length != HopLength::tabulated) return;
    const std::vector<double>& heights = parameters.hop_table_heights;
    const std::size_t lengths = parameters.hop_table_lengths.size();
    constexpr std::size_t fewest = 2;
    if (heights.size() < fewest || heights.size() != lengths) {
        throw KeyError(
            "model.hop_table_heights",
            fmt::format("the tabulated hop law needs at least two points, and a length for each "
                        "height; there are {} in model.hop_table_heights and {} in "
                        "model.hop_table_lengths",
                        heights.size(), lengths));
    }
    for (std::size_t k = 1; k < heights.size(); ++k) {
        if (heights[k - 1] < heights[k]) continue;
        throw KeyError("model.hop_table_heights",
                       fmt::format("model.hop_table_heights must rise, but {} follows {}",
                                   heights[k], heights[k - 1]));
    }
}

void check_creep(const SandParameters& parameters) {
    if (parameters.creep == Creep::every_cell &&
        parameters.creep_rate > highest_every_cell_creep_rate) {
        throw KeyError(
            "model.creep_rate",
            fmt::format(
                "model.creep_rate is {}; with every-cell creep it takes a number > 0 and ≤ {}",
                parameters.creep_rate, highest_every_cell_creep_rate));
    }
}

}  // namespace

Sand::Sand(const SandParameters& parameters, ModelSetup setup)
    : parameters_(parameters), scale_(setup.scale), seed_(setup.seed), pool_(setup.pool) {
    check_creep(parameters);
    check_table(parameters);
    check_bed(parameters, setup);
    bed_ = std::move(setup.bed);
    if (parameters.creep != Creep::every_cell) next_ = Grid(bed_.nx(), bed_.ny());
    scratch_.assign(static_cast<std::size_t>(pool_.size()), {RowHops(parameters, bed_.nx()), {}});
    for (Scratch& scratch : scratch_) {
        const auto width = static_cast<std::size_t>(bed_.nx());
        for (auto& row : scratch.hopped) row.resize(width);
        scratch.behind.resize(width);
        scratch.ahead.resize(width);
    }
    picks_.resize(static_cast<std::size_t>(bed_.ny()));
}

void Sand::step() {
    if (parameters_.order == HopOrder::random_sequential) share_picks();
    switch (parameters_.creep) {
        case Creep::every_cell:
            hop_rows_and_creep();
            break;
        case Creep::maxima_only:
            hop_rows();
            maxima_creep_(bed_, next_, parameters_.creep_rate, pool_);
            break;
        case Creep::profile:
            hop_rows();
            creep_profiles();
            break;
        case Creep::none:
            hop_rows();
            break;
    }
    ++steps_;
}

Snapshot Sand::snapshot() const {
    Snapshot snapshot{steps_, time(), std::string(time_unit()), bed_, {}, scale_};
    snapshot.landform = landform;
    snapshot.periodic = true;
    snapshot.saltation_flux = [parameters = parameters_](const Snapshot& of) {
        return fumon::saltation_flux(parameters, of.bed);
    };
    return snapshot;
}

void Sand::share_picks() {
    RandomStream stream(seed_, 0, steps_, Purpose::picks_per_row);
    multinomial_equal(stream, static_cast<std::int64_t>(bed_.size()), picks_);
}

void Sand::for_rows(const std::function<void(int begin, int end, Scratch& scratch)>& body) {
    const int threads = pool_.size();
    pool_.for_ranges(threads, [&](int first, int last) {
        for (int thread = first; thread < last; ++thread) {
            const auto border = [&](int at) {
                return static_cast<int>(std::int64_t{bed_.ny()} * at / threads);
            };
            if (border(thread) == border(thread + 1)) continue;
            body(border(thread), border(thread + 1), scratch_[static_cast<std::size_t>(thread)]);
        }
    });
}

/// Both at once, in place: a row creeps as soon as it and its two neighbours have hopped, so the
/// bed is read once and written once. Rows beside those of a thread, which another one changes, hop
/// first.
void Sand::hop_rows_and_creep() {
    for_rows([this](int begin, int end, Scratch& scratch) {
        const int ny = bed_.ny();
        hop_row(scratch, (begin - 1 + ny) % ny, scratch.behind);
        hop_row(scratch, end % ny, scratch.ahead);
    });
    for_rows([this](int begin, int end, Scratch& scratch) {
        const auto hopped = [&](int y) -> std::vector<double>& {
            if (y < begin) return scratch.behind;
            if (y == end) return scratch.ahead;
            return scratch.hopped[static_cast<std::size_t>(y % 3)];
        };
        hop_row(scratch, begin, hopped(begin));
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            if (y + 1 < end) hop_row(scratch, y + 1, hopped(y + 1));
            creep_row(hopped(y - 1), hopped(y), hopped(y + 1), parameters_.creep_rate, bed_.row(y));
        }
    });
}

std::string Sand::plausibility_warning() const {
    if (parameters_.hop_length != HopLength::exponential) return {};
    const double highest = *std::max_element(bed_.values().begin(), bed_.values().end());
    const double longest = RowHops(parameters_, bed_.nx()).length(highest, 0.0);
    if (longest <= bed_.nx()) return {};
    return fmt::format(
        "by step {} the highest sand ({:.4g} heights) hops {:.4g} sites, round the box of {}: take "
        "a wider grid.nx, less sand (bed.high) or a shorter model.exponential_length",
        steps_, highest, longest, bed_.nx());
}

/// The bed after the hops takes the place of the bed before them.
void Sand::hop_rows() {
    const bool in_place = parameters_.order == HopOrder::random_sequential;
    if (in_place && bed_.ny() == 1) {
        hop_only_row();
        return;
    }
    for_rows([&](int begin, int end, Scratch& scratch) {
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            hop_row(scratch, y, in_place ? bed_.row(y) : next_.row(y));
        }
    });
    if (!in_place) std::swap(bed_, next_);
}

/// A single row hops on one thread; in a long one, another draws the next step's picks meanwhile.
void Sand::hop_only_row() {
    constexpr int worth_a_thread = 1 << 14;  // sites
    const std::int64_t count = picks_.front();
    if (drawn_.step() != steps_) drawn_.draw(count, bed_.nx(), seed_, 0, steps_);
    const RowHops& hops = scratch_.front().hops;
    if (bed_.nx() < worth_a_thread || pool_.size() == 1) {
        hops.random_sequential(bed_.row(0), drawn_);
        return;
    }
    pool_.for_ranges(2, [&](int begin, int end) {
        if (begin == 0) hops.random_sequential(bed_.row(0), drawn_);
        if (end == 2) drawn_ahead_.draw(count, bed_.nx(), seed_, 0, steps_ + 1);
    });
    std::swap(drawn_, drawn_ahead_);
}

void Sand::hop_row(Scratch& scratch, int y, std::span<double> after) const {
    const auto before = bed_.row(y);
    if (parameters_.order == HopOrder::synchronous) {
        scratch.hops.synchronous(before, after);
        return;
    }
    if (after.data() != before.data()) std::copy(before.begin(), before.end(), after.begin());
    scratch.picks.draw(picks_[static_cast<std::size_t>(y)], bed_.nx(), seed_,
                       static_cast<std::uint32_t>(y), steps_);
    scratch.hops.random_sequential(after, scratch.picks);
}

void Sand::creep_profiles() {
    const SandParameters& p = parameters_;
    if (bed_.ny() == 1) {
        profile_creep(bed_.row(0), p.creep_rate, p.flank_rate, next_.row(0), &pool_);
    } else {
        pool_.for_ranges(bed_.ny(), [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                profile_creep(bed_.row(y), p.creep_rate, p.flank_rate, next_.row(y));
            }
        });
    }
    std::swap(bed_, next_);
}

}  // namespace fumon
