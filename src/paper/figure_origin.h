#pragma once

#include <string>
#include <vector>

#include "figure/canvas/canvas.h"
#include "paper/figure_plan.h"

namespace fumon {

/// A figure's record of how it was made: everything that it was made from except the terrain files.
struct FigureOrigin {
    std::string scene;                  ///< the path of its scene
    std::vector<std::string> settings;  ///< of --set
    std::vector<SourceText> texts;      ///< of all scenes and tables that it reads
    std::vector<InputFile> inputs;      ///< terrain files
    std::string version;                ///< of the fumon that made it
    std::string defaults;  ///< of the fumon whose defaults its scenes have; empty for this one's
};

/// The texts to write into a figure: Title, Software and fumon's own (fumon:version, fumon:scene,
/// the resolved scene, and fumon:figure, all of FigureOrigin).
FigureMetadata figure_metadata(const FigurePlan& plan, const FigureSources& sources);

/// Whether a picture's metadata is that of a figure.
bool is_figure(const FigureMetadata& metadata);

/// Reads the origin back. Throws InputError where the text is damaged; `figure` names it.
FigureOrigin read_figure_origin(const FigureMetadata& metadata, const std::string& figure);

}  // namespace fumon
