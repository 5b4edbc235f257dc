#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/grid.h"
#include "render/view/block.h"
#include "run/terminal/work_options.h"
#include "web/page_run.h"

namespace fumon {

/// A bed of a page: its surface, and its colours as fumon draws them from above.
struct DrawnBed {
    std::int64_t step = 0;
    std::string label;       ///< step, time and date
    Field<float> heights;    ///< metres (or model heights) over DrawnRun::zero
    Field<float> depths;     ///< of water over it, metres; empty: none is drawn
    double reference = 0.0;  ///< the height that stands at z = 0 of the block, as `heights`
    std::string picture;     ///< WebP, north up
};

using PageColour = std::array<int, 3>;

/// The beds of a run as a page holds them.
struct DrawnRun {
    std::vector<DrawnBed> beds;
    int nx = 0;  ///< of heights: means of k × k cells where the run has too many
    int ny = 0;
    int cells_per_point = 1;
    Mask nodata;             ///< of these; empty: none
    Block block;             ///< in its lengths the page draws
    double zero = 0.0;       ///< metres (or model heights)
    WorldScale scale;        ///< of the run's cells
    double width = 0.0;      ///< metres (or sites) eastward
    double height = 0.0;     ///< and northward
    double azimuth = 215.0;  ///< where the camera stands at first, degrees
    double elevation = 32.0;
    double tangent = 0.25;  ///< of half its vertical angle of view
    double margin = 0.04;
    std::array<PageColour, 4> walls{};  ///< of the sides that face east, north, west, south
    std::array<PageColour, 4> water{};  ///< of water where they cut it
    std::string poster;                 ///< WebP: the last bed from there
    int poster_width = 0;
    int poster_height = 0;
};

/// Draws the beds of a run for a page, as a block on its table. Throws InputError where the view
/// does not fit the bed, Error where OpenGL fails.
DrawnRun drawn_run(const PageRun& run, const PageOptions& options, const WorkOptions& work);

}  // namespace fumon
