#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terrain/grid.h"

namespace fumon {

class StateCarrier;
class WorkerPool;

/// A field beside the bed that a model shows: the cells of the last avalanche, water depth …
struct SnapshotField {
    std::string name;       ///< as files and scenes call it: "last_avalanche"
    std::string long_name;  ///< what it is, in a few words
    std::string unit;       ///< "1" for a pure number
    Grid values;            ///< nx × ny
};

/// A line along the profile of a section, one value a column: "bed_shear_stress" …
struct SectionCurve {
    std::string name;
    std::string long_name;
    std::string unit;
    std::vector<double> values;  ///< nx
};

/// The path of a grain through the air. x goes on past the section's end where the grain does.
struct GrainPath {
    double launch_angle = 0.0;  ///< to the local bed, degrees
    std::vector<double> x;      ///< metres
    std::vector<double> z;      ///< metres, as many
};

/// The vertical plane over a bed that is a profile, in metres: column i at x = i·dx, node k at
/// z = k·dz. Periodic in x.
struct SnapshotSection {
    double dx = 0.0;
    double dz = 0.0;
    /// nx × nz each: "velocity_x", "velocity_z" (m/s), "pressure" (Pa) …; 0 at and below the bed.
    std::vector<SnapshotField> fields;
    std::vector<SectionCurve> curves;
    std::vector<GrainPath> paths;
};

/// A number that a model keeps count of, beside its fields.
struct SnapshotNumber {
    std::string name;  ///< "lost_grains"
    std::string unit;
    double value = 0.0;
};

/// An immutable picture of a model between two steps: all that the renderer, the measurements and
/// the writers ever see of it. `bed` is in model heights; `scale` ties it to metres.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0.0;
    std::string time_unit;  ///< "steps", "s" …
    Grid bed;
    Mask nodata;  ///< empty when no cell lies outside the domain
    WorldScale scale;
    /// Up to where the model's landforms grow, model heights; 0 where it does not know.
    double highest_expected = 0.0;
    bool periodic = false;  ///< whether the bed goes on past its edges with its other side
    std::vector<SnapshotField> fields{};
    std::vector<SnapshotNumber> numbers{};
    /// What is above a bed of a single row, where the model knows; shared, since it is large.
    std::shared_ptr<const SnapshotSection> section{};
};

/// All toppling that one dropped grain sets off (Higashi & Takamori 2003, section 4.2).
struct Avalanche {
    std::int64_t grain = 0;      ///< the grain that set it off, counted from 1
    std::int64_t size = 0;       ///< A_s: distinct cells whose height changed
    std::int64_t duration = 0;   ///< rounds of toppling until rest
    std::int64_t topplings = 0;  ///< cells that toppled, each as often as it did
    std::int64_t lost = 0;       ///< grains that left over the edge
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
    bool from_file = false;  ///< the bed is a terrain file's
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

    /// The avalanches of the last step, in order. Empty for models without any.
    [[nodiscard]] virtual std::span<const Avalanche> avalanches() const { return {}; }

    /// The state between steps, copied.
    [[nodiscard]] virtual Snapshot snapshot() const = 0;

    /// Every field that the next step depends on, in declared order.
    [[nodiscard]] virtual std::vector<StateField> state() const = 0;

    /// Carries, between two steps, everything beside scene and bed that the next steps, snapshots
    /// and times depend on, counters and sums included. A model that was just built on the same
    /// setup and gets it goes on with the same bytes as the one it was taken from. Throws as
    /// StateCarrier; the model is of no use then.
    virtual void carry(StateCarrier& carrier) = 0;
};

}  // namespace fumon
