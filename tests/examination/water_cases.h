#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/grid.h"
#include "examination/exact_water.h"
#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"

namespace fumon::examination {

inline constexpr int strip_rows = 4;  ///< of a case that is no square

/// A flow with a known solution, on any number of cells along x.
struct Case {
    std::string name;
    std::string title;
    double length = 0.0;  ///< m along x
    bool square = false;  ///< as many cells along y; else a strip of a few, periodic
    double west = 0.0;    ///< x of the first cell's west edge, m (of a square: y likewise)
    double duration = 0.0;
    double level = 0.0;  ///< of the water at the start, m, where it is not a dam's or a basin's
    double behind = 0.0, before = 0.0;  ///< a dam: depths at its sides at the start, m
    GullyParameters parameters;         ///< of friction, rain, edges
    /// The bed of `cells` cells along x.
    std::function<Grid(int cells, int rows)> bed;
    std::function<exact::Flow(double x, double y, double bed)> start;
    std::function<exact::Flow(double x, double y, double t)> exact;
    std::vector<double> kinks{};  ///< x where the solution is not smooth at the end, m
    double until = 1e9;           ///< x up to which it holds, m
    bool smooth = false;          ///< of second order away from kinks and shores
    bool basin = false;           ///< its water at the start differs from cell to cell
};

std::vector<Case> all_cases();

/// A case on a grid.
struct Setting {
    Grid bed;
    Water water;
    WaterDomain domain;
    GullyParameters parameters;
};
Setting setting_of(const Case& one, int cells);

/// How far water at the end is from the exact solution.
struct Errors {
    double depth = 0.0;  ///< sum of |h − exact| over the exact volume
    double away = 0.0;   ///< the same over cells more than five from shores and kinks
    double speed = 0.0;  ///< the largest error of |u|, m/s, where all is at rest
    double mass = 0.0;   ///< of the budget of water, relative
};

struct Outcome {
    Errors errors;
    double seconds = 0.0;  ///< of the processor
    long steps = 0;
};

/// What the depths of cells that a shore crosses are compared with: given at the start are those of
/// the cells' middles, which a scheme may change to means (ShallowWaterScheme::convert_to_means).
enum class DepthsAtShore { at_middles, means };
DepthsAtShore depths_of(const Case& one);

Errors errors_of(const Case& one, const Setting& setting, const Water& water, DepthsAtShore kept);

/// By fumon's finite volumes.
Outcome run_case(const Case& one, int cells, int threads);

/// Cells along x of a case that ships as a scene.
inline int cells_of_scene(const Case& one) {
    return one.square ? 50 : 100;
}
/// The scene of a case, and its bed as an ESRI ASCII grid (empty: flat), for `fumon run`.
std::string scene_of(const Case& one, int cells);
std::string bed_of(const Case& one, int cells);
/// Depth and northward velocity of the water in a basin at the start, likewise (empty: none).
std::string depth_of(const Case& one, int cells);
std::string velocity_of(const Case& one, int cells);
/// The exact depth at the end at so many points of it, as a table "x,depth", m.
std::string curve_of(const Case& one, int points);

/// By the plain scheme of first order (first_order.h).
Outcome run_plainly(const Case& one, int cells);

}  // namespace fumon::examination
