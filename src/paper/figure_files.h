#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "outputs/output_claims.h"
#include "paper/figure_page.h"
#include "paper/figure_plan.h"

namespace fumon {

/// A figure's record of how it was made: everything that it was made from except the terrain files.
struct FigureOrigin {
    std::string scene;                  ///< the path of its scene
    std::vector<std::string> settings;  ///< of --set
    std::vector<SourceText> texts;      ///< of all scenes and tables that it reads
    std::vector<InputFile> inputs;      ///< terrain files
    std::string version;                ///< of the fumon that made it
};

/// The texts to write into a figure: Title, Software and fumon's own (fumon:version, fumon:scene,
/// the resolved scene, and fumon:figure, all of FigureOrigin).
FigureMetadata figure_metadata(const FigurePlan& plan, const FigureSources& sources);

/// Whether a picture's metadata is that of a figure.
bool is_figure(const FigureMetadata& metadata);

/// Reads the origin back. Throws InputError where the text is damaged; `figure` names it.
FigureOrigin read_figure_origin(const FigureMetadata& metadata, const std::string& figure);

/// Checks that a figure's files may be written into a folder: its data are fumon's where its PDF,
/// SVG or PNG file is. Throws as OutputClaims::check().
void claim_figure(const FigurePlan& plan, const std::filesystem::path& folder,
                  const OutputClaims& claims);

/// A file in memory.
struct WholeFile {
    std::filesystem::path path;
    std::string bytes;
};

/// Writes files so that each appears whole, and none before all are written under temporary names.
/// Throws Error.
void write_files(const std::vector<WholeFile>& files);

/// The format that a file's name asks for; throws InputError for none of pdf, svg and png.
PageFormat page_format(const std::filesystem::path& file);

/// Draws the page. Throws InputError, located, where it is too small for its panels, and what else
/// draw_page throws.
DrawnPage draw_figure(const FigurePlan& plan, const FigurePage& made, PageFormat format,
                      const FigureMetadata& metadata);

/// All files of a figure: NAME.pdf …, NAME.caption.txt and the data NAME-a-1.csv …. A warning of
/// letters that no font has goes to `notes`. Throws as draw_page.
std::vector<WholeFile> figure_files(const FigurePlan& plan, const FigureSources& sources,
                                    const FigurePage& made, const std::filesystem::path& folder,
                                    std::vector<std::string>& notes);

}  // namespace fumon
