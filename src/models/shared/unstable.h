#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/error.h"

namespace fumon {

/// A run has become numerically unstable: "FAULT; try REMEDIES".
class Unstable : public Error {
  public:
    /// `fault` says what happened where, and what bounds the step; `remedies` is a list such as "a
    /// smaller model.time_step or more model.bed_diffusion".
    Unstable(std::string fault, std::string remedies)
        : Error(fmt::format("{}; try {}", fault, remedies)),
          fault_(std::move(fault)),
          remedies_(std::move(remedies)) {}

    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] const std::string& remedies() const { return remedies_; }

  private:
    std::string fault_;
    std::string remedies_;
};

}  // namespace fumon
