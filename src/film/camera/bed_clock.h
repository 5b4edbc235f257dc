#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "film/beds/blended_bed.h"
#include "film/beds/stored_beds.h"
#include "film/script/film.h"

namespace fumon {

/// How much one bed differs from another to the eye: the mean change of the light on it, of a sun
/// at 45° over the north-west and of 1 at most. Where both have water it is the light on the
/// water's surface, and half of the change of what water hides of the ground (d / (d + c) of a
/// depth d, c that of a closed sheet).
double visible_change(const Snapshot& one, const Snapshot& other);

/// A stored bed with all that visible_change() takes: with its water, where the run has some.
std::shared_ptr<const Snapshot> bed_as_seen(const StoredBeds& beds, std::size_t number);

/// How far apart, of so many beds in a row, those are that are read to place the camera and the
/// clock: 1, or for a draft so far that some dozens are read.
std::size_t stride_over(std::size_t beds, const Film& film);

/// Which stored bed is drawn when in a shot.
class BedClock {
  public:
    /// `path`: "shot.0", for messages. Throws InputError, located, where from or to lie outside
    /// what is stored.
    BedClock(const Film& film, std::size_t shot, const StoredBeds& beds);

    /// The number of the stored bed at a share of the shot, 0 … 1: the one nearest to what the
    /// shot's pace says.
    [[nodiscard]] std::size_t bed_at(double share) const;
    /// What is drawn at a share of the shot: that bed, or with film.between = "blend" the place
    /// between two of them that the pace says.
    [[nodiscard]] RecordPlace place_at(double share) const;

    /// The first and the last bed that it shows, in the order of the run.
    [[nodiscard]] std::size_t earliest() const;
    [[nodiscard]] std::size_t latest() const;

  private:
    [[nodiscard]] double passed_to(double share) const;
    [[nodiscard]] double value_at(double place) const;

    std::vector<double> places_;  ///< of all stored beds on the scale that passes evenly
    double begin_ = 0.0;          ///< on that scale
    double end_ = 0.0;
    bool logarithmic_ = false;
    bool eased_ = false;
    bool blends_ = false;
};

}  // namespace fumon
