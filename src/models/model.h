#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terrain/grid.h"

namespace fumon {

class WorkerPool;

/// An immutable picture of a model between two steps: all that the renderer, the measurements and
/// the writers ever see of it. `bed` is in model heights; `scale` ties it to metres.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0.0;
    std::string time_unit;  ///< "steps", "s" …
    Grid bed;
    Mask nodata;  ///< empty when no cell lies outside the domain
    WorldScale scale;
};

/// One state field, in the order in which the state hash takes them.
struct StateField {
    std::string_view name;
    std::span<const double> values;
};

/// What a model is built on: the initial bed (model heights), its scale, the seed, and the threads
/// it may use. Its results must not depend on how many those are.
struct ModelSetup {
    Grid bed;
    Mask nodata;
    WorldScale scale;
    std::uint64_t seed = 1;
    WorkerPool& pool;
};

/// A landform model: it owns its state and advances it, and knows nothing of threads of the
/// pipeline, of files or of OpenGL.
class Model {
  public:
    Model() = default;
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;
    virtual ~Model() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;

    /// Advances by one step, as the published model defines it.
    virtual void step() = 0;

    [[nodiscard]] virtual std::int64_t steps_done() const = 0;
    [[nodiscard]] virtual double time() const { return static_cast<double>(steps_done()); }
    [[nodiscard]] virtual std::string_view time_unit() const { return "steps"; }

    /// The state between steps, copied.
    [[nodiscard]] virtual Snapshot snapshot() const = 0;

    /// Every field that the next step depends on, in declared order.
    [[nodiscard]] virtual std::vector<StateField> state() const = 0;
};

}  // namespace fumon
