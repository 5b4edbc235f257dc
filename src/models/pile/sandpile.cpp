#include "models/pile/sandpile.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/random.h"
#include "base/state_archive.h"
#include "models/pile/toppling.h"

namespace fumon {

namespace {

void check_bed(const ModelSetup& setup) {
    if (!setup.nodata.empty()) {
        throw KeyError("bed.file",
                       "the bed has cells without data, on which no grain can lie; write "
                       "bed.nodata = \"fill\" or give them a height");
    }
    constexpr double highest = 1e6;
    for (const double height : setup.bed.values()) {
        if (height >= 0.0 && height <= highest && height == std::floor(height)) continue;
        throw KeyError("bed.kind",
                       fmt::format("a pile is made of whole grains, but the bed has a height of "
                                   "{:.6g}; write bed.kind = \"flat\", or give it whole heights "
                                   "from 0 to {}",
                                   height, highest));
    }
}

void check_topple(const SandpileParameters& parameters) {
    const std::int64_t threshold = parameters.threshold;
    const std::int64_t grains = parameters.grains_per_topple;
    const std::int64_t most = most_grains_per_topple(threshold);
    if (most == 0) {
        throw KeyError("model.threshold",
                       fmt::format("model.threshold is {}; even a single grain would leave its "
                                   "cell below the one it falls on, so take 2 or more",
                                   threshold));
    }
    if (grains <= most) return;
    const std::int64_t received = (grains + 2) / 3;
    throw KeyError(
        "model.grains_per_topple",
        fmt::format("model.grains_per_topple is {} with model.threshold = {}: a cell that gives {} "
                    "may end below one that gets {}; take at most {}, or a threshold of {} or more",
                    grains, threshold, grains, received, most, grains + received));
}

std::vector<Site> sites_of(const SandpileParameters& parameters, const Grid& bed) {
    if (parameters.drop_x.size() != parameters.drop_y.size()) {
        throw KeyError("model.drop_y",
                       fmt::format("model.drop_x has {} numbers and model.drop_y "
                                   "{}; give each drop site both",
                                   parameters.drop_x.size(), parameters.drop_y.size()));
    }
    // Higashi & Takamori's centre (M/2, M/2), in arrays whose Y grows downward.
    if (parameters.drop_x.empty()) return {{bed.nx() / 2, bed.ny() - 1 - bed.ny() / 2}};
    const auto check = [](const char* key, std::int64_t place, const char* side, int cells) {
        if (place >= 0 && place < cells) return;
        throw KeyError(key, fmt::format("{} names {}, off the grid of {} = {}; it takes 0 to {}",
                                        key, place, side, cells, cells - 1));
    };
    std::vector<Site> sites;
    for (std::size_t site = 0; site < parameters.drop_x.size(); ++site) {
        check("model.drop_x", parameters.drop_x[site], "grid.nx", bed.nx());
        check("model.drop_y", parameters.drop_y[site], "grid.ny", bed.ny());
        sites.push_back(
            {static_cast<int>(parameters.drop_x[site]), static_cast<int>(parameters.drop_y[site])});
    }
    return sites;
}

const Grid& checked_bed(const SandpileParameters& parameters, const ModelSetup& setup) {
    check_topple(parameters);
    check_bed(setup);
    return setup.bed;
}

}  // namespace

Sandpile::Sandpile(const SandpileParameters& parameters, const ModelSetup& setup)
    : parameters_(parameters),
      scale_(setup.scale),
      seed_(setup.seed),
      sites_(sites_of(parameters, setup.bed)),
      pile_(parameters, checked_bed(parameters, setup), sites_),
      draws_(parameters.drop_direction, setup.seed) {}

void Sandpile::step() {
    if (dropped_ == 0) pile_.settle(draws_);
    avalanches_.clear();
    for (std::int64_t grain = 0; grain < parameters_.grains_per_step; ++grain) {
        throw_if_cancelled();
        drop_grain();
    }
    ++steps_;
}

void Sandpile::drop_grain() {
    const Site site = site_of_next_grain();
    ++dropped_;
    draws_.begin_grain(dropped_);
    Avalanche avalanche = pile_.drop(site, draws_);
    if (avalanche.size == 0) return;
    avalanche.grain = dropped_;
    avalanches_.push_back(avalanche);
    ++avalanche_count_;
}

const Site& Sandpile::site_of_next_grain() const {
    const auto count = static_cast<std::uint32_t>(sites_.size());
    if (parameters_.drop_choice == DropChoice::in_turn || count == 1)
        return sites_[static_cast<std::size_t>(dropped_) % count];
    const std::int64_t grain = dropped_ + 1;
    RandomStream stream(seed_, static_cast<std::uint32_t>(grain >> 32), grain, Purpose::drop_sites);
    return sites_[stream.below(count)];
}

Snapshot Sandpile::snapshot() const {
    Snapshot snapshot{steps_, time(), std::string(time_unit()), pile_.heights(), {}, scale_};
    snapshot.landform = landform;
    constexpr double slope_of_threshold = 0.35;  // of the cones that grow, heights per site
    const auto threshold = static_cast<double>(parameters_.threshold);
    snapshot.highest_expected =
        threshold *
        (1.0 + slope_of_threshold * 0.5 * std::min(snapshot.bed.nx(), snapshot.bed.ny()));
    snapshot.fields.push_back(
        {"last_avalanche",
         "what the last avalanche did to each cell: 1 received, 1 + n toppled n times", "1",
         pile_.changes()});
    snapshot.numbers = {{"dropped_grains", "grains", static_cast<double>(dropped_)},
                        {"lost_grains", "grains", static_cast<double>(pile_.lost())},
                        {"avalanches", "1", static_cast<double>(avalanche_count_)},
                        {"drop_x", "1", static_cast<double>(sites_.front().x)},
                        {"drop_y", "1", static_cast<double>(sites_.front().y)}};
    return snapshot;
}

std::vector<StateField> Sandpile::state() const {
    state_bed_ = pile_.heights();
    state_direction_ = pile_.directions();
    state_counts_ = {static_cast<double>(dropped_), static_cast<double>(pile_.lost()),
                     static_cast<double>(avalanche_count_), static_cast<double>(draws_.drawn())};
    return {{"bed", state_bed_.values()},
            {"direction", state_direction_.values()},
            {"counts", state_counts_}};
}

void Sandpile::serialise(StateArchive& archive) {
    archive.count("steps", steps_);
    archive.count("dropped_grains", dropped_);
    archive.count("avalanches", avalanche_count_);
    draws_.serialise(archive);
    pile_.serialise(archive);
}

}  // namespace fumon
