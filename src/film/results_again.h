#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "run/terminal/status_line.h"
#include "scene/initial_bed.h"

namespace fumon {

/// Who asks for another model's run again.
struct ResultsAsked {
    std::filesystem::path picture;  ///< a picture or film that was made of it
    std::string_view what;          ///< "picture", "film"
    std::string from;               ///< files to take whatever they hold; empty: those of then
    int threads = 0;
    bool trust = false;               ///< without the limits on pictures of unknown origin
    std::vector<InputFile> others{};  ///< files that the picture lists besides
};

/// Opens another model's run as a picture records it: from `from`, else from where the files lay
/// when the picture was made, beside the picture, or from the working folder. No file is opened
/// before its hash is known to be one that the picture lists; and without `trust` none whose format
/// may name other files. Throws InputError where none of these places has the files as they were;
/// files given as `from`, and those of fields beside them, are taken as they are now, which the
/// status line says.
StoredBeds results_again(const RecordedResults& results, const ResultsAsked& asked,
                         StatusLine& status);

}  // namespace fumon
