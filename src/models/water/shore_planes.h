// Why cells along shores have planes, and how they get them.
//
// A shore cuts cells. A scheme that takes each cell for covered as a whole moves the shore by whole
// cells. Here a cell at a shore holds water under a plane instead, clipped where it meets the bed,
// so that the shore lies anywhere in it and aslant.
//
// 1. Slopes come from deep water: the nearest core cells, at most three away, go on linearly, with
//    second differences, and the mean of them counts.
// 2. The height comes from the cell's own mean depth (clipped_plane.h).
// 3. Both must agree to half of what the depth falls by over a cell: a bore, or a film of rain, is
//    not a lake's edge. Water that would be faster than a front from there is not its edge either,
//    and on a bed that the grid does not resolve slopes say nothing of where the shore is.
// 4. Second differences count only where those of all core cells agree in sign, the smallest one.
// 5. Sums run over pairs of opposite cells, so that mirrored lakes stay so to the last bit.
// 6. Core cells beside planed ones belong to the shore: limited slopes would treat the water there,
//    no deeper than a few of the bed's steps, as that of whole cells.
// 7. Fluxes are HLLC (Toro, Spruce & Speares 1994) of means along the face, with the wave speeds of
//    two rarefactions and exact fronts at dry cells, as for all other faces.
//
//     the bed rises  ──►
//     water       core    core     full     wet      dry
//     kind        core    shore    planed   planed   –          planed cells are the shore's too
//     slopes      own     own      from the nearest core cells
//
// Parts: shore_kinds.cpp (which cells), shore_planes.cpp (planes), shore_faces.cpp (what passes
// faces), shore_deficits.cpp (what cells that ran dry have still to deliver).

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "models/sediment/face_flows.h"
#include "models/water/kernels/finite_volume_vectors.h"
#include "models/water/shallow_water.h"
#include "models/water/water_edges.h"

namespace fumon {

class WorkerPool;

/// The water along shores, by planes that the deeper water gives them, for shores that move over a
/// bed which the grid resolves.
///
/// A cell is full where its depth, falling on as from its deeper neighbours, ends beyond it. Where
/// all eight neighbours of a full cell are full too, surface and velocities have slopes as
/// elsewhere. In the other wet cells, up to three from such ones, these give them: surface and
/// velocities go on linearly, the surface's slope with its second differences, each the smallest
/// of theirs if they agree in sign; velocities are those of which momenta are means (cell_means.h).
/// The surface's height follows from the cell's own mean depth (clipped_plane.h), so that a shore
/// may lie anywhere in the cell and aslant. Fluxes through the faces, with a parabola's term as
/// elsewhere (mean_vectors.h), are HLLC ones of the mean depth along the face, with the mean of its
/// square for the pressure; into or out of a dry cell, of the water at the shore itself.
///
/// What such a cell could not give within a stage, as where a falling shore leaves it, it gives
/// after the step (shore_deficits.cpp).
///
/// Where such a cell's own level is far from what the deeper water would give it (a bore, a film
/// that is left or comes down a slope), or the bed in it and the next cells is not smooth
/// (second differences no smaller than half the slope), it is not one of these: it and faces of its
/// kind stay as they are.
class ShorePlanes {
  public:
    /// What passes a face, per metre, as finite_volume::Fluxes has it.
    struct Face {
        int x = 0;  ///< the cell's west or south of it
        double mass = 0.0;
        double left = 0.0;
        double right = 0.0;
        double along = 0.0;
    };
    /// The surface's slopes in a cell, over a cell, m.
    struct Slope {
        int x = 0;
        double surface_x = 0.0;
        double surface_y = 0.0;
    };

    /// Keeps references to the domain and the edges. `steepness` is the limiter's.
    ShorePlanes(const WaterDomain& domain, const WaterEdges& edges, int nx, int ny, double gravity,
                double steepness);

    /// One of the Euler steps of which a step is a mean.
    struct StageOfStep {
        double dt = 0.0;  ///< s
        double weight = 1.0;
    };

    /// Where deliveries are noted too; null: nowhere.
    struct DeliveryNotes {
        FaceFlows::Stage* flow = nullptr;  ///< of the last stage
        WatchedFaces* faces = nullptr;
    };

    /// Finds the shore's cells and what passes their faces, in a stage.
    void find(const Water& water, const Grid& bed, const StageOfStep& stage, WorkerPool& pool);

    /// Lets cells deliver what they could not in the stages since the last call, which make a step
    /// of `dt` seconds (shore_deficits.cpp). Adds it to `notes`, and lists the rows that changed.
    void deliver_deficits(Water& water, double dt, const DeliveryNotes& notes,
                          std::vector<int>& changed_rows);

    /// Changes depths at the cells' middles to the means over them along shores, and gives cells
    /// that get water its velocity.
    void convert_to_means(Water& water, const Grid& bed, WorkerPool& pool);

