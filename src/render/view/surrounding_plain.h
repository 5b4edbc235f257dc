#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "base/grid.h"
#include "base/snapshot.h"
#include "numerics/tension_surface.h"
#include "render/land/drained_land.h"
#include "render/land/edge_lake.h"
#include "render/land/wandering_coast.h"
#include "render/view/block.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// Whether a bed ends somewhere: where cells lie outside it, or its sides do not go on into each
/// other.
bool is_bounded(const Snapshot& snapshot);

/// The plain into which a bed that ends goes on, to the horizon.
///
/// Far away it is level at the mean of the bed's edges, with relief like the bed's own: what the
/// bed has of features up to a sixth of its shorter side, weighted towards its edges, with the
/// phases of its Fourier transform drawn anew (random-phase texture, Galerne, Gousseau & Morel
/// 2011). Near the bed the relief is as rough as the edge is there, and a thin plate in tension
/// lies between both, so that heights and slopes meet the edge. Within the bed nothing changes. A
/// bed that ends somewhere is there once, also where it would repeat along one axis.
///
/// Around land, a bed of the landforms terrain and water, there is land that is drained: its relief
/// is DrainedTile's, of the bed's own slopes by drained area, and in the bed's tile drain_between()
/// leads valleys out from where the bed's water leaves. It is made of the first bed, so that a film
/// shows one land; what changes at a bed's edge later goes on over it as a thin plate. Water
/// that leaves the bed runs on along the valleys' beds; other ground is as damp as the edge is.
/// Where the bed's edge lies in the sea, one that is known or that sea_level() finds, land goes on
/// as high as the edge beside it and falls at the bed's mean gradient to that sea before the tile's
/// end, at shores that wander (inland_distances()); the sea goes on to the horizon: under water as
/// deep as at the edge, on a dry bed as level ground. Other still water that reaches over the edge
/// (lake_at_edge()) ends as a lake, in shores that wander, too.
class SurroundingPlain {
  public:
    /// Of a bed, as it is shown. `sea`: the level of a sea that is known to be there, in the
    /// heights' unit; without it the water at the edge says whether there is one.
    SurroundingPlain(const Snapshot& first, WorkerPool& pool, std::optional<double> sea = {});

    /// That bed, or one of the same cells, in the plain: a snapshot of the maps of GroundTiles,
    /// periodic and without cells outside, of fields only those that are drawn, which go
    /// on over the plain, and the `coloured` one, which has no values (NaN) there.
    [[nodiscard]] Snapshot around(const Snapshot& snapshot, WorkerPool& pool,
                                  std::string_view coloured = {}) const;

    /// How far their ground is invented: 0 on the bed, 255 from a dozen cells beyond it on.
    [[nodiscard]] Field<std::uint8_t> invented_share(const Snapshot& first) const;

    /// The bed's own tile of such maps, which is periodic too.
    [[nodiscard]] Snapshot own_tile(const Snapshot& maps) const;

    /// Gives the block of the bed its tiles, and sets a camera that stands or looks at a point of
    /// the scene on the ground of these maps, where the bed ends too.
    void stand_in(const CameraSettings& camera, const Snapshot& maps, Block& block) const;

    /// The block of the ground: of one tile, its origin and scale those of the bed's.
    [[nodiscard]] Block ground_of(const Block& bed) const;

    /// Rain on the bed, over the bed's own tile.
    [[nodiscard]] std::function<Grid(double from, double until)> rain_over_tile(
        const Snapshot& snapshot) const;

    /// Whether the land around is drained.
    [[nodiscard]] bool is_drained() const { return !own_.empty(); }

  private:
    /// Of the cells of a tile.
    struct Surroundings {
        Mask outside;            ///< of the bed
        Mask edge;               ///< 1 within 2 cells of the bed's edge, 2 within 1.5, on the bed
        Field<float> away;       ///< from the bed, cells
        TensionSurface between;  ///< bed and plain
    };

    [[nodiscard]] std::shared_ptr<const Surroundings> surroundings(const Mask& nodata) const;
    [[nodiscard]] Mask outside_of(const Mask& nodata) const;
    [[nodiscard]] Grid in_tile(const Grid& field) const;
    [[nodiscard]] Mask between_bed_and_plain(const Mask& outside) const;
    /// Cells outside that lie within a share of the margin of the bed's sides.
    [[nodiscard]] Mask within_of_bed(const Mask& outside, double share) const;
    /// Of a field, by place: the mean of those of some cells that are near by.
    [[nodiscard]] Grid mean_of(const Grid& field, const Mask& cells) const;
    [[nodiscard]] Grid continued(const Grid& field, const Surroundings& all) const;
    void find_level(const Grid& heights, const Mask& outside, const Field<float>& depth);
    void make_relief(const Grid& heights, const Mask& outside, const Field<float>& depth,
                     WorkerPool& pool);

    void make_land(const Snapshot& first, const Mask& outside, std::optional<double> known_sea);
    /// False where no part of the bed's edge lies in the sea.
    bool make_coast(const Snapshot& first, const Mask& outside, double sea);
    /// The bed's edge, with its cells in the sea; `within`: how many cells each lies within.
    [[nodiscard]] CoastEdge coast_edge(Mask sea, const Mask& outside,
                                       const Field<float>& within) const;
    /// A lake that reaches over the edge, which is no sea; `surface` in the tile.
    [[nodiscard]] std::optional<EdgeLake> lake_of(const Snapshot& first, const Grid& surface,
                                                  const Field<float>& depth) const;
    void lay_lake(const Mask& outside, double fall, Field<LandCell>& cells);
    /// Fills in what is `between` in steps, so that slopes go on over some ten cells: the plate in
    /// tension gives them up within two of its own.
    void lead_over(Grid& tile, const Mask& between) const;
    /// Without features of a few cells.
    [[nodiscard]] Grid broad(const Grid& tile) const;
    void add_water(const Snapshot& snapshot, const Surroundings& all, Snapshot& maps) const;

    int bed_nx_;
    int bed_ny_;
    int nx_;  ///< of a tile
    int ny_;
    int west_;   ///< cells of the tile west of the bed
    int south_;  ///< and south of it
    double level_ = 0.0;
    std::optional<double> sea_;     ///< the height of its surface
    std::optional<EdgeLake> lake_;  ///< in the bed's tile
    Mask lake_cells_;               ///< of it, beyond the bed
    Grid relief_;                   ///< of a tile of the plain alone
    Grid roughness_;                ///< by which it is multiplied in the bed's tile
    Grid own_;  ///< of drained land: the bed's tile with the first bed; else empty
    Field<std::int32_t> downstream_;                    ///< of its cells, see FlowRouting
    Mask nodata_;                                       ///< of the first bed
    std::shared_ptr<const Surroundings> surroundings_;  ///< of a bed with that
};

}  // namespace fumon
