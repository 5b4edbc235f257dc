#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/grid.h"
#include "models/sand/sand_parameters.h"

namespace fumon::plain {

/// Where hops in random order start: row by row from each row's own random numbers, as in fumon, or
/// from anywhere on the grid, as the rule is published, which makes another bed of the same kind.
enum class Draw { row_by_row, whole_grid };

/// The rules of Sand as plain loops on one thread, as one writes them first: what fumon's rates are
/// measured against. Only those that sand_bench measures; the same bytes as fumon's, row by row.
class Sand {
  public:
    Sand(const SandParameters& parameters, Grid bed, std::uint64_t seed, Draw draw);

    void step();
    [[nodiscard]] const Grid& bed() const { return bed_; }

  private:
    void hop_all_at_once();
    void land(double* row) const;
    void hop_row_by_row();
    void hop_over_whole_grid();
    void hop(double* row, int x) const;
    void creep_every_cell();
    void creep_maxima();
    void creep_profile();

    SandParameters parameters_;
    int nx_;
    int ny_;
    std::uint64_t seed_;
    Draw draw_;
    std::mt19937_64 random_;
    std::int64_t steps_ = 0;
    Grid bed_;
    Grid next_;
    std::vector<int> lengths_;     ///< of a row's hops
    std::vector<double> amounts_;  ///< likewise
};

}  // namespace fumon::plain
