#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "film/beds/film_runs.h"
#include "film/camera/bed_clock.h"
#include "film/camera/camera_path.h"
#include "film/camera/stage.h"

namespace fumon {

/// Whether the camera of a shot sees the whole block all the time, as far as its keys say: its
/// distance is "fit", and its move stays around the block.
bool fits_block(const Shot& shot);

/// The poses through which the camera of a shot goes, by its move. Throws InputError, located.
std::vector<CameraPose> poses_of(const Film& film, std::size_t shot, const FilmStage& stage,
                                 const StoredBeds& beds, const BedClock& clock);

/// A shot, ready to be drawn: which bed and which pose when.
class StagedShot {
  public:
    /// Reads the beds over which the camera passes, those of all runs. Throws InputError, located.
    StagedShot(const Film& film, std::size_t shot, const FilmStage& stage, const FilmRuns& runs);

    [[nodiscard]] std::size_t bed_at(double share) const { return clock_.bed_at(share); }
    [[nodiscard]] RecordPlace place_at(double share) const { return clock_.place_at(share); }
    /// The share of the shot, not of the way.
    [[nodiscard]] CameraPose pose_at(double share) const;
    [[nodiscard]] const BedClock& clock() const { return clock_; }
    /// One line where the shot's keys lie in the ground, or where what is written over several
    /// pictures covers the block of one that is to be seen whole; or nothing.
    [[nodiscard]] const std::string& note() const { return note_; }

  private:
    BedClock clock_;
    CameraPath path_;
    CameraSpeed speed_;
    std::string note_;
};

}  // namespace fumon
