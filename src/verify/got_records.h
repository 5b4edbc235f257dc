#pragma once

#include <filesystem>
#include <string>

#include "picture/baseline.h"

namespace fumon {

/// What the last results have of a case's new picture.
struct GotPicture {
    BaselineRecord record;
    std::filesystem::path file;  ///< the picture itself
};

/// SUITE/NAME-got.lock, in which results keep the record of a case's new picture.
std::filesystem::path got_record_file(const std::filesystem::path& suite_folder,
                                      const std::string& name);

/// What stands in there: whose it is, and the record as a lock has it.
std::string got_record_text(const std::filesystem::path& baseline, const std::string& name,
                            const BaselineRecord& record);

/// The new picture of a case of a baseline, as it was called, in a folder of results; the newest
/// where several suites have one. Throws InputError where there is none, or where its picture is
/// not the one that was recorded.
GotPicture find_got_picture(const std::filesystem::path& folder,
                            const std::filesystem::path& baseline, const std::string& name);

}  // namespace fumon
