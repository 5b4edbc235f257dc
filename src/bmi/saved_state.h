#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/shared/model.h"

namespace fumon {

/// What a model keeps from step to step (Model::serialise), held in memory.
class SavedState {
  public:
    explicit SavedState(Model& model);

    /// Takes the values that bear this name from another state. False where neither has them.
    bool take(std::string_view name, const SavedState& other);

    /// Brings a model to this state. Throws InputError where the model is of another kind or finds
    /// it impossible.
    void restore(Model& model) const;

    using Values = std::variant<std::vector<double>, std::vector<std::int64_t>, std::string>;
    struct Entry {
        std::string name;
        Values values;
    };

  private:
    std::vector<Entry> entries_;
};

}  // namespace fumon
