#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "base/state_archive.h"

namespace fumon {

/// A sum that carries what each addition rounds away (Neumaier 1974): its error stays near one
/// unit in the last place however many terms there are.
class CompensatedSum {
  public:
    void add(double term) {
        const double sum = sum_ + term;
        lost_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
        sum_ = sum;
    }
    [[nodiscard]] double value() const { return sum_ + lost_; }

    void serialise(std::string_view name, StateArchive& archive) {
        std::array both{sum_, lost_};
        archive.values(name, both);
        sum_ = both[0];
        lost_ = both[1];
    }

  private:
    double sum_ = 0.0;
    double lost_ = 0.0;
};

}  // namespace fumon
