#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "film/beds/stored_beds.h"
#include "film/camera/camera_path.h"
#include "film/script/film.h"
#include "film/script/film_sizes.h"
#include "keys/override.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tile_warp.h"
#include "scene/scene.h"

namespace fumon {

/// A part of a picture, −1 … 1 from left to right and from bottom to top.
struct PictureBox {
    glm::dvec2 low;
    glm::dvec2 high;
};

/// What all frames of a film have in common: the picture's shape and the block of terrain.
struct FilmStage {
    Scene scene;  ///< the run's, with the film's size and overlays, seen in perspective
    Block block;  ///< of the run's first bed
    double aspect = 1.0;
    double overrun = 0.0;  ///< of its width, by which a bed that "fits" is wider than the picture
    std::vector<PictureBox> kept_clear{};  ///< of which a block that "fits" is seen clear
    std::vector<PictureBox> captions{};    ///< likewise, where that is possible
    bool repeats = false;  ///< whether its bed is seen to go on past its edges with its other side
    TileWarp copies{};     ///< of such a bed
};

/// The stage of a film of a run at a size, with the film's look and what `looks` change of it.
/// Throws InputError where the run's scene has no view in perspective (a section's figure), and,
/// located, where the looks do not fit the run.
FilmStage make_stage(const Film& film, const StoredBeds& beds, const FilmSize& size,
                     const std::vector<Override>& looks = {});

/// The camera of a pose: 24 mm of its film lie along the picture's shorter side.
Camera camera_of(const FilmStage& stage, const CameraPose& pose);

/// A place of a scene or film (metres or sites east and north of the south-western corner, and
/// above `bed` there) in the block's lengths.
glm::dvec3 place_on_stage(const FilmStage& stage, const std::vector<double>& place,
                          const Snapshot& bed);

/// The highest of some beds' ground at any place, in the block's lengths; far below where no bed
/// is.
class HighestGround {
  public:
    explicit HighestGround(const FilmStage& stage);
    void add(const Snapshot& bed);
    [[nodiscard]] double at(double x, double y) const;

  private:
    const FilmStage& stage_;
    Grid highest_;  ///< z
    bool goes_on_;
};

}  // namespace fumon
