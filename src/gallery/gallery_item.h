#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fumon {

/// A key of the scene that a picture shows.
struct GalleryParameter {
    std::string key;
    std::string value;
    std::string unit;  ///< empty: none
    std::string help;
};

/// A file of a gallery: copied, or written with a text.
struct GalleryFile {
    std::string name;              ///< in the gallery's folder "files"
    std::filesystem::path source;  ///< empty: `text` is written
    std::string text{};
    std::string description{};        ///< what a plot shows
    std::filesystem::path results{};  ///< not empty: drawn of the last record of these
};

/// What stands in a gallery under one picture.
struct GalleryItem {
    std::string name;  ///< as its file, without ending: unique in a gallery
    std::string title;
    std::string kind;                  ///< "film", "picture", "figure" or "run"
    std::string description;           ///< what the file that is shown first shows
    std::vector<std::string> caption;  ///< paragraphs
    std::vector<GalleryFile> files;    ///< the one that is shown first, if any
    std::vector<GalleryFile> plots;    ///< SVG
    std::vector<std::string> again;    ///< commands that make it again, from the gallery's folder
    std::vector<GalleryParameter> parameters;
    std::filesystem::path run;  ///< the folder of a run, or a file of results
    std::string page;           ///< among `files`: one that turns the run, where there is one
};

/// The items of what fumon made: of a run's folder (its movie or last frame, plots of its
/// measurements), of a file (PNG, JPEG, WebP, MP4, SVG, a movie with a sidecar), or of all of these
/// in a folder; and of a NetCDF file of results, another model's or fumon's (a picture that is
/// still to be drawn, what was recognised of it). Files of one kind that differ in their endings
/// alone are one item, with the PDF and the caption of a figure. Files of others are passed over in
/// folders; `faults` gets a line of each NetCDF file there that is not understood. Throws
/// InputError for a path where there is nothing that fumon made, and for a damaged file.
std::vector<GalleryItem> gallery_items(const std::vector<std::filesystem::path>& from,
                                       std::vector<std::string>& faults);

}  // namespace fumon
