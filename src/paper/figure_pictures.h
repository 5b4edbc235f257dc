#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figure/canvas/panel.h"
#include "paper/figure_page.h"
#include "paper/figure_plan.h"

namespace fumon {

/// One picture of a panel.
struct ShownPicture {
    std::unique_ptr<const PanelContent> content;
    std::string title;
    std::string data_end;  ///< of its data's file: ".asc", ".csv"; empty: none
    std::string data;
};

/// Makes the pictures of panels from the fields of their runs. Keeps one OpenGL context for all 3-D
/// views of a figure. Lives on one thread.
class FigurePictures {
  public:
    FigurePictures(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                   const FigureDrawing& drawing);
    ~FigurePictures();
    FigurePictures(const FigurePictures&) = delete;
    FigurePictures& operator=(const FigurePictures&) = delete;

    /// One for each step, or one alone for profiles and time-space diagrams; `width` is the room
    /// for a frame on the page, points. Throws InputError for a damaged file of the store and where
    /// the look does not fit the bed, Error where OpenGL fails.
    std::vector<ShownPicture> make(const PanelFeed& panel, double width);

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
