#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "paper/store/run_store.h"

namespace fumon {

/// All runs that the figures at hand need, each once, with all steps that any of them needs.
class FigureRuns {
  public:
    /// Its number.
    std::size_t add(StoredRun run);
    [[nodiscard]] const std::vector<StoredRun>& all() const { return runs_; }
    [[nodiscard]] const StoredRun& operator[](std::size_t number) const { return runs_[number]; }

  private:
    std::vector<StoredRun> runs_;
    std::map<Sha256, std::size_t> numbers_;
};

}  // namespace fumon
