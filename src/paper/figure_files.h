#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "outputs/output_claims.h"
#include "paper/figure_origin.h"
#include "paper/figure_page.h"
#include "paper/figure_plan.h"

namespace fumon {

/// Checks that a figure's files may be written into a folder: its data are fumon's where its PDF,
/// SVG, PNG, TIFF or EPS file is. Throws as OutputClaims::check().
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

/// The format that a file's name asks for; throws InputError for none of pdf, svg, png, tif
/// and eps.
PageFormat page_format(const std::filesystem::path& file);

/// Draws the page. Throws InputError, located, where it is too small for its panels, and what else
/// draw_page throws.
DrawnPage draw_figure(const FigurePlan& plan, const FigurePage& made, PageFormat format,
                      const FigureMetadata& metadata);

/// All files of a figure: NAME.pdf …, NAME.caption.txt, .tex and .md, and the data NAME-a-1.csv ….
/// A warning of letters that no font has goes to `notes`. Throws as draw_page.
std::vector<WholeFile> figure_files(const FigurePlan& plan, const FigureSources& sources,
                                    const FigurePage& made, const std::filesystem::path& folder,
                                    std::vector<std::string>& notes);

}  // namespace fumon