    /// Faces toward the east, and toward the north, of row y; sorted by x. Beyond the grid's south
    /// edge: of row −1, the faces toward row 0.
    [[nodiscard]] const std::vector<Face>& east_faces(int y) const { return rows_[slot(y)].east; }
    [[nodiscard]] const std::vector<Face>& north_faces(int y) const { return rows_[slot(y)].north; }
    [[nodiscard]] const std::vector<Slope>& slopes(int y) const { return rows_[slot(y)].slopes; }

  private:
    /// Surface and velocities within a cell, linear; slopes are over a cell.
    struct Plane {
        int x = 0;
        double level = 0.0;  ///< at the middle, m
        double level_x = 0.0;
        double level_y = 0.0;
        double u = 0.0;
        double u_x = 0.0;
        double u_y = 0.0;
        double v = 0.0;
        double v_x = 0.0;
        double v_y = 0.0;
        double bed = 0.0;
        double bed_x = 0.0;
        double bed_y = 0.0;
        double level_xx = 0.0;  ///< second differences
        double level_yy = 0.0;
        double bed_xx = 0.0;
        double bed_yy = 0.0;
    };
    /// Of a cell and those beside it: slopes over a cell, and second differences.
    struct Shape {
        double slope_x = 0.0;
        double slope_y = 0.0;
        double bend_x = 0.0;
        double bend_y = 0.0;
    };
    /// What a cell failed to deliver to those west, east, south and north of it, m.
    struct Deficit {
        int x = 0;
        std::array<double, 4> to{};
    };
    struct Row {
        std::vector<Plane> inner;  ///< the core's outermost cells, which give others theirs
        std::vector<Plane> outer;  ///< planed cells
        std::vector<Plane> cells;  ///< a shore's
        std::vector<Slope> slopes;
        std::vector<Face> east;
        std::vector<Face> north;
        std::vector<Deficit> deficits;  ///< of the stages of this step
    };
    /// A cell, possibly one beyond an edge that stands for it.
    struct CellReference {
        int x = 0;
        int y = 0;
        double sign_x = 1.0;
        double sign_y = 1.0;
        bool outside = false;
    };
    /// The water at a face, seen from one of its sides.
    struct Side {
        double depth = 0.0;
        double square = 0.0;
        double across = 0.0;
        double along = 0.0;
    };
    /// `planed`: with a plane from inside; `shore`: that, or one of the inside near such ones.
    enum Kind : std::uint8_t { full, core, planed, shore };

    static constexpr int pad = 4;
    static constexpr double dry_depth = finite_volume::dry_depth;

    [[nodiscard]] static std::size_t slot(int y) { return static_cast<std::size_t>(y + 1); }
    [[nodiscard]] CellReference at(int x, int y) const;
    [[nodiscard]] std::size_t flag_of(int x, int y) const;
    [[nodiscard]] bool is_beside_outside(int x, int y) const;
    [[nodiscard]] bool is(Kind kind, const CellReference& place) const;
    std::uint8_t* flags_of(Kind kind, int y) { return flags_[kind].data() + flag_of(0, y); }
    template <class Value>
    [[nodiscard]] Shape shape_of(const Value& value, int x, int y) const;

    void find_deep(const Water& water, const Grid& bed, WorkerPool& pool);
    void find_full(int y);
    void copy_ghost_flags(Kind kind);
    void find_core(int y);
    void find_inner(int y);
    void find_planes(int y);
    void find_shore(int y);
    void find_faces(int y);
    void add_deficits(int y, const StageOfStep& stage);
    static void merge_deficits(std::vector<Deficit>& deficits);

    [[nodiscard]] double surface(const CellReference& place) const;
    void set_bed(Plane& plane, int x, int y) const;
    [[nodiscard]] bool is_resolved(int x, int y) const;
    [[nodiscard]] Plane plane_inside(int x, int y) const;
    [[nodiscard]] Plane compute_inside(int x, int y) const;
    [[nodiscard]] static Slope slope_of(const Plane& plane);
    [[nodiscard]] bool extend(Plane& plane, int x, int y) const;
    [[nodiscard]] bool fit_own_level(Plane& plane, double depth) const;
    [[nodiscard]] Plane plane_of(const CellReference& place) const;
    [[nodiscard]] bool is_film(const CellReference& place, const Plane& own,
                               const Plane& beside) const;
    [[nodiscard]] static Side side_of(const Plane& plane, bool across_x, double sign, double bed,
                                      double bed_rise);
    [[nodiscard]] Face face_between(int x, int y, bool across_x) const;
    [[nodiscard]] Face flux(Side left, Side right) const;

    const WaterDomain& domain_;
    int nx_;
    int ny_;
    double gravity_;
    double steepest_;
    std::vector<CellReference> columns_;  // x only, from −pad on
    std::vector<CellReference> places_y_;
    std::array<std::vector<std::uint8_t>, 4> flags_;  // of each kind, with pad cells around
    std::vector<std::array<int, 2>> wet_;             // of each row: no water before, none from
    std::vector<Row> rows_;                           // from −1 on
    const Water* water_ = nullptr;                    // while it is looked at
    const Grid* bed_ = nullptr;
};

}  // namespace fumon
