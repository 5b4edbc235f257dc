#pragma once

#include <string>
#include <vector>

#include "foreign/quantity.h"

namespace fumon {

/// By which names the files of a model call a quantity, the preferred one first.
struct QuantityNames {
    Quantity quantity;
    std::vector<std::string> names;
    bool grows_downward = false;  ///< where a file's own attributes do not say
};

struct ForeignModel {
    std::string name;
    std::vector<QuantityNames> quantities;
    std::vector<std::string> other_names{};  ///< those that mean something else in its files
    double dry = 0.0;  ///< metres, the depth below which it has no water; 0: it does not say
};

/// The models of assets/models/variables.toml, in its order. Throws Error where the table is
/// damaged.
const std::vector<ForeignModel>& foreign_models();

}  // namespace fumon
