#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// A run of a figure as its caption tells it.
struct CaptionRun {
    const Scene* scene = nullptr;
    std::vector<std::string> varied;  ///< keys that a sweep varies
};

/// What the runs of a figure share, and in what each differs.
class CaptionFacts {
  public:
    explicit CaptionFacts(const std::vector<CaptionRun>& runs);

    /// "model sand, 2000 steps: grid.nx = 120 cells, …": what is the same in all runs, without
    /// parameters that are the model's defaults. Empty where they share nothing.
    [[nodiscard]] std::string shared() const;
    /// The same of what is not the same in all of them: each by its own value, also a default.
    [[nodiscard]] std::string own(std::size_t run) const;

  private:
    struct Fact {
        std::string key;
        std::string text;      ///< "D (model.creep_rate) = 0.2 share per step"
        bool usual = false;    ///< the model's default, which nobody needs to be told
        bool heading = false;  ///< the model, and the steps of its run
    };
    using Facts = std::vector<Fact>;

    static Facts facts_of(const CaptionRun& run);
    [[nodiscard]] bool is_shared(const Fact& fact) const;
    static std::string sentence(const std::vector<const Fact*>& facts);

    std::vector<Facts> runs_;
};

}  // namespace fumon
