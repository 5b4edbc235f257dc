#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/avalanche.h"
#include "base/grid.h"
#include "base/snapshot.h"

namespace fumon {

class StateArchive;
class WorkerPool;

/// One state field, in the order in which the state hash takes them.
struct StateField {
    std::string_view name;
    std::span<const double> values;
};

/// What a scene gives of a quantity for each cell of the bed.
struct CellMap {
    Grid values;  ///< 0 in cells without data
    Mask nodata;  ///< empty where every cell has data

    [[nodiscard]] bool has(std::size_t cell) const {
        return nodata.empty() || nodata.values()[cell] == 0;
    }
};

/// What a model is built from: the initial bed (model heights), its scale, the seed, and the
/// threads that it may use. Results must not depend on the number of threads.
struct ModelSetup {
    Grid bed;
    Mask nodata;
    WorldScale scale;
    std::uint64_t seed = 1;
    WorkerPool& pool;
    bool from_file = false;       ///< the bed is a terrain file's
    std::vector<CellMap> maps{};  ///< those of [[map]], in their order
};

/// A landform model: it owns its state and advances it. It knows nothing of the pipeline's threads,
/// of files or of OpenGL.
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

    /// The avalanches of the last step, in order. Empty for models without any.
    [[nodiscard]] virtual std::span<const Avalanche> avalanches() const { return {}; }

    /// The state between steps, copied.
    [[nodiscard]] virtual Snapshot snapshot() const = 0;

    /// One line on what in the present state nature would not do, and what to set instead; empty
    /// where all is plausible.
    [[nodiscard]] virtual std::string plausibility_warning() const { return {}; }

    /// Every field that the next step depends on, in declared order.
    [[nodiscard]] virtual std::vector<StateField> state() const = 0;

    /// Saves or restores, between two steps, everything besides scene and bed on which the next
    /// steps, snapshots and times depend, including counters and sums. A model newly built from the
    /// same setup that restores this state continues with the same bytes as the one that saved it.
    /// Throws as StateArchive does; the model must not be used after that.
    virtual void serialise(StateArchive& archive) = 0;
};

}  // namespace fumon
