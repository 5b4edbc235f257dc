#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/image.h"
#include "film/beds/film_runs.h"
#include "film/script/film_sizes.h"

namespace fumon {

/// Where the picture of a run stands in that of the film, pixels.
struct PaneBox {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// The places of several runs in a film's picture: pictures of one size, each with a strip above
/// it that holds its label. With one run it is the whole picture. A wipe and a difference have one
/// picture and one strip.
class Panes {
  public:
    /// Throws InputError, located, where there is no room, or the runs are not two for a wipe or a
    /// difference.
    Panes(const Film& film, const FilmRuns& runs, const FilmSize& size);

    /// One for each picture that is drawn: of each run, or of a wipe and a difference.
    [[nodiscard]] const std::vector<PaneBox>& boxes() const { return boxes_; }
    [[nodiscard]] FilmSize size() const { return {boxes_.front().width, boxes_.front().height}; }
    /// Of one picture.
    [[nodiscard]] double shorter_side() const {
        return std::min(boxes_.front().width, boxes_.front().height);
    }
    /// The height of the strips that hold the labels; 0 of one run.
    [[nodiscard]] double strip() const { return strip_; }
    /// The ground on which the pictures are laid, with their labels.
    [[nodiscard]] const Image& ground() const { return ground_; }
    /// One line for the user where no font has a letter; else empty.
    [[nodiscard]] const std::string& missing_letters() const { return missing_; }

  private:
    void place(const Film& film, const FilmRuns& runs, const FilmSize& size);
    void write_labels(const Film& film, const FilmRuns& runs);

    double font_;
    int strip_ = 0;
    std::vector<PaneBox> boxes_;
    Image ground_;
    std::string missing_;
};

/// How many columns a grid of so many pictures has: those whose pictures are nearest to 4 : 3, with
/// few places left empty.
int pane_columns(std::size_t count, const FilmSize& size);

/// Copies a picture into a larger one.
void copy_into(Image& whole, const Image& part, const PaneBox& box);

/// Two pictures on both sides of a line at a share of their width.
Image wiped(Image left, const Image& right, double share);

}  // namespace fumon
