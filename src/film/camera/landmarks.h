#pragma once

#include <string>

#include "base/snapshot.h"
#include "film/camera/stage.h"

namespace fumon {

/// What a bed has at one place, in cells from its south-western corner to the cell's middle.
struct Landmark {
    double x = 0.0;
    double y = 0.0;
    double height = 0.0;   ///< model heights, of what a camera looks at
    double breadth = 0.0;  ///< cells: of the landform there
};

/// A landmark of a bed by its name in a film (subject, look_at), cells without data left out:
///
/// "middle"           the middle cell, a quarter of the bed's shorter side broad
/// "highest"          the highest cell, half way down to the bed's mean; as broad as twice the side
///                    of a square of the piece above that height
/// "lowest"           the lowest cell, an eighth of the bed's longer side broad
/// "deepest channel"  the cell whose surroundings, a square of a sixth of the longer side, are on
///                    average highest above the mean of the cells beside it, a sixteenth from the
///                    edges of a bed that is not periodic at least; an eighth of that side broad
/// "largest dune"     of those that separate_dunes() finds, the one with most sand of those that
///                    take two fifths of the bed at most, half way up; the highest where is none
/// "outlet"           where the stream that drains most leaves the bed, the first of equals; an
///                    eighth of the longer side broad
/// "flood front"      the mean place of the cells, each weighed by the fourth power of the change
/// of
///                    the water's depth across it: a front or bore; the middle without water; an
///                    eighth of the longer side broad
///
/// Of equal cells the first counts. Throws std::invalid_argument for another name.
Landmark find_landmark(const std::string& name, const Snapshot& bed);

/// The same in the block's lengths.
struct LandmarkOnStage {
    glm::dvec3 place{0.0};
    double breadth = 0.0;
};

LandmarkOnStage landmark_on_stage(const FilmStage& stage, const std::string& name,
                                  const Snapshot& bed);

}  // namespace fumon
